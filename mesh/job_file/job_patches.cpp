#include "mesh/job_file/job_patches.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "mesh/core/patch_type.h"
#include "mesh/job_file/job_layers.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 4> keys_of_patch = {"type", "size", "growth", "layers"};

constexpr std::size_t longest_glob = 255;
constexpr std::size_t most_globs = 1000;

/// Of a table that has a type, a size or layers.
JobPatch parse_patch(const std::string& glob, const JobSection& section) {
  JobPatch patch;
  patch.glob = glob;
  const bool has_size = section.has("size");
  if (section.has("growth") && !has_size) section.fail("growth", "needs `size`");
  const bool needs_type = !has_size && !section.has("layers");
  if (section.has("type") || needs_type) patch.type = section.one_of("type", patch_type_words);
  if (has_size) patch.size = section.positive("size");
  if (section.has("growth")) patch.growth = section.positive("growth");
  return patch;
}

/// @throws UsageError where [[layers]] name the same patch, or pattern.
JobLayers own_layers(const std::string& glob, const JobSection& section,
                     const std::vector<JobLayers>& listed) {
  for (const JobLayers& other : listed) {
    if (std::find(other.patches.begin(), other.patches.end(), glob) == other.patches.end()) {
      continue;
    }
    section.fail("layers", "cannot be given: a [[layers]] has the patch \"" + glob +
                               "\" already; say its layers in one of the two");
  }
  return parse_layers_of_patch(section, glob);
}

/// All of the text.
std::optional<double> positive_number_of(std::string_view text) {
  double number = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_whole = error == std::errc() && stopped == text.data() + text.size();
  return is_whole && number > 0 && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::string all_patch_types() {
  std::string text;
  for (const std::string_view word : patch_type_words) {
    text += (text.empty() ? "" : ", ") + std::string(word);
  }
  return text;
}

}  // namespace

std::string problem_with_glob(std::string_view glob, std::vector<std::string>& globs) {
  if (glob.empty()) return "must not hold an empty name";
  if (!is_utf8(glob)) return "must hold UTF-8";
  if (glob.size() > longest_glob) return "may hold names of at most 255 bytes";
  if (globs.size() == most_globs) return "may hold at most 1000 names";
  if (std::find(globs.begin(), globs.end(), glob) != globs.end()) {
    return "has \"" + std::string(glob) + "\" twice";
  }
  globs.emplace_back(glob);
  return {};
}

std::vector<std::string> globs_of_option(std::string_view names, const std::string& place) {
  std::vector<std::string> globs;
  while (true) {
    const std::size_t end = names.find(',');
    const std::string problem = problem_with_glob(names.substr(0, end), globs);
    if (!problem.empty()) throw UsageError("the list of patches " + problem, place);
    if (end == std::string_view::npos) return globs;
    names.remove_prefix(end + 1);
  }
}

Words patch_keys() { return keys_of_patch; }

PatchTables parse_patch_tables(const JobSection& top, const std::vector<JobLayers>& layers) {
  PatchTables said;
  if (!top.has("patch")) return said;
  const toml::table* const tables = top.node("patch").as_table();
  if (tables == nullptr)
    top.fail("patch", "must be written [patch.NAME], NAME being that of a patch");
  std::vector<std::string> globs;
  for (const auto& [key, node] : *tables) {
    const std::string_view name = key.str();
    const std::string problem = problem_with_glob(name, globs);
    if (!problem.empty()) top.fail(node.source(), "`patch` " + problem);
    if (!node.is_table()) {
      top.fail(node.source(),
               "`" + std::string(name) +
                   "` must be a table of its own: [patch.NAME], NAME being that of a patch");
    }
    const JobSection section = top.item(node, "patch." + std::string(name), keys_of_patch);
    JobPatch patch = parse_patch(std::string(name), section);
    if (section.has("layers")) said.layers.push_back(own_layers(patch.glob, section, layers));
    if (!patch.type.empty() || patch.size > 0) said.patches.push_back(std::move(patch));
  }
  return said;
}

std::vector<JobPatch> parse_patch_type_option(std::string_view typed) {
  const std::string place = "--patch-type '" + std::string(typed) + "'";
  const std::size_t equals = typed.rfind('=');  // patches may have equals signs in their names
  if (equals == std::string_view::npos) throw UsageError("must be PATCH,...=TYPE", place);
  const std::string_view type = typed.substr(equals + 1);
  if (type.empty() || !patch_type_of(type)) {
    throw UsageError(
        "\"" + std::string(type) + "\" is no type of patch; they are " + all_patch_types(), place);
  }
  std::vector<JobPatch> patches;
  for (std::string& glob : globs_of_option(typed.substr(0, equals), place)) {
    patches.push_back({std::move(glob), std::string(type), std::string(typed), 0, 0, {}});
  }
  return patches;
}

std::vector<JobPatch> parse_patch_size_option(std::string_view typed) {
  const std::string place = "--patch-size '" + std::string(typed) + "'";
  const std::size_t equals = typed.rfind('=');
  if (equals == std::string_view::npos) throw UsageError("must be PATCH,...=SIZE[:GROWTH]", place);
  const std::string_view numbers = typed.substr(equals + 1);
  const std::size_t colon = numbers.find(':');
  const auto size = positive_number_of(numbers.substr(0, colon));
  if (!size) {
    throw UsageError(
        "\"" + std::string(numbers.substr(0, colon)) + "\" is no size: a number above 0", place);
  }
  std::optional<double> growth = 0;
  if (colon != std::string_view::npos) growth = positive_number_of(numbers.substr(colon + 1));
  if (!growth) {
    throw UsageError(
        "\"" + std::string(numbers.substr(colon + 1)) + "\" is no growth: a number above 0", place);
  }
  std::vector<JobPatch> patches;
  for (std::string& glob : globs_of_option(typed.substr(0, equals), place)) {
    patches.push_back({std::move(glob), {}, {}, *size, *growth, std::string(typed)});
  }
  return patches;
}

}  // namespace tetfarm
