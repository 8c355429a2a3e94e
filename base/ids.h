/// Identifiers that cannot be mistaken for one another or for a count, and random names.
///
/// Ids are given out by the coordinator, start at 1 and are never used again; 0 means "none".
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace tetfarm {

/// A number that names one thing of the kind `Tag`.
template <class Tag>
struct Id {
  std::uint64_t value = 0;

  explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const Id&, const Id&) = default;
};

using JobId = Id<struct JobTag>;
using TaskId = Id<struct TaskTag>;
using AttemptId = Id<struct AttemptTag>;
using WorkerId = Id<struct WorkerTag>;

/// The job's name on the wire and on the command line: "job-7".
std::string job_name(JobId id);

/// Reads what job_name wrote; an id of 0 when `text` is anything else.
JobId parse_job_name(const std::string& text);

/// `bytes` random bytes of the kernel as hexadecimal digits: for names that no other process, on
/// this host or another, may choose. Never used where output depends on it.
/// @pre bytes <= 64
/// @throws IoError when the kernel gives none.
std::string random_hex(std::size_t bytes);

}  // namespace tetfarm
