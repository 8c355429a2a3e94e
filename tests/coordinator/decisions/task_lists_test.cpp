#include "coordinator/decisions/task_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr JobId wing{1};
constexpr JobId flange{2};

TaskRow task_of(std::uint64_t number, JobId job, TaskKind kind, TaskState state) {
  TaskRow task;
  task.id = TaskId{number};
  task.job = job;
  task.kind = kind;
  task.path = number;
  task.state = state;
  return task;
}

JobRow running(JobId id, int priority = 0) {
  JobRow job;
  job.id = id;
  job.priority = priority;
  return job;
}

JobRow ended(JobId id) {
  JobRow job = running(id);
  job.phase = JobPhase::done;
  return job;
}

std::map<JobId, JobRow> running_jobs() {
  return {{wing, running(wing)}, {flange, running(flange)}};
}

std::vector<TaskId> in_order(const TaskLists& lists) {
  std::vector<TaskId> order;
  for (const auto& [priority, rank, task] : lists.offers()) order.push_back(task);
  return order;
}

TEST(TaskLists, cuts_and_what_others_wait_for_are_handed_out_first_then_the_older_ones) {
  TaskLists lists;
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::ready), running(wing));
  lists.update(task_of(2, wing, TaskKind::cosmetic, TaskState::ready), running(wing));
  lists.update(task_of(3, wing, TaskKind::write, TaskState::ready), running(wing));
  lists.update(task_of(4, wing, TaskKind::decompose, TaskState::ready), running(wing));
  EXPECT_THAT(in_order(lists), ElementsAre(TaskId{2}, TaskId{4}, TaskId{1}, TaskId{3}));
}

TEST(TaskLists, tasks_of_the_job_with_the_higher_priority_come_first_whatever_their_kind) {
  TaskLists lists;
  std::map<TaskId, TaskRow> tasks;
  JobRow urgent = running(flange, 5);
  const auto add = [&](std::uint64_t number, const JobRow& job, TaskKind kind, TaskState state) {
    const TaskRow task = task_of(number, job.id, kind, state);
    tasks.emplace(task.id, task);
    lists.place(task);
    lists.update(task, job);
  };
  add(1, running(wing), TaskKind::decompose, TaskState::ready);
  add(2, urgent, TaskKind::write, TaskState::ready);
  add(3, urgent, TaskKind::decompose, TaskState::ready);
  add(4, urgent, TaskKind::mesh, TaskState::leased);
  EXPECT_THAT(in_order(lists), ElementsAre(TaskId{3}, TaskId{2}, TaskId{1}));
  lists.move(tasks, urgent, -5);
  EXPECT_EQ(urgent.priority, -5);
  EXPECT_THAT(in_order(lists), ElementsAre(TaskId{1}, TaskId{3}, TaskId{2}));
  EXPECT_THAT(lists.validate(tasks, {{wing, running(wing)}, {flange, urgent}}), IsEmpty());
  EXPECT_THAT(lists.validate(tasks, running_jobs()), SizeIs(2)) << "by another priority";
}

TEST(TaskLists, what_is_not_ready_or_of_a_job_that_does_not_run_is_not_on_offer) {
  TaskLists lists;
  const TaskRow ready = task_of(1, wing, TaskKind::mesh, TaskState::ready);
  lists.update(ready, running(wing));
  EXPECT_THAT(lists.offers(), SizeIs(1));
  lists.update(ready, ended(wing));
  EXPECT_THAT(lists.offers(), IsEmpty());
  lists.update(ready, running(wing));
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::leased), running(wing));
  EXPECT_THAT(lists.offers(), IsEmpty());
}

TEST(TaskLists, a_job_is_active_while_a_task_is_ready_or_runs) {
  TaskLists lists;
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::leased), running(wing));
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::ready), running(wing));
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::done), running(wing));
  EXPECT_TRUE(lists.is_active(wing));
  EXPECT_FALSE(lists.is_active(flange));
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::failed), running(wing));
  EXPECT_FALSE(lists.is_active(wing));
  EXPECT_THAT(lists.failed_of(wing), ElementsAre(TaskId{2}));
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::ready), running(wing));
  EXPECT_THAT(lists.failed(), IsEmpty());
}

TEST(TaskLists, a_place_belongs_to_one_task) {
  TaskLists lists;
  const TaskRow mesh = task_of(5, wing, TaskKind::mesh, TaskState::ready);
  lists.place(mesh);
  EXPECT_EQ(lists.find(wing, TaskKind::mesh, 5), TaskId{5});
  EXPECT_FALSE(lists.find(flange, TaskKind::mesh, 5));
  TaskRow other = mesh;
  other.id = TaskId{6};
  lists.unplace(mesh);
  lists.place(other);
  EXPECT_EQ(lists.find(wing, TaskKind::mesh, 5), TaskId{6});
}

TEST(TaskLists, a_job_that_is_forgotten_leaves_the_others_alone) {
  TaskLists lists;
  for (const JobId job : {wing, flange}) {
    const TaskRow task = task_of(job.value, job, TaskKind::mesh, TaskState::failed);
    lists.place(task);
    lists.update(task, ended(job));
    lists.update(task_of(job.value + 2, job, TaskKind::mesh, TaskState::ready), ended(job));
  }
  lists.forget(wing);
  EXPECT_FALSE(lists.is_active(wing));
  EXPECT_TRUE(lists.is_active(flange));
  EXPECT_THAT(lists.tasks_of(wing), IsEmpty());
  EXPECT_THAT(lists.failed_of(wing), IsEmpty());
  EXPECT_THAT(lists.tasks_of(flange), ElementsAre(TaskId{2}));
  EXPECT_THAT(lists.failed_of(flange), ElementsAre(TaskId{2}));
}

TEST(TaskLists, broken_invariants_are_told) {
  TaskLists lists;
  TaskRow task = task_of(1, wing, TaskKind::mesh, TaskState::ready);
  lists.place(task);
  lists.update(task, running(wing));
  EXPECT_THAT(lists.validate({{task.id, task}}, running_jobs()), IsEmpty());
  EXPECT_THAT(
      lists.validate({}, running_jobs()),
      ElementsAre("a task on offer that does not exist", "an active task that does not exist",
                  "a place of a task that does not exist"));
  task.state = TaskState::failed;
  EXPECT_THAT(lists.validate({{task.id, task}}, running_jobs()), SizeIs(6));
}

}  // namespace
}  // namespace tetfarm
