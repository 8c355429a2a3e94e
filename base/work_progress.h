/// How a long calculation tells what it is busy with, without knowing who listens.
///
/// A calculation gets a WorkProgress by value, counts on it where that costs next to nothing, and
/// never asks it anything: what it makes is the same whether somebody listens or not. Counts of a
/// stage that is entered again go on from where they were, so that they never run backward.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "base/work_stage.h"

namespace tetfarm {

class WorkProgress {
 public:
  using Listener = std::function<void(const WorkCount&)>;

  /// Nobody listens.
  WorkProgress() = default;
  /// The listener is called in the midst of the calculation: a few hundred times a stage at most,
  /// when `tell_every` is chosen well; what it throws ends the calculation. Copies count together.
  explicit WorkProgress(Listener listener);

  /// A stage begins, or goes on with so many more things to do (0: their number is not known).
  /// Afterwards every `tell_every`-th call of add() is told.
  void begin(WorkStage stage, std::size_t more = 0, int tell_every = 1) const {
    if (state_) enter(stage, more, tell_every);
  }

  /// Another pass of the stage begins.
  void next_pass() const {
    if (state_) count_pass();
  }

  /// So many of the stage's things are done; 0: only that the work goes on. Cost: a few
  /// instructions, but for the calls that are told.
  void add(std::size_t done = 1) const {
    if (!state_) return;
    state_->now->done += done;
    if (--state_->until_told <= 0) tell();
  }

 private:
  struct State {
    Listener listener;
    std::array<WorkCount, work_stages> counts;
    WorkCount* now = nullptr;
    int tell_every = 1;
    int until_told = 1;
  };

  void enter(WorkStage stage, std::size_t more, int tell_every) const;
  void count_pass() const;
  void tell() const;

  std::shared_ptr<State> state_;
};

}  // namespace tetfarm
