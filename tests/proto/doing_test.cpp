#include "proto/doing.h"

#include <gtest/gtest.h>

#include <limits>

namespace tetfarm {
namespace {

constexpr std::uint64_t endless = std::numeric_limits<std::uint64_t>::max();

TEST(Doing, comes_back_as_it_was) {
  const WorkCount count{WorkStage::faces, 4, 12, 30};
  EXPECT_EQ(work_count_of(doing_message(count)), count);
}

TEST(Doing, of_a_stage_that_is_not_known_is_left_out) {
  wire::Doing doing = doing_message({WorkStage::faces, 1, 2, 3});
  doing.set_stage("polish");
  EXPECT_FALSE(work_count_of(doing).has_value());
  EXPECT_FALSE(work_count_of(wire::Doing()).has_value());
}

TEST(Doing, has_no_more_done_than_there_is_to_do) {
  wire::Doing doing = doing_message({WorkStage::edges, 1, endless, 3});
  EXPECT_EQ(work_count_of(doing)->done, 3U);
}

TEST(Doing, has_counts_that_can_be_reckoned_with) {
  wire::Doing doing = doing_message({WorkStage::edges, endless, endless, endless});
  const WorkCount count = *work_count_of(doing);
  EXPECT_LE(count.pass, 1'000'000'000'000'000U);
  EXPECT_LE(count.total, 1'000'000'000'000'000U);
  doing.set_total(0);
  EXPECT_LE(work_count_of(doing)->done, 1'000'000'000'000'000U);
}

TEST(DoingText, of_a_stage_that_is_not_known_is_its_name) {
  wire::Doing doing;
  EXPECT_EQ(doing_text(doing), "");
  doing.set_stage("polish");
  EXPECT_EQ(doing_text(doing), "polish");
  EXPECT_EQ(doing_text(doing_message({WorkStage::validate, 0, 0, 0})), "validating");
}

TEST(Doing, is_bounded_exactly) {
  constexpr std::uint64_t most = 1'000'000'000'000'000;
  wire::Doing doing = doing_message({WorkStage::edges, endless, endless, 0});
  EXPECT_EQ(work_count_of(doing), (WorkCount{WorkStage::edges, most, most, 0}));
  doing.set_total(endless);
  EXPECT_EQ(work_count_of(doing), (WorkCount{WorkStage::edges, most, most, most}));
  doing = doing_message({WorkStage::edges, 3, 5, 5});
  EXPECT_EQ(work_count_of(doing), (WorkCount{WorkStage::edges, 3, 5, 5}));
  EXPECT_EQ(doing_text(doing), "recovery pass 3: 5 of 5 edges");
}

}  // namespace
}  // namespace tetfarm
