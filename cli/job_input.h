/// The job that a command line asks for: a job file, or a surface with options; and its input
/// bytes.
#pragma once

#include <string>

#include "cli/command_line.h"
#include "mesh/io/job_file.h"

namespace tetfarm {

struct JobInput {
  JobFile job;          ///< its surface is a plain file name: the bytes travel apart
  std::string path;     ///< of the surface
  std::string surface;  ///< the file's bytes, unpacked
};

/// Options win over the job file. @throws UsageError, InvalidInput, IoError.
JobInput read_job(const RunOptions& options);

/// The same without the surface's bytes, for a surface that somebody else is to read.
JobInput describe_job(const RunOptions& options);

/// The same job file and the same surface have the same key, wherever they lie.
std::string key_of(const JobInput& input);

}  // namespace tetfarm
