/// JobState, the part about what fails again and again: errors, losses and lack of memory are
/// counted apart; tasks go into quarantine, and come out when a person says so.
#include <algorithm>

#include "base/counted.h"
#include "base/error.h"
#include "base/mebibytes.h"
#include "coordinator/decisions/job_state.h"

namespace tetfarm {
namespace {

constexpr int exit_failed = static_cast<int>(ExitCode::failed);
constexpr std::size_t most_named = 20;

/// Where a person finds the inputs of a task, relative to the store's folder.
std::string inputs_of(const TaskRow& task) {
  std::string list;
  for (const ArtifactRef& input : task.inputs) {
    if (!list.empty()) list += ", ";
    list += input.name + " artifacts/" + input.hash.substr(0, 2) + "/" + input.hash;
    if (list.size() > 500) return list + ", …";
  }
  return list;
}

std::string quarantine_reason(const TaskRow& task, const std::string& what, std::uint32_t count,
                              const std::string& message) {
  return "quarantined: " + what + " " + counted(count, "time") + "; last failure: " + message +
         "; its inputs in the store: " + inputs_of(task);
}

}  // namespace

bool was_done_before(const TaskRow& task) {
  TaskResult earlier;
  earlier.outputs = task.outputs;
  earlier.numbers = task.numbers;
  earlier.texts = task.texts;
  return !task.outputs.empty() && !traits_of(task.kind).ends_job && !problem_with(task, earlier);
}

void JobState::count_crash(TaskRow& task, WorkerId worker, const std::string& message, Moment now) {
  ++task.crashes;
  task.message = message;
  delays_.wait_until(task.id, now.steady_ms + delay_after(task.crashes, rules_.crash_delay_ms,
                                                          rules_.longest_delay_ms));
  note_crash_on_host(task, worker, message);
  if (task.crashes < rules_.max_crashes || counts_against_host(task, worker, now)) return;
  fail_task(task, exit_failed, quarantine_reason(task, "crashed", task.crashes, message), now);
}

void JobState::count_loss(TaskRow& task, const std::string& message, Moment now) {
  ++task.losses;
  task.message = message;
  delays_.wait_until(task.id, now.steady_ms + delay_after(task.losses, rules_.loss_delay_ms,
                                                          rules_.longest_delay_ms));
  if (task.losses < rules_.max_losses) return;
  fail_task(task, exit_failed, quarantine_reason(task, "lost or killed", task.losses, message),
            now);
}

/// The next try asks for twice the room, up to all that a worker has; when that was not enough,
/// none will be: the leaf is cut further, or else the task is in quarantine. What all workers have
/// is known once they had a lease to come back in after a restart.
void JobState::count_out_of_memory(TaskRow& task, std::uint64_t had_bytes,
                                   const TaskFailure& failure, Moment now) {
  ++task.oom_count;
  task.message = failure.message;
  const std::int64_t again_ms =
      now.steady_ms + delay_after(task.oom_count, rules_.loss_delay_ms, rules_.longest_delay_ms);
  delays_.wait_until(task.id, again_ms);
  const std::uint64_t largest = workers_.largest_memory();
  const std::uint64_t knew = std::max({task.memory_bytes, had_bytes, failure.peak_rss_bytes});
  if (now.steady_ms < all_back_ms_) {
    task.memory_bytes = std::max<std::uint64_t>(2 * knew, 1);
    delays_.wait_until(task.id, std::max(again_ms, all_back_ms_));
    return;
  }
  const bool had_all = largest == 0 || had_bytes >= largest;
  const std::string why_whole = why_no_further_cut(task);
  if (had_all && why_whole.empty()) {
    cut_further(task.job, task.path,
                place_of(task) + " ran out of memory with " + mebibytes(had_bytes) +
                    ", all that the largest worker has",
                largest, now);
    return;
  }
  if (had_all || task.oom_count >= rules_.max_oom_count) {
    fail_task(task, static_cast<int>(ExitCode::out_of_resources),
              quarantine_reason(task, "out of memory", task.oom_count, failure.message) +
                  "; it had " + mebibytes(had_bytes) + ", the largest worker has " +
                  mebibytes(largest) + (why_whole.empty() ? "" : ", and " + why_whole) +
                  ": cut finer (--max-memory, --subdomains), or start a larger worker and retry",
              now);
    return;
  }
  task.memory_bytes = std::min(largest, std::max<std::uint64_t>(2 * knew, 1));
}

/// The task is in quarantine until somebody says retry; the others of its job go on.
void JobState::fail_task(TaskRow& task, std::int32_t exit_code, const std::string& message,
                         Moment now) {
  revoke_attempts(task, "its task is in quarantine", now);
  task.exit_code = exit_code == 0 ? exit_failed : exit_code;
  task.message = message;
  task.attempt = {};
  set_state(task, TaskState::failed);
  record(now, task, {}, {}, "quarantined", message);
}

void JobState::fail_job(JobId id, std::int32_t exit_code, const std::string& message, Moment now) {
  JobRow& job = edit(id);
  if (job.phase != JobPhase::running) return;
  job.exit_code = exit_code;
  job.message = message;
  set_phase(job, JobPhase::failed, now);
  changes_.add({now.wall_ms, id, {}, {}, {}, "job failed", message});
}

/// A job with tasks in quarantine ends when nothing else of it can go on. What waits for a file of
/// such a task cannot.
void JobState::end_hopeless_jobs(Moment now) {
  for (const auto& [job, tasks] : lists_.failed()) {
    if (durable_.jobs.at(job).phase != JobPhase::running || lists_.is_active(job)) continue;
    const TaskRow& first = durable_.tasks.at(*tasks.begin());
    std::string message = place_of(first) + ": " + first.message;
    if (tasks.size() > 1) {
      message = std::to_string(tasks.size()) + " tasks are in quarantine: ";
      std::size_t named = 0;
      for (const TaskId id : tasks) {
        if (named++ == most_named) break;
        const TaskRow& task = durable_.tasks.at(id);
        message += (named > 1 ? "; " : "") + place_of(task) + " (task " + std::to_string(id.value) +
                   "): " + task.message;
      }
      if (tasks.size() > most_named) message += "; …";
    }
    fail_job(job, first.exit_code, message, now);
  }
}

void JobState::forgive(TaskId id) {
  TaskRow& task = edit(id);
  if (task.state == TaskState::failed && !was_done_before(task)) task.outputs.clear();
  task.crashes = 0;
  task.losses = 0;
  task.oom_count = 0;
  task.memory_bytes = 0;
  task.exit_code = 0;
  task.message.clear();
  delays_.forget(id);
  set_state(task, TaskState::ready);
}

/// What failed is tried again, with a clean record; what is done stays done.
void JobState::resume(JobRow& job, Moment now) {
  job.exit_code = 0;
  job.message.clear();
  set_phase(job, phase_to_go_on(job), now);
  changes_.add({now.wall_ms, job.id, {}, {}, {}, "resumed", ""});
  some_job_ended_ = true;  // what it waits for may have ended long ago
  for (const TaskId id : lists_.tasks_of(job.id)) {
    const TaskState state = durable_.tasks.at(id).state;
    if (state == TaskState::failed || state == TaskState::ready) forgive(id);
  }
  wake_waiting(job.id, now);
}

std::size_t JobState::retry(JobId id, TaskId task, Moment now) {
  const auto found = durable_.jobs.find(id);
  if (found == durable_.jobs.end() || found->second.phase == JobPhase::done) return 0;
  bring_back(id);
  const std::set<TaskId> quarantined = lists_.failed_of(id);
  if (!task) {
    resume(edit(id), now);
    return std::max<std::size_t>(quarantined.size(), 1);
  }
  if (!quarantined.contains(task)) return 0;
  JobRow& job = edit(id);
  job.exit_code = 0;
  job.message.clear();
  set_phase(job, phase_to_go_on(job), now);
  forgive(task);
  record(now, durable_.tasks.at(task), {}, {}, "retried");
  wake_waiting(id, now);
  return 1;
}

}  // namespace tetfarm
