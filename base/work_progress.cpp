#include "base/work_progress.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {

WorkProgress::WorkProgress(Listener listener) : state_(std::make_shared<State>()) {
  TF_CHECK(listener != nullptr);
  state_->listener = std::move(listener);
  for (std::size_t i = 0; i < work_stages; ++i) {
    state_->counts[i].stage = static_cast<WorkStage>(i);
  }
  state_->now = state_->counts.data();
}

void WorkProgress::enter(WorkStage stage, std::size_t more, int tell_every) const {
  TF_CHECK(tell_every > 0);
  WorkCount& count = state_->counts.at(static_cast<std::size_t>(stage));
  if (more > 0) count.total = std::max(count.total, count.done + more);
  state_->now = &count;
  state_->tell_every = tell_every;
  tell();
}

void WorkProgress::count_pass() const {
  ++state_->now->pass;
  tell();
}

void WorkProgress::tell() const {
  state_->until_told = state_->tell_every;
  WorkCount told = *state_->now;
  // More may turn up than was known when the stage began.
  if (told.total > 0) told.total = std::max(told.total, told.done);
  state_->listener(told);
}

}  // namespace tetfarm
