/// What a job says that the patches of its surface are, [patch.NAME] type, patch by patch.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/core/patch_type.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

/// The tables that --patch-type and --patch-size come to, one for each name; what they say takes
/// the place of all that the job's own tables say of the same. @throws UsageError as
/// parse_patch_type_option and parse_patch_size_option do, and when a name is typed twice.
std::vector<JobPatch> patches_of_options(std::span<const std::string> types,
                                         std::span<const std::string> sizes = {},
                                         std::vector<JobPatch> of_job = {});

/// One for each name. A patch has the type of the table with its very name; else of the patterns
/// that match it. The plane that half a body is closed with, the last patch, is symmetry where no
/// table says otherwise. Empty where the job says nothing.
/// @param names those of the surface with its outer boundary, in their order.
std::vector<PatchType> patch_types_of(const JobFile& job, std::span<const std::string> names);

/// @throws UsageError when a name or pattern matches no patch, and when patterns of different types
/// match a patch that has no table with its very name. Cost: O(patterns · patches).
void require_patch_types(const JobFile& job, std::span<const std::string> names);

}  // namespace tetfarm
