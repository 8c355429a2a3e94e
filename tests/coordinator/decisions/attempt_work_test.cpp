#include "coordinator/decisions/attempt_work.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetfarm {
namespace {

TEST(AttemptWork, is_not_known_before_something_was_said) {
  EXPECT_FALSE(AttemptWork().now().has_value());
  EXPECT_EQ(AttemptWork().share(), 0);
}

TEST(AttemptWork, numbers_of_a_stage_never_fall_in_whatever_order_they_come) {
  AttemptWork work;
  work.note({WorkStage::edges, 3, 312, 1204}, 0.2);
  work.note({WorkStage::edges, 1, 10, 900}, 0.1);
  EXPECT_EQ(work.now(), (WorkCount{WorkStage::edges, 3, 312, 1204}));
  EXPECT_EQ(work.share(), 0.2);
  work.note({WorkStage::faces, 1, 2, 5}, 0.3);
  EXPECT_EQ(work.now(), (WorkCount{WorkStage::faces, 1, 2, 5}));
  work.note({WorkStage::edges, 0, 0, 0}, 0);
  EXPECT_EQ(work.now(), (WorkCount{WorkStage::edges, 3, 312, 1204}));
  EXPECT_EQ(work.share(), 0.3);
}

TEST(AttemptWork, total_is_no_less_than_what_is_done) {
  AttemptWork work;
  work.note({WorkStage::points, 0, 500, 0}, 0);
  EXPECT_EQ(work.now()->total, 0U) << "not known";
  work.note({WorkStage::points, 0, 10, 20}, 0);
  EXPECT_EQ(work.now(), (WorkCount{WorkStage::points, 0, 500, 500}));
}

TEST(AttemptWork, share_is_a_share) {
  AttemptWork work;
  work.note({WorkStage::points, 0, 1, 2}, std::nan(""));
  EXPECT_EQ(work.share(), 0);
  work.note({WorkStage::points, 0, 1, 2}, 7);
  EXPECT_EQ(work.share(), 1);
}

}  // namespace
}  // namespace tetfarm
