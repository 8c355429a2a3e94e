#include "mesh/job_file/job_layers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "mesh/job_file/job_patches.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 16> table_keys = {
    "patches",    "first_height", "y_plus",       "reynolds", "length", "growth",
    "growth_cap", "acceleration", "total_height", "count",    "equal",  "heights",
    "room",       "step",         "fan_angle",    "elements"};
constexpr std::array<std::string_view, 6> keys_of_pml = {"patches", "layers",   "height",
                                                         "corners", "elements", "side"};
constexpr std::array<std::string_view, 2> kinds_of_elements = {"tets", "prisms"};
constexpr std::array<std::string_view, 2> pml_sides = {"outside", "inside"};
constexpr std::array<std::string_view, 2> pml_corners = {"mitre", "block"};
constexpr std::array<std::string_view, 1> heights_in_words = {"spacing"};
constexpr std::array<std::string_view, 3> rules_of_room = {"ratio", "stop", "scale"};
constexpr std::array<std::string_view, 1> counts_in_words = {"isotropic"};

/// What the keys of heights are called: --layers has short names for them.
struct HeightKeys {
  std::string_view first = "first_height";
  std::string_view total = "total_height";
};

double number_in(const JobSection& section, std::string_view key, double least, double most,
                 const char* range) {
  const double value = section.finite(section.node(key), key);
  if (value < least || value > most) section.fail(key, std::string("must be ") + range);
  return value;
}

void need(const JobSection& section, std::string_view key, std::string_view other) {
  if (section.has(key) && !section.has(other)) {
    section.fail(key, "needs `" + std::string(other) + "`");
  }
}

void exclude(const JobSection& section, std::string_view key, std::string_view other) {
  if (section.has(key) && section.has(other)) {
    section.fail(key, "cannot be given together with `" + std::string(other) + "`");
  }
}

void parse_first_height(const JobSection& section, std::string_view first, JobLayers& layers) {
  exclude(section, "y_plus", first);
  for (const std::string_view key : {"reynolds", "length"}) {
    need(section, "y_plus", key);
    need(section, key, "y_plus");
  }
  if (section.has("y_plus")) {
    layers.y_plus = number_in(section, "y_plus", 1e-3, 1e4, "from 0.001 to 10000");
    layers.reynolds = number_in(section, "reynolds", 1e3, 1e12, "from 1e3 to 1e12");
    layers.length = section.positive("length");
    return;
  }
  if (!section.has(first)) {
    section.fail(first,
                 "is missing; give it, or `y_plus` with `reynolds` and `length`, or `heights`");
  }
  layers.first_height = section.positive(first);
}

void parse_growth(const JobSection& section, JobLayers& layers) {
  if (section.has("growth")) layers.growth = number_in(section, "growth", 1, 2, "from 1 to 2");
  need(section, "growth_cap", "acceleration");
  need(section, "acceleration", "growth_cap");
  if (!section.has("growth_cap")) return;
  layers.acceleration = number_in(section, "acceleration", 1, 2, "from 1 to 2");
  layers.growth_cap =
      number_in(section, "growth_cap", layers.growth, 2, "from `growth` to 2 and not less");
}

bool grows(const JobLayers& layers) {
  return layers.growth > 1 || (layers.growth_cap > 1 && layers.acceleration > 1);
}

void parse_count(const JobSection& section, std::string_view total, JobLayers& layers) {
  exclude(section, total, "count");
  if (section.has(total)) {
    layers.total_height = section.positive(total);
    if (layers.total_height < layers.first_height) {
      section.fail(total, "must not be less than the first layer");
    }
  } else if (section.has("count") && !section.node("count").is_string()) {
    layers.count = section.integer("count", 1, most_layers_of_job);
  } else {
    if (section.has("count")) section.one_of("count", counts_in_words);
    if (!grows(layers)) {
      section.fail("growth", "is 1: no layer becomes as high as the edges; give `count` or `" +
                                 std::string(total) + "`");
    }
  }
  if (!section.has("equal")) return;
  layers.equal = section.integer("equal", 1, most_layers_of_job);
  if (layers.count > 0 && layers.equal > layers.count) {
    section.fail("equal", "must not be more than `count`");
  }
}

std::string numbered_height(std::size_t i) { return "number " + std::to_string(i + 1); }

/// What is wrong with a height of a list beside the one before, its name left out; else empty.
std::string problem_with_height(std::span<const double> heights, std::size_t i) {
  const double height = heights[i];
  if (!(height > 0 && std::isfinite(height))) return "must be positive and finite";
  if (i == 0) return {};
  const double ratio = height / heights[i - 1];
  const bool is_high = ratio > most_height_ratio_of_job;
  if (!is_high && ratio >= 1 / most_height_ratio_of_job) return {};
  return std::string("is ") + (is_high ? "more than twice " : "less than half of ") +
         numbered_height(i - 1) + "; layers may not change so fast";
}

/// A list in place of a law.
void parse_listed_heights(const JobSection& section, const HeightKeys& keys, JobLayers& layers) {
  for (const std::string_view key : {keys.first, std::string_view("y_plus"), keys.total}) {
    exclude(section, key, "heights");
  }
  for (const std::string_view key :
       {"reynolds", "length", "growth", "growth_cap", "acceleration", "count", "equal"}) {
    exclude(section, key, "heights");
  }
  const toml::array& listed = section.array("heights");
  if (listed.empty()) section.fail("heights", "must have one height at least");
  if (std::ssize(listed) > most_layers_of_job) {
    section.fail("heights", "may have at most " + std::to_string(most_layers_of_job) + " heights");
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const toml::node& node = listed[i];
    const auto refuse = [&](const std::string& why) {
      section.fail(node.source(), numbered_height(i) + " of `heights` " + why);
    };
    if (!node.is_integer() && !node.is_floating_point()) refuse("must be a number");
    layers.heights.push_back(node.value<double>().value_or(0));
    const std::string problem = problem_with_height(layers.heights, i);
    if (!problem.empty()) refuse(problem);
  }
  layers.first_height = layers.heights.front();
  layers.count = std::ssize(layers.heights);
}

void parse_heights(const JobSection& section, const HeightKeys& keys, JobLayers& layers) {
  if (section.has("heights")) {
    parse_listed_heights(section, keys, layers);
  } else {
    parse_first_height(section, keys.first, layers);
    parse_growth(section, layers);
    parse_count(section, keys.total, layers);
  }
  if (section.has("room")) layers.room = section.one_of("room", rules_of_room);
  if (section.has("step")) layers.step = section.integer("step", 1, most_layers_of_job);
  if (section.has("fan_angle")) {
    layers.fan_angle = number_in(section, "fan_angle", 30, no_fan_angle, "from 30 to 180");
  }
  if (section.has("elements")) layers.elements = section.one_of("elements", kinds_of_elements);
}

void parse_block(const JobSection& section, JobPml& pml) {
  if (section.has("layers")) pml.layers = section.integer("layers", 1, most_layers_of_job);
  if (section.has("height") && section.node("height").is_string()) {
    section.one_of("height", heights_in_words);
  } else if (section.has("height")) {
    pml.height = section.positive("height");
  }
  if (section.has("corners")) pml.corners = section.one_of("corners", pml_corners);
  if (section.has("elements")) pml.elements = section.one_of("elements", kinds_of_elements);
  if (section.has("side")) pml.side = section.one_of("side", pml_sides);
  if (pml.corners != "block") return;
  if (pml.elements == "prisms") {
    section.fail(
        "elements",
        "cannot be \"prisms\" with `corners = \"block\"`: beyond an edge, where blocks meet, "
        "prisms would have quads beside triangles; leave it out");
  }
  if (pml.side == "inside") {
    section.fail("side",
                 "cannot be \"inside\" with `corners = \"block\"`, whose blocks lie outside of the "
                 "patches; leave it out, or take `corners = \"mitre\"`");
  }
}

std::vector<std::string> parse_patches(const JobSection& section) {
  std::vector<std::string> globs;
  for (const toml::node& node : section.array("patches")) {
    const auto glob = node.value_exact<std::string>();
    const std::string problem =
        glob ? problem_with_glob(*glob, globs) : std::string("must hold strings");
    if (!problem.empty()) section.fail(node.source(), "`patches` " + problem);
  }
  if (globs.empty()) {
    section.fail("patches", "must name at least one patch; \"*\" is all of them");
  }
  return globs;
}

/// Calls add(value) with a number where the text is one.
template <class Add>
void add_value(std::string_view text, const Add& add) {
  const char* const end = text.data() + text.size();
  const auto is_all = [end](const std::from_chars_result& result) {
    return result.ec == std::errc() && result.ptr == end;
  };
  std::int64_t whole = 0;
  double number = 0;
  if (is_all(std::from_chars(text.data(), end, whole))) {
    add(whole);
  } else if (is_all(std::from_chars(text.data(), end, number))) {
    add(number);
  } else {
    add(std::string(text));
  }
}

/// What lies between the separators, empty texts too.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Of several values only `heights` has an array: those between its slashes.
void insert_value(toml::table& table, std::string_view key, std::string_view text) {
  if (key != "heights") {
    add_value(text, [&](auto value) { table.insert(key, std::move(value)); });
    return;
  }
  toml::array list;
  for (const std::string_view part : split(text, '/')) {
    add_value(part, [&list](auto value) { list.push_back(std::move(value)); });
  }
  table.insert(key, std::move(list));
}

toml::table table_of_option(std::string_view settings, const std::string& place) {
  toml::table table;
  for (const std::string_view setting : split(settings, ',')) {
    const std::size_t equals = setting.find('=');
    const std::string_view key = setting.substr(0, equals);
    if (equals == std::string_view::npos || equals + 1 == setting.size() || key.empty()) {
      throw UsageError("\"" + std::string(setting) + "\" is not KEY=VALUE", place);
    }
    if (table.contains(key)) throw UsageError("`" + std::string(key) + "` is given twice", place);
    insert_value(table, key, setting.substr(equals + 1));
  }
  return table;
}

}  // namespace

Words layers_keys() { return table_keys; }

JobLayers parse_layers(const JobSection& top, const toml::node& node) {
  const JobSection section = top.item(node, "layers", table_keys);
  JobLayers layers;
  layers.patches = parse_patches(section);
  parse_heights(section, HeightKeys(), layers);
  return layers;
}

JobLayers parse_layers_of_patch(const JobSection& patch, const std::string& glob) {
  const Words known = std::span(table_keys).subspan(1);  // no patches
  const JobSection section = patch.item(patch.node("layers"), "patch." + glob + ".layers", known);
  JobLayers layers;
  layers.patches = {glob};
  parse_heights(section, HeightKeys(), layers);
  return layers;
}

JobLayers parse_layers_option(std::string_view typed) {
  const std::string place = "--layers '" + std::string(typed) + "'";
  const std::size_t colon = typed.rfind(':');  // patches may have colons in their names
  if (colon == std::string_view::npos) {
    throw UsageError("must be PATCH,...:first=HEIGHT,...", place);
  }
  JobLayers layers;
  layers.typed = typed;
  layers.patches = globs_of_option(typed.substr(0, colon), place);
  const toml::table table = table_of_option(typed.substr(colon + 1), place);
  HeightKeys keys;
  if (!table.contains(keys.first)) keys.first = "first";
  if (!table.contains(keys.total)) keys.total = "total";
  std::vector<std::string_view> known(table_keys.begin() + 1, table_keys.end());  // no patches
  std::replace(known.begin(), known.end(), HeightKeys().first, keys.first);
  std::replace(known.begin(), known.end(), HeightKeys().total, keys.total);
  parse_heights(JobSection(table, "", known, place), keys, layers);
  return layers;
}

Words pml_keys() { return keys_of_pml; }

JobPml parse_pml(const JobSection& top, const toml::node& node) {
  const JobSection section = top.item(node, "pml", keys_of_pml);
  JobPml pml;
  pml.patches = parse_patches(section);
  parse_block(section, pml);
  return pml;
}

JobPml parse_pml_option(std::string_view typed) {
  const std::string place = "--pml '" + std::string(typed) + "'";
  const std::size_t colon = typed.rfind(':');
  const bool has_settings =
      colon != std::string_view::npos && typed.find('=', colon) != std::string_view::npos;
  const std::string_view names = has_settings ? typed.substr(0, colon) : typed;
  JobPml pml;
  pml.typed = typed;
  pml.patches = globs_of_option(names, place);
  if (!has_settings) return pml;
  const toml::table table = table_of_option(typed.substr(colon + 1), place);
  const Words known = std::span(keys_of_pml).subspan(1);  // no patches
  parse_block(JobSection(table, "", known, place), pml);
  return pml;
}

}  // namespace tetfarm
