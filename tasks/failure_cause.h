/// Why an attempt at a task has failed: the one word that the worker says and the coordinator
/// decides on. What follows from each is in proto/protocol.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace tetfarm {

/// Their numbers go over the wire; that of a cause that is no more is never given again.
enum class FailureCause : std::uint32_t {
  for_good = 1,       ///< it would fail each time: the input is bad, or it is a defect of ours
  error = 2,          ///< the process ended by itself, or something around it failed
  killed = 3,         ///< ended from outside, or handed back: nobody's fault
  out_of_memory = 4,  ///< it needs more room than it had
  disk_full = 5,      ///< of the store, which all tasks share
  damaged_input = 6,  ///< inputs, which are named, were missing or damaged
};

inline constexpr std::array all_failure_causes = {
    FailureCause::for_good,      FailureCause::error,     FailureCause::killed,
    FailureCause::out_of_memory, FailureCause::disk_full, FailureCause::damaged_input};

constexpr std::uint32_t on_wire(FailureCause cause) { return static_cast<std::uint32_t>(cause); }

/// Nothing where no cause that this program knows has that number. Cost: O(1).
std::optional<FailureCause> failure_cause_on_wire(std::uint32_t number);

}  // namespace tetfarm
