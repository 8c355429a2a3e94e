/// JobState, the part about jobs that are forgotten with age.
#include "base/check.h"
#include "coordinator/decisions/job_state.h"

namespace tetfarm {

/// Whether nothing of the job is going on, or to be told, and it ended that long ago. The wall
/// clock decides, as days pass while nobody runs.
bool JobState::has_aged(const JobRow& job, std::int64_t keep_ms, Moment now) const {
  return is_end(job.phase) && !is_at_hand(job.id) && finished_->contains(job.id) &&
         !(job.end_untold && rules_.tells_ends) && job.finished_ms <= now.wall_ms - keep_ms;
}

JobId JobState::remove_old_job(std::int64_t keep_ms, Moment now) {
  TF_CHECK(keep_ms > 0);
  // Those for which a later one waits, or would when it is retried. Jobs wait for lower ids.
  std::set<JobId> awaited;
  JobId found;
  for (auto next = durable_.jobs.rbegin(); next != durable_.jobs.rend(); ++next) {
    const JobRow& job = next->second;
    if (has_aged(job, keep_ms, now) && !awaited.contains(job.id)) found = job.id;
    if (found) break;  // it goes before those that it waited for
    if (job.phase != JobPhase::done) awaited.insert(job.after.begin(), job.after.end());
  }
  if (!found) return {};
  const JobRow& job = durable_.jobs.at(found);
  changes_.add({now.wall_ms, found, {}, {}, {}, "removed", job.name + ", which ended long ago"});
  if (const auto key = keys_.find({job.owner, job.key});
      key != keys_.end() && key->second == found) {
    keys_.erase(key);
  }
  untold_ends_.erase(found);
  durable_.jobs.erase(found);
  changes_.remove(found);
  return found;
}

}  // namespace tetfarm
