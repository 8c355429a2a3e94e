// Those who want meshes, and the person who looks after the farm: they submit until they are
// answered, change their minds, say retry, drain workers and let hosts go.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/coordinator/simulated_world.h"

namespace tetfarm::simulation {

/// What the text of such a job says.
inline constexpr const char* keeps_all_text = "keep = all";

/// What is to be done. Meshing the sub-domain `hopeless` (0: none) always fails. No worker has the
/// memory for tasks of the kind `giant_kind` on the sub-domain `giant` (0: none).
struct Wish {
  std::vector<ArtifactRef> jobs;
  bool first_keeps_all = false;  ///< files between its tasks; the others keep what is needed
  std::uint64_t hopeless = 0;
  std::uint64_t giant = 0;
  TaskKind giant_kind = TaskKind::mesh;
  bool second_waits = false;   ///< for the first
  bool several_users = false;  ///< each job is another one's
};

inline bool is_hopeless(const Wish& wish, const TaskRow& task) {
  return task.kind == TaskKind::mesh && task.path == wish.hopeless;
}

inline bool is_giant(const Wish& wish, const TaskRow& task) {
  return wish.giant != 0 && task.kind == wish.giant_kind && task.path == wish.giant;
}

/// Nobody can do anything about it: its sub-domain cannot be made smaller either.
inline bool is_in_vain(const Wish& wish, const TaskRow& task) {
  return is_hopeless(wish, task) ||
         (is_giant(wish, task) && task.message.find("cannot be cut") != std::string::npos);
}

class Clients {
 public:
  using Say = std::function<void(ToCoordinator)>;

  /// What is referred to must outlive it. `committed`: what status tells.
  Clients(Random& random, const Trouble& trouble, const std::vector<Submission>& jobs,
          const Wish& wish, const DurableState& committed, Say say)
      : random_(random),
        trouble_(trouble),
        jobs_(jobs),
        wish_(wish),
        committed_(committed),
        say_(std::move(say)) {}

  std::int64_t wake_ms() const { return wake_ms_; }

  /// Every job is done, or failed for nothing but what always fails.
  bool are_content() const {
    return std::all_of(jobs_.begin(), jobs_.end(), [this](const Submission& submission) {
      const JobRow* job = job_of(submission);
      if (job == nullptr) return false;
      return job->phase == JobPhase::done ||
             (job->phase == JobPhase::failed && is_as_good_as_it_gets(job->id));
    });
  }

  void act(std::int64_t now_ms, bool hosts_are_good, WorkerId some_worker) {
    if (now_ms < wake_ms_) return;
    if (begin_ms_ == 0) begin_ms_ = now_ms;
    wake_ms_ = now_ms + 100 + random_.pick(400);
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const bool is_time = i == 0 || now_ms > begin_ms_ + 2000;
      if (is_time) look_after(static_cast<int>(i));
    }
    for (const auto& [host, row] : committed_.quarantined_hosts) {
      if (hosts_are_good) say_(LetGoSaid{host});
    }
    if (random_.chance(trouble_.whim)) say_(DrainSaid{some_worker});
  }

 private:
  void look_after(int number) {
    const JobRow* job = job_of(jobs_[static_cast<std::size_t>(number)]);
    const bool wants_it_again = random_.chance(trouble_.whim);
    if (job == nullptr || job->phase == JobPhase::cancelled || wants_it_again) {
      say_(SubmitSaid{number});
    } else if (job->phase == JobPhase::failed && !is_as_good_as_it_gets(job->id)) {
      say_(RetrySaid{job->id, {}});
    } else if (job->phase == JobPhase::running && random_.chance(trouble_.whim)) {
      say_(CancelSaid{job->id});
    }
  }

  const JobRow* job_of(const Submission& submission) const {
    const auto found = std::find_if(
        committed_.jobs.begin(), committed_.jobs.end(),
        [&submission](const auto& entry) { return entry.second.key == submission.key; });
    return found == committed_.jobs.end() ? nullptr : &found->second;
  }

  bool is_as_good_as_it_gets(JobId job) const {
    if (committed_.jobs.at(job).message.starts_with("it waited for")) return false;
    return std::all_of(committed_.tasks.begin(), committed_.tasks.end(), [&](const auto& entry) {
      const TaskRow& task = entry.second;
      return task.job != job || task.state != TaskState::failed || is_in_vain(wish_, task);
    });
  }

  Random& random_;
  const Trouble& trouble_;
  const std::vector<Submission>& jobs_;
  const Wish& wish_;
  const DurableState& committed_;
  Say say_;
  std::int64_t begin_ms_ = 0;
  std::int64_t wake_ms_ = 0;
};

}  // namespace tetfarm::simulation
