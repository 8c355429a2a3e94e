#include "base/work_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

struct Heard {
  std::vector<WorkCount> counts;
  WorkProgress progress{[this](const WorkCount& count) { counts.push_back(count); }};
};

TEST(WorkProgress, nobody_need_listen) {
  const WorkProgress progress;
  progress.begin(WorkStage::edges, 3);
  progress.next_pass();
  progress.add();
}

TEST(WorkProgress, tells_a_stage_when_it_begins_and_each_so_many_calls) {
  Heard heard;
  heard.progress.begin(WorkStage::edges, 10, 4);
  for (int i = 0; i < 10; ++i) heard.progress.add(i % 2 == 0 ? 1 : 0);
  EXPECT_THAT(heard.counts, ElementsAre(WorkCount{WorkStage::edges, 0, 0, 10},
                                        WorkCount{WorkStage::edges, 0, 2, 10},
                                        WorkCount{WorkStage::edges, 0, 4, 10}));
}

TEST(WorkProgress, a_stage_that_is_entered_again_goes_on_from_where_it_was) {
  Heard heard;
  heard.progress.begin(WorkStage::edges, 3);
  for (int i = 0; i < 2; ++i) heard.progress.add();
  heard.progress.begin(WorkStage::faces, 1);
  heard.progress.begin(WorkStage::edges, 5);
  heard.progress.add();
  EXPECT_EQ(heard.counts.back(), (WorkCount{WorkStage::edges, 0, 3, 7}));
}

TEST(WorkProgress, a_stage_that_is_entered_again_for_less_than_is_left_keeps_its_total) {
  Heard heard;
  heard.progress.begin(WorkStage::edges, 10);
  for (int i = 0; i < 3; ++i) heard.progress.add();
  heard.progress.begin(WorkStage::edges, 2);
  EXPECT_EQ(heard.counts.back(), (WorkCount{WorkStage::edges, 0, 3, 10}));
}

TEST(WorkProgress, what_turns_up_late_raises_the_total) {
  Heard heard;
  heard.progress.begin(WorkStage::cosmetics, 1);
  heard.progress.next_pass();
  for (int i = 0; i < 5; ++i) heard.progress.add();
  EXPECT_EQ(heard.counts.back(), (WorkCount{WorkStage::cosmetics, 1, 5, 5}));
}

TEST(WorkProgress, copies_count_together) {
  Heard heard;
  const WorkProgress copy = heard.progress;
  copy.begin(WorkStage::points, 2);
  heard.progress.add();
  copy.add();
  EXPECT_EQ(heard.counts.back(), (WorkCount{WorkStage::points, 0, 2, 2}));
}

}  // namespace
}  // namespace tetfarm
