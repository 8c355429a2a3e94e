/// JobState, the part about jobs that wait for other jobs. Those have lower ids, so that no circle
/// can come about, and one pass by rising id settles whole chains.
#include <algorithm>
#include <utility>

#include "base/check.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/job_status.h"

namespace tetfarm {

/// The first that is unknown here, or has ended otherwise than well; 0: there is none.
JobId JobState::unmet_of(const std::vector<JobId>& after) const {
  for (const JobId id : after) {
    const auto found = durable_.jobs.find(id);
    if (found == durable_.jobs.end()) return id;
    if (is_end(found->second.phase) && found->second.phase != JobPhase::done) return id;
  }
  return {};
}

/// Of a job that is to go on.
JobPhase JobState::phase_to_go_on(const JobRow& job) const {
  return waits_for(durable_, job).empty() ? JobPhase::running : JobPhase::waiting;
}

void JobState::settle_waiting_jobs(Moment now) {
  if (!std::exchange(some_job_ended_, false)) return;
  const std::set<JobId> waiting = waiting_jobs_;
  for (const JobId id : waiting) {
    const JobRow& job = durable_.jobs.at(id);
    TF_CHECK(job.phase == JobPhase::waiting);
    if (const JobId unmet = unmet_of(job.after)) {
      end_with(edit(id), durable_.jobs.at(unmet), now);
    } else if (waits_for(durable_, job).empty()) {
      begin(edit(id), now);
    }
  }
  // Those that ended just now were waited for by later ones only, which have had their look.
  some_job_ended_ = false;
}

/// All that the job waited for is done. Its first task may have been done for another meanwhile.
void JobState::begin(JobRow& job, Moment now) {
  set_phase(job, JobPhase::running, now);
  changes_.add({now.wall_ms, job.id, {}, {}, {}, "begun", "what it waited for is done"});
  for (const TaskId id : lists_.tasks_of(job.id)) {
    TaskRow& task = durable_.tasks.at(id);
    if (task.state != TaskState::ready || !is_served(task)) continue;
    set_state(task, TaskState::done);
    record(now, task, {}, {}, "served", "as an earlier job has done it");
    advance(task, now);
  }
  wake_waiting(job.id, now);
}

/// What the job waited for has failed or was cancelled, and so is the job.
void JobState::end_with(JobRow& job, const JobRow& other, Moment now) {
  const bool has_failed = other.phase == JobPhase::failed;
  job.exit_code = has_failed ? other.exit_code : 0;
  job.message = "it waited for " + job_words(other) + ", which " +
                (has_failed ? "failed" : "was cancelled") + "; when that goes on, retry this one";
  set_phase(job, other.phase, now);
  changes_.add(
      {now.wall_ms, job.id, {}, {}, {}, has_failed ? "job failed" : "cancelled", job.message});
}

JobId JobState::unmet_by(JobId job) const {
  const auto found = durable_.jobs.find(job);
  if (found == durable_.jobs.end() || found->second.phase == JobPhase::done) return {};
  return unmet_of(found->second.after);
}

}  // namespace tetfarm
