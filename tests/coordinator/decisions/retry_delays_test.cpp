#include "coordinator/decisions/retry_delays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr TaskId task{7};
constexpr WorkerId here{1};
constexpr WorkerId elsewhere{2};

TEST(RetryDelays, are_doubled_by_each_failure_up_to_the_longest) {
  EXPECT_EQ(delay_after(1, 100, 1000), 100);
  EXPECT_EQ(delay_after(2, 100, 1000), 200);
  EXPECT_EQ(delay_after(4, 100, 1000), 800);
  EXPECT_EQ(delay_after(5, 100, 1000), 1000);
  EXPECT_EQ(delay_after(4'000'000'000, 100, 1000), 1000);
}

TEST(RetryDelays, a_task_waits_until_its_time_has_come) {
  RetryDelays delays(500);
  EXPECT_EQ(delays.wait_ms(task, 0), 0);
  delays.wait_until(task, 300);
  EXPECT_EQ(delays.wait_ms(task, 0), 300);
  EXPECT_EQ(delays.wait_ms(task, 299), 1);
  EXPECT_EQ(delays.wait_ms(task, 300), 0);
}

TEST(RetryDelays, for_a_while_it_goes_elsewhere_than_where_it_failed) {
  RetryDelays delays(500);
  delays.failed_on(task, here, 100);
  EXPECT_EQ(delays.wait_ms(task, 100), 0);
  EXPECT_TRUE(delays.prefers_other(task, here, 599));
  EXPECT_FALSE(delays.prefers_other(task, elsewhere, 599));
  EXPECT_FALSE(delays.prefers_other(task, here, 600));
}

TEST(RetryDelays, the_while_begins_when_it_may_be_tried) {
  RetryDelays delays(500);
  delays.failed_on(task, here, 100);
  delays.wait_until(task, 1000);
  EXPECT_TRUE(delays.prefers_other(task, here, 1499));
  EXPECT_FALSE(delays.prefers_other(task, here, 1500));
}

TEST(RetryDelays, what_is_forgotten_may_go_anywhere_at_once) {
  RetryDelays delays(500);
  delays.failed_on(task, here, 100);
  delays.wait_until(task, 1000);
  delays.forget(task);
  EXPECT_EQ(delays.wait_ms(task, 100), 0);
  EXPECT_FALSE(delays.prefers_other(task, here, 100));
}

TEST(RetryDelays, of_a_task_that_is_gone_is_told) {
  RetryDelays delays(500);
  delays.wait_until(task, 300);
  EXPECT_THAT(delays.validate({{task, {}}}), IsEmpty());
  EXPECT_THAT(delays.validate({}), ElementsAre("task 7 waits and is not at hand"));
}

}  // namespace
}  // namespace tetfarm
