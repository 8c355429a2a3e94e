#include "tasks/failure_cause.h"

#include <algorithm>

namespace tetfarm {

std::optional<FailureCause> failure_cause_on_wire(std::uint32_t number) {
  const auto found =
      std::find_if(all_failure_causes.begin(), all_failure_causes.end(),
                   [number](FailureCause cause) { return on_wire(cause) == number; });
  return found == all_failure_causes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace tetfarm
