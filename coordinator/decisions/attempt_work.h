/// What a running attempt is busy with, as its worker says: kept in memory, for people, and never
/// believed further than that. Nothing is decided by it.
#pragma once

#include <map>
#include <optional>

#include "base/work_stage.h"

namespace tetfarm {

class AttemptWork {
 public:
  /// `share`: how much of the task that would be, 0 to 1. Whatever comes, no number of a stage and
  /// no share ever falls, and no more is done than there is to do.
  void note(const WorkCount& said, double share);

  /// The stage that was named last; nothing before one was.
  std::optional<WorkCount> now() const;
  double share() const { return share_; }

 private:
  std::map<WorkStage, WorkCount> counts_;
  std::optional<WorkStage> stage_;
  double share_ = 0;
};

}  // namespace tetfarm
