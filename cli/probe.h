/// Looks at one thing that may be out of order, and is never kept waiting by it: a network file
/// system whose server is gone, a batch system that does not answer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "cli/findings.h"

namespace tetfarm {

struct Probe {
  std::string check;  ///< what is looked at
  std::function<Findings()> look;
  std::string remedy;  ///< of what `look` throws, where the error does not bring its own
};

/// What it finds; what it throws is a problem.
Findings looked_at(const Probe& probe);

/// The same in a process of its own, which is killed after timeout_ms: that is a problem then.
/// @pre what it does need not outlive it. @throws IoError when there is no room for a process.
Findings looked_at_within(const Probe& probe, std::int64_t timeout_ms);

}  // namespace tetfarm
