#include "coordinator/views/running_tasks.h"

#include <algorithm>

#include "coordinator/decisions/task_rows.h"
#include "proto/doing.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_named = 20;

const AttemptWork* work_of(const JobState& state, const TaskRow& task) {
  return task.state == TaskState::leased ? state.work_of(task.attempt) : nullptr;
}

/// Fields of the same names in two messages.
template <class Message>
void set_doing(const AttemptWork& work, Message& message) {
  const std::optional<WorkCount> now = work.now();
  if (!now) return;
  *message.mutable_doing() = doing_message(*now);
  message.set_share(work.share());
}

}  // namespace

void add_running_tasks(const JobState& state, const std::vector<const TaskRow*>& tasks, Moment now,
                       wire::JobStatus& status) {
  std::vector<const TaskRow*> running;
  double under_way = 0;
  for (const TaskRow* task : tasks) {
    if (task->state != TaskState::leased) continue;
    running.push_back(task);
    const AttemptWork* work = work_of(state, *task);
    if (work == nullptr || task->kind != TaskKind::mesh) continue;
    under_way += work->share() * told_size(*task).value_or(ToldSize{}).elements;
  }
  status.set_elements_under_way(under_way);
  std::sort(running.begin(), running.end(),
            [](const TaskRow* a, const TaskRow* b) { return a->attempt < b->attempt; });
  if (running.size() > most_named) running.resize(most_named);
  for (const TaskRow* task : running) {
    wire::RunningTask& message = *status.add_running();
    message.set_task(task->id.value);
    message.set_kind(name_of(task->kind));
    message.set_path(task->path);
    message.set_attempt(task->attempt.value);
    const auto attempt = state.durable().running_attempts.find(task->attempt);
    if (attempt != state.durable().running_attempts.end()) {
      message.set_seconds(static_cast<double>(now.wall_ms - attempt->second.started_ms) / 1000);
    }
    if (const AttemptWork* work = work_of(state, *task)) set_doing(*work, message);
  }
}

void add_doing(const JobState& state, const TaskRow& task, wire::TaskLine& line) {
  if (const AttemptWork* work = work_of(state, task)) set_doing(*work, line);
}

void add_doing(const JobState& state, const WorkerAtWork& at_work, wire::WorkerLine& line) {
  const AttemptWork* work = state.work_of(at_work.attempt);
  if (work == nullptr || !work->now()) return;
  *line.mutable_doing() = doing_message(*work->now());
}

}  // namespace tetfarm
