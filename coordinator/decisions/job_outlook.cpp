/// JobState, the part that says why a task does not run. It decides nothing: each reason is one of
/// those that pick_for() and suits() act upon.
#include <algorithm>
#include <map>

#include "base/counted.h"
#include "base/mebibytes.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/job_status.h"

namespace tetfarm {
namespace {

std::string seconds_text(std::int64_t ms) {
  return std::to_string(std::max<std::int64_t>(ms + 999, 0) / 1000) + " s";
}

/// "2 errors, 1 loss".
std::string failures_of(const TaskRow& task) {
  std::string text;
  const auto add = [&text](std::uint64_t count, const char* one, const char* several) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, one, several);
  };
  add(task.crashes, "error", "errors");
  add(task.losses, "loss", "losses");
  add(task.oom_count, "lack of memory", "lacks of memory");
  return text;
}

}  // namespace

/// The task that made or makes the file; 0 when none of that job does.
TaskId JobState::maker_of(JobId job, const ArtifactRef& file) const {
  for (const TaskId id : lists_.tasks_of(job)) {
    const std::vector<ArtifactRef>& outputs = durable_.tasks.at(id).outputs;
    const bool made_it =
        std::any_of(outputs.begin(), outputs.end(), [&file](const ArtifactRef& output) {
          return output.hash == file.hash && output.size == file.size;
        });
    if (made_it) return id;
  }
  return {};
}

std::vector<std::string> JobState::missing_inputs(const TaskRow& task) const {
  std::vector<std::string> missing;
  for (const ArtifactRef& input : task.inputs) {
    if (has_file_(input)) continue;
    std::string text = "its input '" + input.name + "' is not in the store, or damaged; ";
    const TaskId maker = maker_of(task.job, input);
    if (maker) {
      const TaskRow& made_by = durable_.tasks.at(maker);
      text += "task " + std::to_string(maker.value) + ", " + place_of(made_by) + ", makes it (" +
              (made_by.state == TaskState::leased ? "running" : name_of(made_by.state)) + ")";
    } else {
      text += "it came with the job: submit the job again";
    }
    missing.push_back(text);
  }
  return missing;
}

/// What keeps a ready task from every worker that is here, counted by cause.
std::vector<std::string> JobState::obstacles(const TaskRow& task, Moment now) const {
  if (workers_.all().empty()) return {"no worker is connected"};
  const WorkerSessions::HostMemory used = workers_.used_memory(durable_.running_attempts);
  std::map<std::string, int> causes;
  std::uint64_t most_free = 0;
  std::int64_t latest_end_ms = now.steady_ms;
  int suited = 0;
  for (const auto& [worker, session] : workers_.all()) {
    const std::uint64_t free_bytes = workers_.free_memory(worker, used);
    most_free = std::max(most_free, free_bytes);
    latest_end_ms = std::max(latest_end_ms, session.terms.ends_ms);
    if (durable_.quarantined_hosts.contains(session.row.host)) {
      ++causes["on a host in quarantine"];
    } else if (session.drains) {
      ++causes["about to leave"];
    } else if (!does_kind(session, task.kind)) {
      ++causes["started without --solvers"];
    } else if (memory_for(task) > free_bytes) {
      ++causes["without room for it"];
    } else if (!has_time_for(session, task, now)) {
      ++causes["with too little time left"];
    } else if (!suits(worker, task.id, free_bytes, now)) {
      ++causes["where it failed before: others may try it first"];
    } else if (session.attempt) {
      ++causes["busy"];
    } else {
      ++suited;
    }
  }
  std::vector<std::string> reasons;
  if (suited > 0) return {"a worker may take it at any moment"};
  for (const auto& [cause, count] : causes) {
    reasons.push_back(std::to_string(count) + " of " + std::to_string(workers_.all().size()) +
                      " workers: " + cause);
  }
  if (causes.contains("without room for it")) {
    reasons.push_back("it needs " + mebibytes(memory_for(task)) + "; at most " +
                      mebibytes(most_free) + " is free on any worker");
  }
  const auto too_late = causes.find("with too little time left");
  if (too_late != causes.end() && too_late->second == static_cast<int>(workers_.all().size())) {
    const auto expected_ms =
        static_cast<std::int64_t>(expectation_.seconds(task).value_or(0) * 1000);
    reasons.push_back("it is expected to take " + seconds_text(expected_ms) +
                      ", and no worker stays for longer than another " +
                      seconds_text(latest_end_ms - now.steady_ms) +
                      ": start workers with a longer --walltime");
  }
  return reasons;
}

/// Why a task could not go to any worker, however many there were; "" when it could.
std::string JobState::why_not(const TaskRow& task, Moment now) const {
  const JobRow& job = durable_.jobs.at(task.job);
  if (task.state == TaskState::failed) return "in quarantine: " + task.message;
  if (task.state == TaskState::replaced) return "no longer part of the job: " + task.message;
  if (job.phase == JobPhase::waiting) return "its job " + waiting_words(durable_, job);
  if (job.phase != JobPhase::running) return std::string("its job is ") + name_of(job.phase);
  if (const std::int64_t wait_ms = disk_pause_.wait_ms(now.steady_ms); wait_ms > 0) {
    return "no room on the disk (" + disk_pause_.message() + "); next try in " +
           seconds_text(wait_ms);
  }
  if (const std::int64_t wait_ms = delays_.wait_ms(task.id, now.steady_ms); wait_ms > 0) {
    return "after " + failures_of(task) + " it waits another " + seconds_text(wait_ms) +
           "; last failure: " + task.message;
  }
  return {};
}

/// What keeps the task from running, what decides most first.
std::vector<std::string> JobState::reasons_to_wait(const TaskRow& task, Moment now) const {
  if (task.state == TaskState::done || task.state == TaskState::leased) return {};
  std::vector<std::string> reasons;
  if (const std::string why = why_not(task, now); !why.empty()) reasons.push_back(why);
  if (task.state == TaskState::failed || task.state == TaskState::replaced) return reasons;
  const std::vector<std::string> missing = missing_inputs(task);
  reasons.insert(reasons.end(), missing.begin(), missing.end());
  if (!reasons.empty()) return reasons;
  reasons = obstacles(task, now);
  std::size_t ahead = 0;
  FairTurns turns(lists_.offers_of_users(), users_at_work());
  for (std::optional<TaskId> turn = turns.next(); turn && *turn != task.id; turn = turns.next()) {
    ++ahead;
  }
  if (ahead == 1) reasons.push_back("1 ready task comes before it");
  if (ahead > 1) reasons.push_back(std::to_string(ahead) + " ready tasks come before it");
  return reasons;
}

JobState JobState::past_job(JobId job, Moment now) const {
  JobState past(finished_->rows_of(job), rules_, has_file_, now);
  past.expectation_ = expectation_;
  return past;
}

TaskOutlook JobState::outlook(TaskId id, Moment now) const {
  const TaskRow& task = durable_.tasks.at(id);
  TaskOutlook outlook;
  outlook.expected_seconds = expectation_.seconds(task).value_or(0);
  outlook.limit_ms = limit_ms(task);
  outlook.room_bytes = memory_for(task);
  outlook.reasons = reasons_to_wait(task, now);
  if (task.kind != TaskKind::decompose) return outlook;
  const std::string further = why_cut_further(task.job, task.path);
  if (!further.empty()) outlook.reasons.push_back("it cuts further than planned: " + further);
  return outlook;
}

}  // namespace tetfarm
