/// JobState, the part about files that were lost: their makers run again.
#include <algorithm>

#include "base/error.h"
#include "coordinator/decisions/job_state.h"

namespace tetfarm {

/// A ready task whose inputs are not all there starts to wait, and the makers of the missing ones
/// run again; a waiting task whose inputs are all there is ready.
void JobState::settle_waiting(TaskId id, Moment now) {
  TaskRow& task = durable_.tasks.at(id);
  if (task.state != TaskState::waiting && task.state != TaskState::ready) return;
  bool is_complete = true;
  for (const ArtifactRef& input : task.inputs) {
    if (has_file_(input)) continue;
    is_complete = false;
    if (task.state == TaskState::ready) {
      set_state(task, TaskState::waiting);
      record(now, task, {}, {}, "waiting", "its input '" + input.name + "' is missing or damaged");
    }
    remake(task.job, input, now);
  }
  if (is_complete && task.state == TaskState::waiting) {
    set_state(task, TaskState::ready);
    record(now, task, {}, {}, "ready", "its inputs are back");
  }
}

void JobState::wake_waiting(JobId job, Moment now) {
  for (const TaskId id : lists_.tasks_of(job)) {
    if (durable_.tasks.at(id).state == TaskState::waiting) settle_waiting(id, now);
  }
}

/// The task that made `file` runs again. It keeps its old outputs, to be compared with the new
/// ones.
void JobState::remake(JobId job, const ArtifactRef& file, Moment now) {
  const auto made_it = [&file](const ArtifactRef& output) {
    return output.hash == file.hash && output.size == file.size;
  };
  bool has_maker = false;
  for (const TaskId id : lists_.tasks_of(job)) {
    TaskRow& task = durable_.tasks.at(id);
    if (std::none_of(task.outputs.begin(), task.outputs.end(), made_it)) continue;
    has_maker = true;
    if (task.state != TaskState::done) continue;
    task.attempt = {};
    set_state(task, TaskState::ready);
    record(now, task, {}, {}, "again", "its output '" + file.name + "' is missing or damaged");
  }
  if (has_maker) return;
  fail_job(job, static_cast<int>(ExitCode::failed),
           "the input '" + file.name + "' (" + file.hash +
               ") is missing from the store or damaged; submit the job again",
           now);
}

/// A finished job whose result files are gone makes them again.
void JobState::remake_results(JobRow& job, Moment now) {
  std::vector<ArtifactRef> files;
  for (const TaskId id : lists_.tasks_of(job.id)) {
    const TaskRow& task = durable_.tasks.at(id);
    if (traits_of(task.kind).ends_job) files = task.outputs;
  }
  for (const ArtifactRef& file : files) {
    if (has_file_(file)) continue;
    set_phase(job, JobPhase::running, now);
    remake(job.id, file, now);
    return;
  }
}

}  // namespace tetfarm
