/// The job that a command line asks for: a job file, or a surface with options; and its input
/// bytes.
#pragma once

#include <string>

#include "cli/command_line.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

struct JobInput {
  JobFile job;          ///< its surface is a plain file name: the bytes travel apart
  std::string path;     ///< of the surface
  std::string surface;  ///< the file's bytes, unpacked
};

/// As much of it as a job file may have, and a byte more where it has more. @throws IoError.
std::string text_of_job_file(const std::string& path);

/// Options win over the job file. @throws UsageError, InvalidInput, IoError.
JobInput read_job(const RunOptions& options);

/// The same without the surface's bytes, for a surface that somebody else is to read.
JobInput describe_job(const RunOptions& options);

/// What every coordinator would refuse. @throws UsageError when the job's name, which comes from
/// the surface's file, is none that a job may have, or its job file is too large.
void check_submittable(const JobInput& input);

/// Whether the surface's bytes are those of a surface, and whether it has the patches that layers
/// are to grow on. @throws InvalidInput naming the path as the user wrote it, UsageError as
/// layer_requests_of does. Cost: O(n).
void require_readable(const JobInput& input);

/// The same, and whether it can be meshed: all that `check` would refuse. @throws Error
/// (bad_geometry). Cost: as the first task of a job.
void require_meshable(const JobInput& input);

/// The same job file and the same surface have the same key, wherever they lie.
std::string key_of(const JobInput& input);

}  // namespace tetfarm
