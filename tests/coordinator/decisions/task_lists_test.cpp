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

std::map<JobId, JobRow> running_jobs() { return {{wing, {}}, {flange, {}}}; }

TEST(TaskLists, cuts_and_what_others_wait_for_are_handed_out_first_then_the_older_ones) {
  TaskLists lists;
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::ready), true);
  lists.update(task_of(2, wing, TaskKind::cosmetic, TaskState::ready), true);
  lists.update(task_of(3, wing, TaskKind::write, TaskState::ready), true);
  lists.update(task_of(4, wing, TaskKind::decompose, TaskState::ready), true);
  std::vector<TaskId> order;
  for (const auto& [rank, task] : lists.offers()) order.push_back(task);
  EXPECT_THAT(order, ElementsAre(TaskId{2}, TaskId{4}, TaskId{1}, TaskId{3}));
}

TEST(TaskLists, what_is_not_ready_or_of_a_job_that_does_not_run_is_not_on_offer) {
  TaskLists lists;
  const TaskRow ready = task_of(1, wing, TaskKind::mesh, TaskState::ready);
  lists.update(ready, true);
  EXPECT_THAT(lists.offers(), SizeIs(1));
  lists.update(ready, false);
  EXPECT_THAT(lists.offers(), IsEmpty());
  lists.update(ready, true);
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::leased), true);
  EXPECT_THAT(lists.offers(), IsEmpty());
}

TEST(TaskLists, a_job_is_active_while_a_task_is_ready_or_runs) {
  TaskLists lists;
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::leased), true);
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::ready), true);
  lists.update(task_of(1, wing, TaskKind::mesh, TaskState::done), true);
  EXPECT_TRUE(lists.is_active(wing));
  EXPECT_FALSE(lists.is_active(flange));
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::failed), true);
  EXPECT_FALSE(lists.is_active(wing));
  EXPECT_THAT(lists.failed_of(wing), ElementsAre(TaskId{2}));
  lists.update(task_of(2, wing, TaskKind::mesh, TaskState::ready), true);
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
    lists.update(task, false);
    lists.update(task_of(job.value + 2, job, TaskKind::mesh, TaskState::ready), false);
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
  lists.update(task, true);
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
