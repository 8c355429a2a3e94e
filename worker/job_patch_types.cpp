#include "worker/job_patch_types.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

std::string place_of_patch(const JobPatch& patch) {
  return patch.typed.empty() ? "[patch." + patch.glob + "]" : "--patch-type '" + patch.typed + "'";
}

/// Which of the job's tables say what a patch is: the one with its very name, else all that match.
std::vector<const JobPatch*> tables_of(const JobFile& job, std::span<const std::string> names,
                                       std::size_t patch) {
  std::vector<const JobPatch*> tables;
  for (const JobPatch& table : job.patches) {
    if (table.glob == names[patch]) return {&table};
    const bool is_on_offer = patch < names_on_offer(job, names, table.glob).size();
    if (is_on_offer && matches_glob(table.glob, names[patch])) tables.push_back(&table);
  }
  return tables;
}

}  // namespace

std::vector<PatchType> patch_types_of(const JobFile& job, std::span<const std::string> names) {
  if (job.patches.empty() && !job.symmetry) return {};
  std::vector<PatchType> types;
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    const std::vector<const JobPatch*> tables = tables_of(job, names, patch);
    const bool is_plane = job.symmetry && patch + 1 == names.size();
    if (tables.empty() && is_plane) {
      types.push_back(PatchType::symmetry);
      continue;
    }
    types.push_back(tables.empty()
                        ? PatchType::unspecified
                        : patch_type_of(tables.front()->type).value_or(PatchType::unspecified));
  }
  return types;
}

void require_patch_types(const JobFile& job, std::span<const std::string> names) {
  if (job.patches.empty()) return;
  for (const JobPatch& table : job.patches) {
    const std::span<const std::string> offered = names_on_offer(job, names, table.glob);
    const bool has_any = std::any_of(names.begin(), names.end(),
                                     [&](const std::string& name) { return name == table.glob; }) ||
                         std::any_of(offered.begin(), offered.end(), [&](const std::string& name) {
                           return matches_glob(table.glob, name);
                         });
    if (!has_any) throw UsageError(unmatched_glob_text(table.glob, offered), place_of_patch(table));
  }
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    const std::vector<const JobPatch*> tables = tables_of(job, names, patch);
    for (const JobPatch* table : tables) {
      if (table->type == tables.front()->type) continue;
      throw UsageError("the patch \"" + names[patch] + "\" is to be `" + table->type + "`, and `" +
                           tables.front()->type + "` by " + place_of_patch(*tables.front()) +
                           "; name it by itself to say which, [patch.\"" + names[patch] + "\"]",
                       place_of_patch(*table));
    }
  }
}

}  // namespace tetfarm
