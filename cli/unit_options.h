/// In which lengths a job is: --scale and --unit, and what is said of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

/// What was typed takes the place of what the job file says.
/// @param scale,unit as of RunOptions. @pre not both are given.
/// @throws UsageError when there is no such unit.
void set_scale(JobFile& job, const std::optional<double>& scale, const std::string& unit);

/// On standard error; nothing where the lengths are those of the surface's file.
void tell_lengths(const JobFile& job, ProgressStyle style);

/// For programs, as `unit` and `scale`, where they are given.
void put_lengths(const JobFile& job, nlohmann::ordered_json& json);

}  // namespace tetfarm
