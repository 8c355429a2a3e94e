#include "worker/patch_globs.h"

#include <algorithm>

#include "base/edit_distance.h"
#include "mesh/formats/patch_names.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_named = 10;

std::string quoted_name(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace

std::string patches_text(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) {
    text += (i == 0 ? "" : ", ") + quoted_name(names[i]);
  }
  if (names.size() > most_named)
    text += " and " + std::to_string(names.size() - most_named) + " more";
  return text;
}

bool matches_glob(std::string_view glob, std::string_view text) {
  const auto next_letter = [text](std::size_t at) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
    return at;
  };
  std::size_t at = 0;
  std::size_t in_glob = 0;
  std::size_t star = std::string_view::npos;  // the last one passed
  std::size_t after_star = 0;                 // where in the text what follows it was tried last
  while (at < text.size()) {
    const bool has_more = in_glob < glob.size();
    if (has_more && glob[in_glob] == '*') {
      star = in_glob++;
      after_star = at;
    } else if (has_more && glob[in_glob] == '?') {
      at = next_letter(at);
      ++in_glob;
    } else if (has_more && glob[in_glob] == text[at]) {
      ++at;
      ++in_glob;
    } else if (star != std::string_view::npos) {
      in_glob = star + 1;
      at = after_star = next_letter(after_star);
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', in_glob) == std::string_view::npos;
}

std::vector<std::string> patch_names_of(const SurfaceMesh& surface) {
  if (!surface.patch_of_triangle.empty()) return surface.patch_names;
  return {std::string(unnamed_patch)};
}

std::size_t added_patches(const JobFile& job) {
  return (job.outer_kind != "none" ? 1U : 0U) + (job.symmetry ? 1U : 0U);
}

std::vector<const JobPatch*> tables_that_match(const std::vector<JobPatch>& tables,
                                               std::string_view name,
                                               const std::function<bool(const JobPatch&)>& counts) {
  std::vector<const JobPatch*> matching;
  for (const JobPatch& table : tables) {
    if (!counts(table)) continue;
    if (table.glob == name) return {&table};
    if (matches_glob(table.glob, name)) matching.push_back(&table);
  }
  return matching;
}

std::span<const std::string> names_on_offer(const JobFile& job, std::span<const std::string> all,
                                            std::string_view glob) {
  const std::size_t added = added_patches(job);
  const bool is_for_added =
      glob.starts_with("outer") || (job.symmetry && glob.starts_with("symmetry"));
  return all.first(all.size() - (is_for_added ? 0 : std::min(added, all.size())));
}

std::string unmatched_glob_text(std::string_view glob, std::span<const std::string> names) {
  const std::vector<std::string_view> words(names.begin(), names.end());
  const std::string_view nearest = nearest_word(glob, words);
  const std::string text = names.size() == 1
                               ? "no patch: the surface has only " + quoted_name(names.front()) +
                                     ", and \"*\" is all of it"
                               : "none of the patches " + patches_text(names);
  return quoted_name(glob) + " matches " + text +
         (nearest.empty() ? "" : "; did you mean " + quoted_name(nearest) + "?");
}

}  // namespace tetfarm
