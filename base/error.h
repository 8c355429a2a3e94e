/// The errors that cross the border of a room as exceptions: bad input, and an outside world that
/// fails.
///
/// Each says what is wrong and where. They are caught in two places only: the task runner of the
/// worker and the request handler of the coordinator (and main, which turns them into exit codes).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetfarm {

/// The exit codes of every tetfarm program; documented in README.md.
enum class ExitCode : int {
  ok = 0,
  failed = 1,
  usage = 2,
  bad_geometry = 3,
  gate = 4,
  not_found = 5,
  out_of_resources = 6,
  stopped_at_checkpoint = 75,
};

/// Base of all errors of this project; carries the exit code that main should end with.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The geometry cannot be meshed, or a surface file cannot be read. `where` is "file:line", or
/// triangle numbers with coordinates. `triangles` lists every offending input triangle (from 0).
class InvalidInput : public Error {
 public:
  InvalidInput(const std::string& what, const std::string& where,
               std::vector<std::int64_t> triangles = {})
      : Error(ExitCode::bad_geometry, where.empty() ? what : where + ": " + what),
        triangles_(std::move(triangles)) {}
  const std::vector<std::int64_t>& triangles() const { return triangles_; }

 private:
  std::vector<std::int64_t> triangles_;
};

/// The command line or the job file is wrong; `where` is "file:line:column" or the option.
class UsageError : public Error {
 public:
  UsageError(const std::string& what, const std::string& where)
      : Error(ExitCode::usage, where.empty() ? what : where + ": " + what) {}
};

/// A system call on `path` failed with `error_number`. A full disk or quota maps to
/// out_of_resources, a missing file to not_found.
class IoError : public Error {
 public:
  IoError(const std::string& what, const std::string& path, int error_number);
  int error_number() const { return error_number_; }

 private:
  int error_number_;
};

/// Nobody answers; asking again later may help.
class NoAnswer : public Error {
 public:
  explicit NoAnswer(const std::string& what) : Error(ExitCode::not_found, what) {}
};

/// An artifact is damaged: bad magic, wrong length or wrong checksum.
class CorruptFile : public Error {
 public:
  CorruptFile(const std::string& what, const std::string& path)
      : Error(ExitCode::failed, path + ": " + what) {}
};

}  // namespace tetfarm
