#include "coordinator/decisions/races.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr TaskId task{7};
constexpr AttemptId first{1};
constexpr AttemptId rival{2};

AttemptRow attempt_of(AttemptId id, TaskId of_task, bool is_rival) {
  AttemptRow attempt;
  attempt.id = id;
  attempt.task = of_task;
  attempt.is_rival = is_rival;
  return attempt;
}

std::map<AttemptId, AttemptRow> race() {
  return {{first, attempt_of(first, task, false)}, {rival, attempt_of(rival, task, true)}};
}

std::map<TaskId, TaskRow> tasks_with(AttemptId attempt) {
  std::map<TaskId, TaskRow> tasks;
  tasks[task].id = task;
  tasks[task].attempt = attempt;
  return tasks;
}

TEST(SecondAttempts, the_rival_goes_on_when_the_first_attempt_ends) {
  Races races;
  races.begin(task, rival);
  EXPECT_EQ(races.leave(task, first, first), rival);
  EXPECT_FALSE(races.is_raced(task));
}

TEST(SecondAttempts, nothing_changes_for_the_first_attempt_when_its_rival_ends) {
  Races races;
  races.begin(task, rival);
  EXPECT_FALSE(races.leave(task, rival, first));
  EXPECT_FALSE(races.is_raced(task)) << "it may be raced again";
}

TEST(SecondAttempts, an_attempt_that_nobody_races_leaves_its_task_to_nobody) {
  EXPECT_FALSE(Races().leave(task, first, first));
}

TEST(SecondAttempts, a_task_is_raced_by_one_at_most) {
  Races races;
  races.begin(task, rival);
  EXPECT_DEATH(races.begin(task, AttemptId{3}), "");
}

TEST(SecondAttempts, the_latest_comes_first_and_those_in_time_or_raced_do_not_count) {
  Races races;
  races.begin(task, rival);
  std::map<AttemptId, AttemptRow> running = race();
  for (std::uint64_t i = 3; i <= 6; ++i) {
    running[AttemptId{i}] = attempt_of(AttemptId{i}, TaskId{10 * i}, false);
  }
  const auto over_ms = [](const AttemptRow& attempt) -> std::optional<std::int64_t> {
    if (attempt.id == AttemptId{6}) return std::nullopt;
    if (attempt.id == AttemptId{5}) return 0;
    return static_cast<std::int64_t>(attempt.id.value);
  };
  EXPECT_THAT(races.late_tasks(running, over_ms, 0), ElementsAre(TaskId{40}, TaskId{30}));
}

TEST(SecondAttempts, a_look_is_not_repeated_at_once) {
  Races races;
  const std::map<AttemptId, AttemptRow> running = {{first, attempt_of(first, task, false)}};
  const auto over_ms = [](const AttemptRow&) { return std::optional<std::int64_t>(1); };
  EXPECT_THAT(races.late_tasks(running, over_ms, 1000), ElementsAre(task));
  EXPECT_THAT(races.late_tasks(running, over_ms, 1099), IsEmpty());
  EXPECT_THAT(races.late_tasks(running, over_ms, 1100), ElementsAre(task));
}

TEST(SecondAttempts, broken_invariants_are_told) {
  Races races;
  EXPECT_THAT(races.validate(race(), tasks_with(first)), ElementsAre("attempt 2 races nobody"));
  races.begin(task, rival);
  EXPECT_THAT(races.validate(race(), tasks_with(first)), IsEmpty());
  EXPECT_THAT(races.validate(race(), tasks_with(rival)),
              ElementsAre("task 7 is raced by its own attempt"));
  EXPECT_THAT(races.validate({}, tasks_with(first)), ElementsAre("task 7 is raced by nobody"));
}

}  // namespace
}  // namespace tetfarm
