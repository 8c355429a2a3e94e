#include "coordinator/decisions/tree_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr JobId job{1};

SubdomainRow node(std::uint64_t path, SubdomainState state, bool meshed = false) {
  SubdomainRow row;
  row.job = job;
  row.path = path;
  row.state = state;
  row.meshed = meshed;
  return row;
}

std::map<SubdomainKey, SubdomainRow> tree(const std::vector<SubdomainRow>& nodes) {
  std::map<SubdomainKey, SubdomainRow> rows;
  for (const SubdomainRow& row : nodes) rows[{row.job, row.path}] = row;
  return rows;
}

TEST(TreeProgress, a_tree_is_settled_when_all_is_cut_and_meshed) {
  TreeProgress progress;
  progress.add(node(1, SubdomainState::cut));
  progress.add(node(2, SubdomainState::open));
  EXPECT_TRUE(progress.has_open(job));
  EXPECT_FALSE(progress.is_settled(job));
  progress.take_away(node(2, SubdomainState::open));
  progress.add(node(2, SubdomainState::leaf));
  EXPECT_FALSE(progress.has_open(job));
  EXPECT_FALSE(progress.is_settled(job));
  progress.take_away(node(2, SubdomainState::leaf));
  progress.add(node(2, SubdomainState::leaf, true));
  EXPECT_TRUE(progress.is_settled(job));
}

TEST(TreeProgress, it_is_written_when_each_leaf_is) {
  TreeProgress progress;
  progress.add(node(2, SubdomainState::leaf, true));
  progress.add(node(3, SubdomainState::leaf, true));
  progress.note_written(job);
  EXPECT_FALSE(progress.is_written(job));
  progress.note_written(job);
  EXPECT_TRUE(progress.is_written(job));
}

TEST(TreeProgress, it_is_written_when_the_layers_are_grown_too) {
  TreeProgress progress;
  progress.set_chunks(job, 2);
  progress.add(node(2, SubdomainState::leaf, true));
  progress.note_written(job);
  progress.note_written(job);
  EXPECT_FALSE(progress.is_written(job));
  progress.note_written(job);
  EXPECT_TRUE(progress.is_written(job));
  EXPECT_THAT(progress.validate(tree({node(2, SubdomainState::leaf, true)})), IsEmpty());
  progress.note_written(job);
  EXPECT_THAT(progress.validate(tree({node(2, SubdomainState::leaf, true)})),
              ElementsAre("job 1: more is written than there are leaves"));
}

TEST(TreeProgress, turns_start_anew_with_another_order) {
  TreeProgress progress;
  EXPECT_EQ(progress.turns(job), nullptr);
  progress.set_turns(job, {{2, {}}, {3, {}}});
  progress.note_turn_over(job);
  EXPECT_FALSE(progress.had_all_turns(job));
  progress.note_turn_over(job);
  EXPECT_TRUE(progress.had_all_turns(job));
  progress.start_turns_anew(job);
  EXPECT_EQ(progress.turns(job), nullptr);
  progress.set_turns(job, {{2, {}}, {3, {}}});
  EXPECT_FALSE(progress.had_all_turns(job)) << "those of the other order do not count";
}

TEST(TreeProgress, former_leaves_are_counted_on_the_way_up) {
  TreeProgress progress;
  progress.note_former_leaf(job, 2);
  progress.note_former_leaf(job, 9);
  EXPECT_EQ(progress.former_leaves_above(job, 2), 0U) << "only those that it lies below";
  EXPECT_EQ(progress.former_leaves_above(job, 4), 1U);
  EXPECT_EQ(progress.former_leaves_above(job, 18), 2U);
  EXPECT_EQ(progress.former_leaves_above(job, 6), 0U);
}

TEST(TreeProgress, of_a_forgotten_job_nothing_is_known) {
  TreeProgress progress;
  progress.add(node(2, SubdomainState::open));
  progress.note_former_leaf(job, 2);
  progress.forget(job);
  EXPECT_FALSE(progress.has_open(job));
  EXPECT_EQ(progress.former_leaves_above(job, 4), 0U);
}

TEST(TreeProgress, broken_invariants_are_told) {
  const SubdomainRow leaf = node(2, SubdomainState::leaf, true);
  TreeProgress progress;
  EXPECT_THAT(progress.validate(tree({leaf})),
              ElementsAre("job 1: its sub-domains are not counted"));
  progress.add(leaf);
  EXPECT_THAT(progress.validate(tree({leaf})), IsEmpty());
  EXPECT_THAT(progress.validate({}), ElementsAre("job 1: sub-domains are miscounted"));
  progress.note_written(job);
  progress.note_written(job);
  progress.set_turns(job, {});
  progress.note_turn_over(job);
  EXPECT_THAT(progress.validate(tree({leaf})),
              ElementsAre("job 1: more is written than there are leaves",
                          "job 1: more turns are over than there are"));
}

}  // namespace
}  // namespace tetfarm
