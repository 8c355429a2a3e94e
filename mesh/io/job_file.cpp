#include "mesh/io/job_file.h"

// Two assertions of toml++ fail for wrong input that its code then reports properly: "[=]", "a =
// [0, }".
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "base/error.h"
#include "mesh/io/edit_distance.h"

namespace tetfarm {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 12> top_keys = {
    "version", "name",      "geometry", "domain",    "region",  "spacing",
    "source",  "decompose", "mesh",     "cosmetics", "quality", "output"};
constexpr std::array<std::string_view, 1> geometry_keys = {"surface"};
constexpr std::array<std::string_view, 3> domain_keys = {"outer", "factor", "spacing"};
constexpr std::array<std::string_view, 3> region_keys = {"at", "name", "void"};
constexpr std::array<std::string_view, 3> spacing_keys = {"default", "growth", "surface"};
constexpr std::array<std::string_view, 5> point_keys = {"kind", "at", "spacing", "inner", "outer"};
constexpr std::array<std::string_view, 3> line_keys = {"kind", "from", "to"};
constexpr std::array<std::string_view, 2> triangle_keys = {"kind", "corner"};
constexpr std::array<std::string_view, 4> corner_keys = {"at", "spacing", "inner", "outer"};
constexpr std::array<std::string_view, 1> mesh_keys = {"points"};
constexpr std::array<std::string_view, 1> cosmetics_keys = {"across_cuts"};
constexpr std::array<std::string_view, 5> decompose_keys = {"subdomains", "target_elements",
                                                            "plane", "max_memory", "assimilate"};
constexpr std::array<std::string_view, 2> assimilate_keys = {"groups", "method"};
constexpr std::array<std::string_view, 1> quality_keys = {"min_dihedral"};
constexpr std::array<std::string_view, 1> output_keys = {"formats"};

constexpr std::array<std::string_view, 3> outer_kinds = {"none", "box", "sphere"};
constexpr std::array<std::string_view, 2> surface_roles = {"inherit", "ignore"};
constexpr std::array<std::string_view, 3> source_kinds = {"point", "line", "triangle"};
constexpr std::array<std::string_view, 4> kinds_of_planes = {"auto", "lattice", "axis", "inertia"};
constexpr std::array<std::string_view, 2> kinds_of_points = {"lattice", "sweeps"};
constexpr std::array<std::string_view, 3> assimilate_methods = {"recursive", "k-way",
                                                                "k-way-volume"};
constexpr std::array<std::string_view, 2> formats = {"vtkhdf", "lb8.ugrid"};

/// No tet mesh reaches the angles of the regular tet, 70.53 degrees, everywhere.
constexpr double regular_dihedral_deg = 70.5;

std::string in_ticks(std::string_view word) { return "`" + std::string(word) + "`"; }

std::string did_you_mean(std::string_view word, Words known) {
  const std::string_view nearest = nearest_word(word, known);
  return nearest.empty() ? "" : "; did you mean " + in_ticks(nearest) + "?";
}

std::string list_of(Words words) {
  std::string list;
  for (const std::string_view word : words)
    list += (list.empty() ? "\"" : ", \"") + std::string(word) + '"';
  return list;
}

std::string_view type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

/// One table of the job file with its name and the keys that it may have.
class Section {
 public:
  Section(const toml::table& table, std::string name, Words keys, const std::string& path)
      : table_(table), name_(std::move(name)), path_(path) {
    for (const auto& [key, value] : table_) {
      const std::string_view found = key.str();
      if (std::find(keys.begin(), keys.end(), found) != keys.end()) continue;
      fail(key.source(), "unknown key " + in_ticks(found) +
                             (name_.empty() ? "" : " in [" + name_ + "]") +
                             did_you_mean(found, keys));
    }
  }

  [[noreturn]] void fail(const toml::source_region& source, const std::string& what) const {
    const toml::source_position at = source.begin;
    throw UsageError(
        what, path_ + (at ? ":" + std::to_string(at.line) + ":" + std::to_string(at.column) : ""));
  }
  [[noreturn]] void fail(std::string_view key, const std::string& what) const {
    const toml::node* node = table_.get(key);
    fail((node != nullptr ? *node : table_).source(), in_ticks(key) + " " + what);
  }
  bool has(std::string_view key) const { return table_.contains(key); }
  int line() const { return static_cast<int>(table_.source().begin.line); }

  /// Fails when the key is missing.
  const toml::node& node(std::string_view key) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) fail(key, "is missing" + (name_.empty() ? "" : " in [" + name_ + "]"));
    return *node;
  }

  std::string text(std::string_view key) const {
    const auto value = node(key).value_exact<std::string>();
    if (!value) fail_type(key, "a string");
    return *value;
  }
  std::string one_of(std::string_view key, Words known) const {
    const std::string value = text(key);
    check_known(node(key), key, value, known);
    return value;
  }
  void check_known(const toml::node& at, std::string_view key, std::string_view value,
                   Words known) const {
    if (std::find(known.begin(), known.end(), value) != known.end()) return;
    fail(at.source(), in_ticks(key) + " is \"" + std::string(value) + "\", not one of " +
                          list_of(known) + did_you_mean(value, known));
  }
  bool boolean(std::string_view key) const {
    const auto value = node(key).value_exact<bool>();
    if (!value) fail_type(key, "true or false");
    return *value;
  }
  std::int64_t integer(std::string_view key, std::int64_t least) const {
    const auto value = node(key).value_exact<std::int64_t>();
    if (!value) fail_type(key, "an integer");
    if (*value < least) fail(key, "must be at least " + std::to_string(least));
    return *value;
  }
  bool yes_or_no(std::string_view key) const {
    const auto value = node(key).value_exact<bool>();
    if (!value) fail_type(key, "true or false");
    return *value;
  }
  double finite(const toml::node& at, std::string_view key) const {
    const bool is_number = at.is_integer() || at.is_floating_point();
    if (!is_number) {
      fail(at.source(), in_ticks(key) + " must be a number, not " + std::string(type_of(at)));
    }
    const double value = at.value<double>().value_or(HUGE_VAL);
    if (!std::isfinite(value)) fail(at.source(), in_ticks(key) + " must be finite");
    return value;
  }
  double positive(std::string_view key) const {
    const double value = finite(node(key), key);
    if (value <= 0) fail(key, "must be positive");
    return value;
  }
  double not_negative(std::string_view key) const {
    const double value = finite(node(key), key);
    if (value < 0) fail(key, "must not be negative");
    return value;
  }
  const toml::array& array(std::string_view key) const {
    const toml::array* value = node(key).as_array();
    if (value == nullptr) fail_type(key, "an array");
    return *value;
  }
  Section table(std::string_view key, Words keys) const {
    static const toml::table empty;
    const std::string full_name = name_.empty() ? std::string(key) : name_ + "." + std::string(key);
    const toml::node* value = table_.get(key);
    if (value == nullptr) return {empty, full_name, keys, path_};
    if (!value->is_table()) fail_type(key, "a table");
    return {*value->as_table(), full_name, keys, path_};
  }
  /// A table in an array: [[source]], or a corner.
  Section item(const toml::node& value, std::string_view key, Words keys) const {
    if (!value.is_table()) {
      fail(value.source(), in_ticks(key) + " must hold tables, not " + std::string(type_of(value)));
    }
    return {*value.as_table(), std::string(key), keys, path_};
  }

 private:
  [[noreturn]] void fail_type(std::string_view key, const std::string& wanted) const {
    fail(key, "must be " + wanted + ", not " + std::string(type_of(node(key))));
  }

  const toml::table& table_;
  std::string name_;
  const std::string& path_;
};

Vec3 parse_place(const Section& section) {
  const toml::array& at = section.array("at");
  if (at.size() != 3) section.fail("at", "must have three coordinates");
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = section.finite(at[static_cast<std::size_t>(axis)], "at");
  }
  return place;
}

JobRegion parse_region(const Section& section) {
  JobRegion region;
  region.at = parse_place(section);
  if (section.has("name")) region.name = section.text("name");
  if (section.has("void")) region.is_void = section.boolean("void");
  return region;
}

JobSource::Corner parse_corner(const Section& section) {
  JobSource::Corner corner;
  corner.at = parse_place(section);
  corner.spacing = section.positive("spacing");
  corner.inner = section.positive("inner");
  corner.outer = section.positive("outer");
  if (corner.outer < corner.inner) section.fail("outer", "must not be less than `inner`");
  return corner;
}

JobSource parse_source(const Section& top, const toml::node& node) {
  // The kind first: it decides which other keys there may be.
  std::vector<std::string_view> any_key(point_keys.begin(), point_keys.end());
  any_key.insert(any_key.end(), line_keys.begin(), line_keys.end());
  any_key.insert(any_key.end(), triangle_keys.begin(), triangle_keys.end());
  const std::string kind = top.item(node, "source", any_key).one_of("kind", source_kinds);
  const Words keys = kind == "point"  ? Words(point_keys)
                     : kind == "line" ? Words(line_keys)
                                      : Words(triangle_keys);
  const Section section = top.item(node, "source", keys);
  JobSource source;
  source.line = section.line();
  if (kind == "point") {
    source.corners = {parse_corner(section)};
  } else if (kind == "line") {
    for (const std::string_view end : {"from", "to"}) {
      section.node(end);
      source.corners.push_back(parse_corner(section.table(end, corner_keys)));
    }
  } else {
    const toml::array& corners = section.array("corner");
    if (corners.size() != 3) section.fail("corner", "must hold three tables");
    for (const toml::node& corner : corners) {
      source.corners.push_back(parse_corner(section.item(corner, "corner", corner_keys)));
    }
  }
  return source;
}

/// Each table of an array that is written [[key]]; none when there is no such array.
template <class Visit>
void for_each_table(const Section& top, std::string_view key, const Visit& visit) {
  if (!top.has(key)) return;
  if (top.node(key).is_table()) top.fail(key, "must be written [[" + std::string(key) + "]]");
  for (const toml::node& node : top.array(key)) visit(node);
}

void parse_domain(const Section& section, JobFile& job) {
  if (section.has("outer")) job.outer_kind = section.one_of("outer", outer_kinds);
  if (job.outer_kind == "none") {
    for (const std::string_view key : {"factor", "spacing"}) {
      if (section.has(key)) section.fail(key, "needs `outer` = \"box\" or \"sphere\"");
    }
    return;
  }
  job.outer_factor = section.has("factor") ? section.finite(section.node("factor"), "factor")
                                           : default_outer_factor(job.outer_kind);
  if (job.outer_factor <= 1) section.fail("factor", "must be more than 1");
  if (section.has("spacing")) job.outer_spacing = section.not_negative("spacing");
}

void parse_spacing(const Section& section, JobFile& job) {
  if (section.has("default")) job.spacing_default = section.not_negative("default");
  if (section.has("growth")) job.growth = section.positive("growth");
  if (section.has("surface")) {
    job.inherit_surface = section.one_of("surface", surface_roles) == "inherit";
  }
}

void parse_decompose(const Section& section, JobFile& job) {
  if (section.has("subdomains")) job.subdomains = section.integer("subdomains", 0);
  if (section.has("target_elements")) {
    job.target_elements = section.integer("target_elements", 1000);
  }
  if (section.has("plane")) job.plane = section.one_of("plane", kinds_of_planes);
  if (section.has("max_memory")) {
    const auto bytes = parse_memory(section.text("max_memory"));
    if (!bytes) section.fail("max_memory", "must be an amount like \"2GiB\" or \"500MB\"");
    job.max_memory_bytes = *bytes;
    for (const std::string_view key : {"subdomains", "target_elements", "assimilate"}) {
      const bool counts = section.has(key) && (key != "subdomains" || job.subdomains > 0);
      if (counts) section.fail(key, "cannot be given with `max_memory`, which decides it");
    }
  }
  if (!section.has("assimilate")) return;
  const Section assimilate = section.table("assimilate", assimilate_keys);
  job.groups = assimilate.integer("groups", 1);
  if (assimilate.has("method")) {
    job.assimilate_method = assimilate.one_of("method", assimilate_methods);
  }
  if (job.subdomains > 0 && job.subdomains < job.groups) {
    assimilate.fail("groups", "must not be more than `subdomains`, the leaves to join");
  }
}

void parse_mesh(const Section& section, JobFile& job) {
  if (section.has("points")) job.points = section.one_of("points", kinds_of_points);
}

void parse_cosmetics(const Section& section, JobFile& job) {
  if (section.has("across_cuts")) job.across_cuts = section.yes_or_no("across_cuts");
}

void parse_quality(const Section& section, JobFile& job) {
  if (!section.has("min_dihedral")) return;
  job.min_dihedral_deg = section.not_negative("min_dihedral");
  if (job.min_dihedral_deg >= regular_dihedral_deg) {
    section.fail("min_dihedral", "must be less than 70.5, the angle of the regular tetrahedron");
  }
}

void parse_output(const Section& section, JobFile& job) {
  if (!section.has("formats")) return;
  job.formats.clear();
  for (const toml::node& node : section.array("formats")) {
    const auto format = node.value_exact<std::string>();
    if (!format) section.fail(node.source(), "`formats` must hold strings");
    section.check_known(node, "formats", *format, formats);
    if (std::find(job.formats.begin(), job.formats.end(), *format) != job.formats.end()) {
      section.fail(node.source(), "`formats` has \"" + *format + "\" twice");
    }
    job.formats.push_back(*format);
  }
  if (job.formats.empty()) section.fail("formats", "must name a format");
}

/// False for the second and later bytes of a character of UTF-8.
bool starts_character(char byte) { return (byte & 0xc0) != 0x80; }

bool is_ascii(char byte) { return static_cast<unsigned char>(byte) < 0x80; }

[[noreturn]] void refuse_character(std::string_view text, std::size_t at, const std::string& where,
                                   const std::string& path) {
  const std::string_view before = text.substr(0, at);
  const std::string_view in_line = before.substr(before.rfind('\n') + 1);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto column = 1 + std::count_if(in_line.begin(), in_line.end(), starts_character);
  throw UsageError("a character that is not ASCII " + where,
                   path + ":" + std::to_string(line) + ":" + std::to_string(column));
}

/// What a backslash at `at` in a string joins to it: no letter beyond ASCII, neither at once nor
/// behind blanks and line ends.
void check_ascii_behind_backslash(std::string_view text, std::size_t at, const std::string& path) {
  const std::size_t next = text.find_first_not_of(" \t\r\n", at + 1);
  if (next != std::string_view::npos && !is_ascii(text[next])) {
    refuse_character(text, next, "behind a backslash", path);
  }
}

/// Behind the string that begins at `at`: a line's end closes it too, unless it has three quotes.
std::size_t end_of_string(std::string_view text, std::size_t at, const std::string& path) {
  const char quote = text[at];
  const std::string mark(text.substr(at, 3) == std::string(3, quote) ? 3 : 1, quote);
  for (at += mark.size(); at < text.size(); ++at) {
    if (text.substr(at, mark.size()) == mark) return at + mark.size();
    if (mark.size() == 1 && text[at] == '\n') return at;
    if (quote == '"' && text[at] == '\\') {
      check_ascii_behind_backslash(text, at, path);
      ++at;
    }
  }
  return text.size();
}

/// Letters beyond ASCII may be in strings and comments only, and not behind a backslash. toml++ 3.3
/// has undefined behaviour when it asks of another whether it is a blank.
void check_ascii_outside_strings(std::string_view text, const std::string& path) {
  std::size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at, path);
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (!is_ascii(c)) {
      refuse_character(text, at, "outside of quotes and comments", path);
    } else {
      ++at;
    }
  }
}

toml::table parse_toml(std::string_view text, const std::string& path) {
  check_ascii_outside_strings(text, path);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw UsageError(std::string(error.description()),
                     path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column));
  }
}

bool is_plain_name(const std::string& name) {
  return name != "." && name != ".." && name.find('/') == std::string::npos &&
         name.find('\0') == std::string::npos;
}

}  // namespace

double default_outer_factor(std::string_view outer_kind) {
  if (outer_kind == "box") return 3;
  return outer_kind == "sphere" ? 5 : 0;
}

JobFile parse_job_file(std::string_view text, const std::string& path) {
  namespace fs = std::filesystem;
  const toml::table table = parse_toml(text, path);
  const Section top(table, "", top_keys, path);
  if (top.has("version") && top.integer("version", 1) != 1) {
    top.fail("version", "must be 1: this Tetfarm knows no newer job file");
  }
  JobFile job;
  job.name = top.has("name") ? top.text("name") : fs::path(path).stem().string();
  if (job.name.empty()) top.fail("name", "must not be empty");
  // It names the files of the result: it must not lead them out of their folder.
  if (!is_plain_name(job.name)) top.fail("name", "must be a plain name, without `/`");
  const Section geometry = top.table("geometry", geometry_keys);
  const std::string surface = geometry.text("surface");
  if (surface.empty()) geometry.fail("surface", "must not be empty");
  job.surface = (fs::absolute(path).parent_path() / surface).lexically_normal().string();
  parse_domain(top.table("domain", domain_keys), job);
  for_each_table(top, "region", [&](const toml::node& node) {
    job.regions.push_back(parse_region(top.item(node, "region", region_keys)));
  });
  parse_spacing(top.table("spacing", spacing_keys), job);
  for_each_table(top, "source",
                 [&](const toml::node& node) { job.sources.push_back(parse_source(top, node)); });
  parse_decompose(top.table("decompose", decompose_keys), job);
  parse_mesh(top.table("mesh", mesh_keys), job);
  parse_cosmetics(top.table("cosmetics", cosmetics_keys), job);
  parse_quality(top.table("quality", quality_keys), job);
  parse_output(top.table("output", output_keys), job);
  return job;
}

std::vector<std::string> job_file_keys() {
  const std::array<std::pair<std::string_view, Words>, 14> sections = {
      {{"geometry", geometry_keys},
       {"domain", domain_keys},
       {"region", region_keys},
       {"spacing", spacing_keys},
       {"source", point_keys},
       {"source", line_keys},
       {"source", triangle_keys},
       {"source.corner", corner_keys},
       {"decompose", decompose_keys},
       {"decompose.assimilate", assimilate_keys},
       {"mesh", mesh_keys},
       {"cosmetics", cosmetics_keys},
       {"quality", quality_keys},
       {"output", output_keys}}};
  std::vector<std::string> all = {"version", "name"};
  for (const auto& [section, keys] : sections) {
    for (const std::string_view key : keys) {
      std::string full = std::string(section) + "." + std::string(key);
      if (std::find(all.begin(), all.end(), full) == all.end()) all.push_back(std::move(full));
    }
  }
  return all;
}

}  // namespace tetfarm
