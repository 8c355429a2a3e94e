#include "mesh/job_file/plane_sources.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/job_file/toml_text.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 3> file_keys = {"size", "point", "line"};
constexpr std::array<std::string_view, 5> point_source_keys = {"at", "sizes", "angle", "radius",
                                                               "growth"};
constexpr std::array<std::string_view, 6> line_source_keys = {"from",  "to",     "sizes",
                                                              "angle", "radius", "growth"};

// Beyond these a metric has no digits left.
constexpr double least_length = 1e-40;
constexpr double most_length = 1e40;
constexpr double most_aspect = 1e7;
constexpr double most_growth = 100;

double length_in_range(const JobSection& section, const toml::node& node, std::string_view key) {
  const double value = section.finite(node, key);
  if (value <= 0) section.fail(node.source(), "`" + std::string(key) + "` must be positive");
  if (value < least_length || value > most_length) {
    section.fail(node.source(), "`" + std::string(key) + "` must be from 1e-40 to 1e40");
  }
  return value;
}

std::array<double, 2> place_of_key(const JobSection& section, std::string_view key) {
  const toml::array& numbers = section.array(key);
  if (numbers.size() != 2) section.fail(key, "must be two numbers, [x, y]");
  std::array<double, 2> place{};
  for (std::size_t i = 0; i < 2; ++i) {
    place[i] = section.finite(*numbers.get(i), key);
    if (std::abs(place[i]) > most_length) section.fail(key, "must be within 1e40 of 0");
  }
  return place;
}

void parse_sizes(const JobSection& section, PlaneSource& source) {
  const toml::array& sizes = section.array("sizes");
  if (sizes.size() != 2) {
    section.fail("sizes", "must be two lengths: in the direction of the angle, and across it");
  }
  for (std::size_t i = 0; i < 2; ++i) {
    source.sizes[i] = length_in_range(section, *sizes.get(i), "sizes");
  }
  const auto [least, most] = std::minmax(source.sizes[0], source.sizes[1]);
  if (most > most_aspect * least) {
    section.fail("sizes", "must not differ by more than a factor of 10000000");
  }
}

void parse_growth(const JobSection& section, PlaneSource& source) {
  if (!section.has("growth")) return;
  const toml::node& node = section.node("growth");
  if (node.value_exact<std::string>() == "off") {
    source.growth = 0;
    return;
  }
  source.growth = section.finite(node, "growth");
  if (source.growth <= 1 || source.growth > most_growth) {
    section.fail("growth", "must be more than 1 and at most 100, or \"off\"");
  }
}

PlaneSource parse_plane_source(const JobSection& top, const toml::node& node, bool is_line) {
  const JobSection section = is_line ? top.item(node, "line", line_source_keys)
                                     : top.item(node, "point", point_source_keys);
  PlaneSource source;
  source.is_line = is_line;
  source.line = section.line();
  source.from = place_of_key(section, is_line ? "from" : "at");
  source.to = is_line ? place_of_key(section, "to") : source.from;
  if (is_line && source.to == source.from) {
    section.fail("to", "is where `from` is: a source at one place is a [[point]]");
  }
  parse_sizes(section, source);
  if (section.has("angle")) source.angle_deg = section.finite(section.node("angle"), "angle");
  if (std::abs(source.angle_deg) > 360) section.fail("angle", "must be from -360 to 360 degrees");
  source.radius = length_in_range(section, section.node("radius"), "radius");
  parse_growth(section, source);
  return source;
}

}  // namespace

PlaneSources parse_plane_sources(std::string_view text, const std::string& path) {
  const toml::table table = parse_toml(text, path);
  const JobSection top(table, "", file_keys, path);
  PlaneSources all;
  if (top.has("size")) all.size = length_in_range(top, top.node("size"), "size");
  all.sources = plane_sources_of(top);
  if (all.sources.empty()) {
    throw UsageError("has no source: a source is a table [[point]] or [[line]]", path);
  }
  return all;
}

std::vector<PlaneSource> plane_sources_of(const JobSection& top) {
  struct Found {
    toml::source_position place;
    PlaneSource source;
  };
  std::vector<Found> found;
  for (const bool is_line : {false, true}) {
    const std::string key = is_line ? "line" : "point";
    if (!top.has(key)) continue;
    if (top.node(key).is_table()) top.fail(key, "must be written [[" + key + "]]");
    for (const toml::node& node : top.array(key)) {
      if (found.size() == most_plane_sources) {
        top.fail(node.source(), "more than " + std::to_string(most_plane_sources) + " sources");
      }
      found.push_back({node.source().begin, parse_plane_source(top, node, is_line)});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.place < b.place; });
  std::vector<PlaneSource> sources;
  for (const Found& one : found) sources.push_back(one.source);
  return sources;
}

std::string to_toml(const std::vector<PlaneSource>& sources) {
  const auto pair_of = [](const std::array<double, 2>& pair) {
    return "[" + toml_number(pair[0]) + ", " + toml_number(pair[1]) + "]\n";
  };
  std::string text;
  for (const PlaneSource& s : sources) {
    text += s.is_line ? "\n[[line]]\nfrom = " : "\n[[point]]\nat = ";
    text += pair_of(s.from);
    if (s.is_line) text += "to = " + pair_of(s.to);
    text += "sizes = " + pair_of(s.sizes);
    text += "angle = " + toml_number(s.angle_deg);
    text += "\nradius = " + toml_number(s.radius);
    text += "\ngrowth = " + (s.growth > 0 ? toml_number(s.growth) : "\"off\"") + "\n";
  }
  return text;
}

std::vector<std::string> plane_source_keys() {
  std::vector<std::string> all;
  for (const std::string_view key : point_source_keys) all.push_back("point." + std::string(key));
  for (const std::string_view key : line_source_keys) all.push_back("line." + std::string(key));
  return all;
}

}  // namespace tetfarm
