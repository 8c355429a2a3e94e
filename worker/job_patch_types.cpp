#include "worker/job_patch_types.h"

#include <algorithm>
#include <string_view>
#include <utility>

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
  return tables_that_match(job.patches, names[patch], [&](const JobPatch& table) {
    if (table.type.empty()) return false;
    return table.glob == names[patch] || patch < names_on_offer(job, names, table.glob).size();
  });
}

/// One table for each name. @throws UsageError when it says the same thing twice.
void add_to_tables(JobPatch patch, std::vector<JobPatch>& tables) {
  const auto old = std::find_if(tables.begin(), tables.end(), [&patch](const JobPatch& table) {
    return table.glob == patch.glob;
  });
  if (old == tables.end()) {
    tables.push_back(std::move(patch));
    return;
  }
  const bool is_type = !patch.type.empty();
  if (is_type ? !old->type.empty() : old->size > 0) {
    throw UsageError("\"" + patch.glob + "\" has been given before",
                     is_type ? place_of_patch(patch) : "--patch-size '" + patch.typed_size + "'");
  }
  if (is_type) {
    old->type = std::move(patch.type);
    old->typed = std::move(patch.typed);
  } else {
    old->size = patch.size;
    old->growth = patch.growth;
    old->typed_size = std::move(patch.typed_size);
  }
}

}  // namespace

std::vector<JobPatch> patches_of_options(std::span<const std::string> types,
                                         std::span<const std::string> sizes,
                                         std::vector<JobPatch> of_job) {
  for (JobPatch& patch : of_job) {
    if (!types.empty()) patch.type.clear();
    if (!sizes.empty()) patch.size = patch.growth = 0;
  }
  std::erase_if(of_job,
                [](const JobPatch& patch) { return patch.type.empty() && patch.size == 0; });
  for (const std::string& text : types) {
    for (JobPatch& patch : parse_patch_type_option(text)) add_to_tables(std::move(patch), of_job);
  }
  for (const std::string& text : sizes) {
    for (JobPatch& patch : parse_patch_size_option(text)) add_to_tables(std::move(patch), of_job);
  }
  return of_job;
}

std::vector<PatchType> patch_types_of(const JobFile& job, std::span<const std::string> names) {
  const bool has_types = std::any_of(job.patches.begin(), job.patches.end(),
                                     [](const JobPatch& table) { return !table.type.empty(); });
  if (!has_types && !job.symmetry) return {};
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
    if (table.type.empty()) continue;
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
