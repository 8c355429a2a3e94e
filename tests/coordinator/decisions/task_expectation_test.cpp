#include "coordinator/decisions/task_expectation.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TaskRow mesh_task_of(const char* work, const char* needles, double seconds) {
  TaskRow task;
  task.kind = TaskKind::mesh;
  task.parameters["work"] = work;
  if (*needles != '\0') task.parameters["needles"] = needles;
  task.seconds = seconds;
  return task;
}

TEST(TaskExpectation, of_a_kind_of_which_none_is_done_is_nothing) {
  EXPECT_FALSE(TaskExpectation().seconds(mesh_task_of("1000", "", 0)));
}

TEST(TaskExpectation, goes_by_elements) {
  TaskExpectation expectation;
  expectation.learn(mesh_task_of("100000", "", 2));
  EXPECT_NEAR(*expectation.seconds(mesh_task_of("300000", "", 0)), 6, 1e-9);
}

TEST(TaskExpectation, goes_by_the_tasks_of_late) {
  TaskExpectation expectation;
  const auto learn = [&](std::size_t tasks, double seconds) {
    for (std::size_t i = 0; i < tasks; ++i) expectation.learn(mesh_task_of("1000", "", seconds));
  };
  constexpr std::size_t most = TaskExpectation::samples_kept;
  learn(3 * most, 1);
  learn(most / 2, 5);
  EXPECT_NEAR(*expectation.seconds(mesh_task_of("1000", "", 0)), 1, 1e-9) << "half of those kept";
  learn(1, 5);
  EXPECT_NEAR(*expectation.seconds(mesh_task_of("1000", "", 0)), 5, 1e-9);
}

TEST(TaskExpectation, a_leaf_full_of_needles_is_expected_to_take_longer) {
  TaskExpectation expectation;
  for (int i = 0; i < 20; ++i) expectation.learn(mesh_task_of("100000", "", 0.3));
  EXPECT_GT(*expectation.seconds(mesh_task_of("20000", "5000", 0)), 2);
  EXPECT_NEAR(*expectation.seconds(mesh_task_of("100000", "0", 0)), 0.3, 1e-9);
}

TEST(TaskExpectation, a_leaf_full_of_needles_does_not_make_others_late) {
  TaskExpectation expectation;
  expectation.learn(mesh_task_of("20000", "5000", 30));
  EXPECT_LT(*expectation.seconds(mesh_task_of("20000", "", 0)), 1);
}

}  // namespace
}  // namespace tetfarm
