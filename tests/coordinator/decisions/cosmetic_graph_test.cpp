#include "coordinator/decisions/cosmetic_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/decisions/task_graph.h"
#include "tests/coordinator/fake_task.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;
using testing::UnorderedElementsAre;

constexpr const char* three_in_a_row = "4 0 5\n5 1 4 6\n6 0 5\n";

/// Done tasks by kind and leaf.
class DoneTasks {
 public:
  void add(TaskKind kind, std::uint64_t leaf) {
    TaskRow& task = tasks_[{kind, leaf}];
    task.kind = kind;
    task.path = leaf;
    task.outputs = {fake_file("elements", name_of(kind) + std::to_string(leaf))};
  }
  FindDone find() const {
    return [this](TaskKind kind, std::uint64_t leaf) {
      const auto found = tasks_.find({kind, leaf});
      return found == tasks_.end() ? nullptr : &found->second;
    };
  }

 private:
  std::map<std::pair<TaskKind, std::uint64_t>, TaskRow> tasks_;
};

TaskRow inspected(double across_cuts) {
  TaskRow task;
  task.job = JobId{1};
  task.outputs = {fake_file("spacing", "p"), fake_file("surface", "s")};
  task.numbers["across_cuts"] = across_cuts;
  return task;
}

TEST(CosmeticGraph, reads_the_order_of_turns) {
  const auto turns = turn_order_of(three_in_a_row);
  ASSERT_TRUE(turns.has_value());
  EXPECT_EQ(turns->at(5).colour, 1);
  EXPECT_THAT(turns->at(5).neighbours, ElementsAre(4, 6));
}

TEST(CosmeticGraph, an_order_that_makes_no_sense_is_none) {
  for (const char* wrong :
       {"4\n", "4 x\n", "0 0\n", "4 -1\n", "4 0 5\n", "4 0 5\n5 0 4\n", "4 0 5\n5 1\n",
        "4 0\n4 1\n", "4 0 6 5\n5 1 4\n6 1 4\n", "4 0 five\n"}) {
    EXPECT_FALSE(turn_order_of(wrong).has_value()) << wrong;
  }
}

TEST(CosmeticGraph, a_turn_waits_for_neighbours_only_and_takes_what_they_made_last) {
  const TurnOrder turns = *turn_order_of(three_in_a_row);
  DoneTasks done;
  done.add(TaskKind::extract, 4);
  EXPECT_FALSE(cosmetic_task(inspected(1), turns, 4, done.find())) << "5 is not extracted";
  done.add(TaskKind::extract, 5);
  const auto first = cosmetic_task(inspected(1), turns, 4, done.find());
  ASSERT_TRUE(first.has_value()) << "6 is none of its neighbours";
  EXPECT_THAT(names_of(first->inputs), UnorderedElementsAre("spacing", "own", "waits:5"));
  EXPECT_EQ(first->parameters.at("colours"), "4 0\n5 1\n");
  done.add(TaskKind::cosmetic, 4);
  done.add(TaskKind::extract, 6);
  EXPECT_FALSE(cosmetic_task(inspected(1), turns, 5, done.find())) << "6 comes before";
  done.add(TaskKind::cosmetic, 6);
  const auto last = cosmetic_task(inspected(1), turns, 5, done.find());
  ASSERT_TRUE(last.has_value());
  EXPECT_THAT(names_of(last->inputs),
              UnorderedElementsAre("spacing", "own", "had_turn:4", "had_turn:6"));
}

TEST(CosmeticGraph, after_the_last_turn_leaves_are_numbered_and_written_from_what_turns_made) {
  const TurnOrder turns = *turn_order_of(three_in_a_row);
  DoneTasks done;
  for (const std::uint64_t leaf : {4, 5, 6}) {
    done.add(TaskKind::extract, leaf);
    done.add(TaskKind::cosmetic, leaf);
  }
  const auto made = [](TaskKind kind, std::uint64_t leaf) {
    return without_name(fake_file("elements", name_of(kind) + std::to_string(leaf)));
  };
  TaskRow order;
  order.kind = TaskKind::order;
  order.texts["order"] = three_in_a_row;
  NumberGiven number;
  add_elements(order, turns, done.find(), number);
  EXPECT_EQ(number.order, three_in_a_row);
  for (const std::uint64_t leaf : {4, 5, 6}) {
    EXPECT_EQ(number.cores.at(leaf), made(TaskKind::extract, leaf));
    EXPECT_EQ(number.elements.at(leaf), made(TaskKind::cosmetic, leaf));
  }
  WriteGiven write;
  add_final_elements(4, turns, done.find(), write);
  EXPECT_THAT(write.cores, ElementsAre(Pair(4, made(TaskKind::extract, 4))));
  EXPECT_THAT(write.elements, ElementsAre(Pair(4, made(TaskKind::cosmetic, 4)),
                                          Pair(5, made(TaskKind::cosmetic, 5))))
      << "6 is none of its neighbours";
  EXPECT_EQ(write.colours, "4 0\n5 1\n");
}

TEST(CosmeticGraph, only_jobs_with_cuts_that_ask_for_it_are_mended) {
  const SubdomainRow root{JobId{1}, 1, 2, SubdomainState::cut, 0, 0, 0, false, "h", 1};
  const SubdomainRow left{JobId{1}, 2, 1, SubdomainState::leaf, 0, 0, 0, false, "l", 1};
  const SubdomainRow right{JobId{1}, 3, 1, SubdomainState::leaf, 0, 0, 0, false, "r", 1};
  EXPECT_TRUE(has_seam_cosmetics(inspected(1), std::vector<SubdomainRow>{root, left, right}));
  EXPECT_FALSE(has_seam_cosmetics(inspected(0), std::vector<SubdomainRow>{root, left, right}));
  EXPECT_FALSE(has_seam_cosmetics(inspected(1), std::vector<SubdomainRow>{left}));
  TaskRow old = inspected(1);
  old.numbers.clear();
  EXPECT_FALSE(has_seam_cosmetics(old, std::vector<SubdomainRow>{root, left, right}));
  const TaskRow order = order_task(inspected(1), std::vector<SubdomainRow>{root, left, right});
  EXPECT_THAT(names_of(order.inputs), ElementsAre("subdomain:2", "subdomain:3"));
}

TEST(CosmeticGraph, an_order_must_have_the_leaves_of_the_tree) {
  TaskRow order;
  order.kind = TaskKind::order;
  order.inputs = {fake_file("subdomain:4", "a"), fake_file("subdomain:5", "b")};
  TaskResult result;
  result.outputs = {fake_file("shared:4", "c"), fake_file("shared:5", "d")};
  EXPECT_TRUE(problem_with(order, result));
  result.texts["order"] = "4 0 5\n5 1 4\n";
  EXPECT_FALSE(problem_with(order, result));
  result.texts["order"] = "4 0\n";
  EXPECT_TRUE(problem_with(order, result));
  result.texts["order"] = "4 0\n7 0\n";
  EXPECT_TRUE(problem_with(order, result));
  result.texts["order"] = "4 0 5\n5 1 4\n";
  result.outputs.pop_back();
  EXPECT_TRUE(problem_with(order, result));
}

}  // namespace
}  // namespace tetfarm
