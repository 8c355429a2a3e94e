#include "coordinator/decisions/assimilation_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/coordinator/fake_task.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// The cut 1 into the leaves 2 and 3, of a job that asks for groups.
class Assimilated : public testing::Test {
 protected:
  Assimilated() {
    inspect_.numbers["groups"] = 1;
    tree_ = {{JobId{1}, 1, 2, SubdomainState::cut, 9, 0, 0, false, "h1", 1, 100, 0},
             {JobId{1}, 2, 1, SubdomainState::leaf, 0, 0, 0, false, "h2", 1, 40, 0},
             {JobId{1}, 3, 1, SubdomainState::leaf, 0, 0, 0, false, "h3", 1, 60.4, 0}};
  }

  TaskRow inspect_ = inspected(2);
  std::vector<SubdomainRow> tree_;
};

TEST_F(Assimilated, leaves_wait_for_the_task_that_sees_them_all) {
  inspect_.numbers["parts"] = 1;
  const GraphStep step = after_inspect(inspect_);
  EXPECT_THAT(step.tasks, SizeIs(0));
  const std::optional<TaskRow> task = assimilate_task(inspect_, tree_);
  ASSERT_TRUE(task);
  EXPECT_THAT(names_of(task->inputs), ElementsAre("job", "subdomain:2", "subdomain:3"));
  EXPECT_EQ(task->parameters.at("table"), "2 40\n3 60\n");
  EXPECT_FALSE(assimilate_task(inspected(2), tree_));
}

TEST_F(Assimilated, a_group_is_a_leaf_under_the_number_of_its_first) {
  TaskRow done = *assimilate_task(inspect_, tree_);
  done.outputs = {fake_file("dropped", "d"), fake_file("group:2", "g")};
  done.texts["groups"] = "2 2\n3 2\n";
  const GraphStep step = after_assimilate(inspect_, done, tree_);
  ASSERT_THAT(step.tasks, SizeIs(1));
  EXPECT_EQ(step.tasks[0].path, 2U);
  EXPECT_EQ(step.tasks[0].inputs[1].hash, done.outputs[1].hash);
  ASSERT_THAT(step.subdomains, SizeIs(2));
  EXPECT_DOUBLE_EQ(step.subdomains[0].work, 100.4);
  EXPECT_EQ(step.subdomains[1].state, SubdomainState::joined);
  EXPECT_EQ(step.subdomains[1].joined_into, 2U);
  const std::vector<SubdomainRow> tree = {tree_[0], step.subdomains[0], step.subdomains[1]};
  const NumberGiven number = given_to_number(inspect_, &done, tree);
  EXPECT_EQ(number.table, "cut 1 9\nleaf 2 0 0\njoined 3 2\n");
  EXPECT_EQ(number.dropped, without_name(done.outputs[0]));
}

TEST_F(Assimilated, groups_that_leave_a_leaf_out_are_unusable) {
  const TaskRow task = *assimilate_task(inspect_, tree_);
  TaskResult result;
  result.outputs = {fake_file("dropped", "d"), fake_file("group:2", "g"),
                    fake_file("group:3", "g3")};
  const auto problem = [&](const char* groups) {
    result.texts["groups"] = groups;
    return problem_with(task, result).has_value();
  };
  EXPECT_FALSE(problem("2 2\n3 2\n"));
  EXPECT_FALSE(problem("2 2\n3 3\n"));
  EXPECT_TRUE(problem("2 2\n")) << "a leaf in no group";
  EXPECT_TRUE(problem("2 3\n3 2\n")) << "groups named by leaves of others";
  EXPECT_TRUE(problem("2 2\n3 2\n5 2\n")) << "an unknown leaf";
  EXPECT_TRUE(problem("2 2\n3 2\n3 3\n")) << "a leaf twice";
  EXPECT_TRUE(problem("2 2\n3 x\n"));
  result.outputs.pop_back();
  EXPECT_TRUE(problem("2 2\n3 3\n")) << "a group without a file";
}

}  // namespace
}  // namespace tetfarm
