#include "worker/job_patch_sizes.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/array_index.h"
#include "base/error.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

std::string place_of_size(const JobPatch& patch) {
  return patch.typed_size.empty() ? "[patch." + patch.glob + "]"
                                  : "--patch-size '" + patch.typed_size + "'";
}

std::string size_text(double size) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", size);
  return text.data();
}

double growth_of(const JobFile& job, const JobPatch& patch) {
  return patch.growth > 0 ? patch.growth : job.growth;
}

/// "0.01, growing by 0.2".
std::string wish_text(const JobFile& job, const JobPatch& patch) {
  return size_text(patch.size) + ", growing by " + size_text(growth_of(job, patch));
}

std::vector<const JobPatch*> sizes_of_patch(const JobFile& job, const std::string& name) {
  return tables_that_match(job.patches, name, [](const JobPatch& patch) { return patch.size > 0; });
}

/// What else decides the edges there; "" of a pattern that cannot mean what the job adds.
std::string remark_on_added(const JobFile& job, const std::string& glob) {
  if (job.outer_kind != "none" && glob.starts_with("outer")) {
    return "; the edges of the outer boundary are as long as [domain] spacing (--outer-size) says";
  }
  if (job.symmetry && glob.starts_with("symmetry")) {
    return "; the edges on the plane of symmetry are as long as what is round it has them";
  }
  return {};
}

void require_match(const JobFile& job, const JobPatch& patch, std::span<const std::string> own) {
  const bool has_any = std::any_of(own.begin(), own.end(), [&patch](const std::string& name) {
    return name == patch.glob || matches_glob(patch.glob, name);
  });
  if (has_any) return;
  throw UsageError(unmatched_glob_text(patch.glob, own) + remark_on_added(job, patch.glob),
                   place_of_size(patch));
}

}  // namespace

std::vector<std::string> own_patch_names(const JobFile& job, const SurfaceMesh& checked) {
  std::vector<std::string> names = patch_names_of(checked);
  if (job.symmetry) names.resize(names.size() - std::min(added_patches(job), names.size()));
  return names;
}

void require_patch_sizes(const JobFile& job, std::span<const std::string> own) {
  for (const JobPatch& patch : job.patches) {
    if (patch.size == 0) continue;
    require_match(job, patch, own);
    if (growth_of(job, patch) <= job.growth) continue;
    throw UsageError("edges may not grow by " + size_text(patch.growth) +
                         " there, which is more than the " + size_text(job.growth) +
                         " of [spacing] growth (--growth)",
                     place_of_size(patch));
  }
  for (const std::string& name : own) {
    const std::vector<const JobPatch*> tables = sizes_of_patch(job, name);
    for (const JobPatch* table : tables) {
      const JobPatch& first = *tables.front();
      if (table->size == first.size && growth_of(job, *table) == growth_of(job, first)) continue;
      throw UsageError("edges at the patch \"" + name + "\" are to be " + wish_text(job, *table) +
                           ", and " + wish_text(job, first) + " by " + place_of_size(first) +
                           "; name it by itself to say which, [patch.\"" + name + "\"]",
                       place_of_size(*table));
    }
  }
}

std::vector<TriangleDemand> patch_demands(const JobFile& job, const SurfaceMesh& surface,
                                          std::span<const std::string> own) {
  std::vector<const JobPatch*> wish_of_patch;
  for (const std::string& name : own) {
    const std::vector<const JobPatch*> tables = sizes_of_patch(job, name);
    wish_of_patch.push_back(tables.empty() ? nullptr : tables.front());
  }
  std::vector<TriangleDemand> demands;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::size_t patch = at(patch_of(surface, t));
    const JobPatch* const wish = patch < wish_of_patch.size() ? wish_of_patch[patch] : nullptr;
    if (wish == nullptr) continue;
    const auto& [a, b, c] = surface.triangles[t];
    demands.push_back({{surface.vertices[at(a)], surface.vertices[at(b)], surface.vertices[at(c)]},
                       wish->size,
                       growth_of(job, *wish)});
  }
  return demands;
}

}  // namespace tetfarm
