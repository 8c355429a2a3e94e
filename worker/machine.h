/// What the machine and the batch system leave a worker: memory and time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace tetfarm {

/// Bytes: of the machine, or of the control group that this process lives in where that has less.
std::uint64_t machine_memory();

/// Of these the bytes that are free now, or would be as soon as somebody asks for them.
std::uint64_t available_memory();

std::string host_name();

/// Where a worker keeps files when nobody says where: in $TMPDIR, else /tmp, of this user alone.
std::filesystem::path default_cache_folder();

/// A variable of the environment; "" when it is not set.
using Environment = std::function<std::string(const char*)>;

/// How long a worker that starts now may run, by what the batch system tells it: TETFARM_WALLTIME
/// or PBS_WALLTIME (seconds from now), SLURM_JOB_END_TIME (seconds since 1970). 0: not known.
/// Malformed values count as not set. Unit: milliseconds.
std::int64_t walltime_left_ms(const Environment& environment, std::int64_t wall_ms);

}  // namespace tetfarm
