/// The edge lengths that a job wants at patches of its surface, [patch.NAME] size and growth.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// The names of the patches that the job was given, without those that it adds.
/// @param checked the surface of check_surface_of_job.
std::vector<std::string> own_patch_names(const JobFile& job, const SurfaceMesh& checked);

/// @param own own_patch_names. @throws UsageError when a name or pattern with a size matches none
/// of them, when patterns with different ones match a patch that has no table with its very name,
/// and when edges are to grow faster at a patch than anywhere. Cost: O(patterns · patches).
void require_patch_sizes(const JobFile& job, std::span<const std::string> own);

/// What the triangles of such patches ask for; a patch has the size of the table with its very
/// name, else of the patterns that match it. @param own the names of the surface's first patches.
std::vector<TriangleDemand> patch_demands(const JobFile& job, const SurfaceMesh& surface,
                                          std::span<const std::string> own);

}  // namespace tetfarm
