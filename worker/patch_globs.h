/// The patches of a surface by the names and patterns that a job file or a command line has for
/// them.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

/// "\"wing\", \"tip\" and 3 more": the first ten.
std::string patches_text(std::span<const std::string> names);

/// Whether all of `text` is like `glob`, in which * stands for any text and ? for any letter of
/// UTF-8. Cost: O(|glob| |text|).
bool matches_glob(std::string_view glob, std::string_view text);

/// A surface without patches has one, which is called "surface".
std::vector<std::string> patch_names_of(const SurfaceMesh& surface);

/// How many patches the job adds behind those of its surface: an outer boundary, then the plane
/// that it closes half a body with.
std::size_t added_patches(const JobFile& job);

/// Of the tables that count, the one with the patch's very name, else all whose patterns match it.
std::vector<const JobPatch*> tables_that_match(const std::vector<JobPatch>& tables,
                                               std::string_view name,
                                               const std::function<bool(const JobPatch&)>& counts);

/// The names that a pattern may match: the outer boundary that the job puts round a body is not
/// matched but by patterns that begin with "outer", nor the plane that it closes half a body with
/// but by those and by patterns that begin with "symmetry". @pre all of the names are of a surface
/// with the job's outer boundary.
std::span<const std::string> names_on_offer(const JobFile& job, std::span<const std::string> all,
                                            std::string_view glob);

/// What to say of a pattern that matches none of `names`, with the one that it is most like.
std::string unmatched_glob_text(std::string_view glob, std::span<const std::string> names);

}  // namespace tetfarm
