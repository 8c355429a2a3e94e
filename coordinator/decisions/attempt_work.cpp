#include "coordinator/decisions/attempt_work.h"

#include <algorithm>

namespace tetfarm {

void AttemptWork::note(const WorkCount& said, double share) {
  WorkCount& known = counts_[said.stage];
  known.stage = said.stage;
  known.pass = std::max(known.pass, said.pass);
  known.done = std::max(known.done, said.done);
  known.total = std::max(known.total, said.total);
  if (known.total > 0) known.total = std::max(known.total, known.done);
  stage_ = said.stage;
  if (share > share_) share_ = std::min(share, 1.0);
}

std::optional<WorkCount> AttemptWork::now() const {
  if (!stage_) return std::nullopt;
  return counts_.at(*stage_);
}

}  // namespace tetfarm
