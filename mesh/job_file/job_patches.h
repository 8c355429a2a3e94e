/// What a job says of its patches by name: the names in its tables, and the tables [patch.NAME].
/// --patch-type and --patch-size of the command line say the same in one word each
/// (parse_patch_type_option, parse_patch_size_option).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_section.h"

namespace tetfarm {

/// Takes one more name or pattern; otherwise tells what is wrong with it, which goes behind what
/// holds it: "must not hold an empty name".
std::string problem_with_glob(std::string_view glob, std::vector<std::string>& globs);

/// The names between commas. @throws UsageError at `place`.
std::vector<std::string> globs_of_option(std::string_view names, const std::string& place);

/// Every key of a table [patch.NAME].
Words patch_keys();

/// What tables [patch.NAME] say.
struct PatchTables {
  std::vector<JobPatch> patches;  ///< those with a type or a size
  std::vector<JobLayers> layers;  ///< of each that has any, as a [[layers]] of that patch
};

/// The tables [patch.NAME] of a job, by name.
/// @param layers those of [[layers]]
/// @throws UsageError as JobSection does, and where a patch of one of these has layers of its own.
PatchTables parse_patch_tables(const JobSection& top, const std::vector<JobLayers>& layers);

}  // namespace tetfarm
