#include "coordinator/decisions/fair_turns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint64_t> order_of_turns(const TaskLists::OfUsers& offers,
                                          const UsersAtWork& at_work) {
  FairTurns turns(offers, at_work);
  std::vector<std::uint64_t> order;
  for (std::optional<TaskId> task = turns.next(); task; task = turns.next()) {
    order.push_back(task->value);
  }
  return order;
}

// An offer is a priority with its sign turned, a rank, a task.

TEST(FairTurns, of_one_user_are_by_priority_rank_and_age) {
  EXPECT_THAT(order_of_turns({{"anna", {{0, 2, TaskId{1}}, {0, 1, TaskId{2}}, {-5, 3, TaskId{3}}}}},
                             {{"anna", 9}}),
              ElementsAre(3, 2, 1));
}

TEST(FairTurns, come_first_to_who_has_the_fewest_tasks_at_work_whatever_their_rank) {
  const TaskLists::OfUsers offers = {{"anna", {{0, 1, TaskId{1}}, {0, 1, TaskId{2}}}},
                                     {"berta", {{0, 9, TaskId{3}}, {0, 9, TaskId{4}}}}};
  EXPECT_THAT(order_of_turns(offers, {{"anna", 1}}), ElementsAre(3, 4, 1, 2));
  EXPECT_THAT(order_of_turns(offers, {{"berta", 1}}), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(order_of_turns(offers, {}), ElementsAre(1, 2, 3, 4)) << "then by rank";
}

TEST(FairTurns, do_not_come_before_a_higher_priority) {
  EXPECT_THAT(order_of_turns({{"anna", {{-1, 9, TaskId{1}}, {0, 9, TaskId{2}}}},
                              {"berta", {{0, 1, TaskId{3}}}}},
                             {{"anna", 100}}),
              ElementsAre(1, 3, 2));
}

TEST(FairTurns, are_over_when_nothing_is_on_offer) {
  EXPECT_THAT(order_of_turns({}, {}), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
