#include "coordinator/decisions/task_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tasks/decompose_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/mesh_contract.h"
#include "tasks/order_contract.h"
#include "tests/coordinator/fake_task.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

MeshGiven some_mesh() {
  MeshGiven given;
  given.job = {"settings' hash", 1};
  given.subdomain = {"leaf's hash", 2};
  given.spacing = {"spacing's hash", 3};
  given.work = 1000;
  return given;
}

TEST(TaskRows, have_the_names_and_the_order_of_their_contract) {
  const TaskRow task = new_task(JobId{3}, 5, some_mesh());
  EXPECT_EQ(task.job, JobId{3});
  EXPECT_EQ(task.kind, TaskKind::mesh);
  EXPECT_EQ(task.path, 5U);
  EXPECT_THAT(task.inputs, ElementsAre(ArtifactRef{"job", "settings' hash", 1},
                                       ArtifactRef{"subdomain", "leaf's hash", 2},
                                       ArtifactRef{"spacing", "spacing's hash", 3}));
  EXPECT_THAT(task.parameters, ElementsAre(std::pair("work", "1000")));
  EXPECT_EQ(given_to<MeshGiven>(task).subdomain, some_mesh().subdomain);
}

TEST(TaskRows, of_older_versions_lack_what_came_later) {
  TaskRow inspect;
  inspect.outputs = {fake_file("root", "r")};
  inspect.numbers = {{"parts", 3}};
  const auto made = made_by<InspectMade>(inspect);
  EXPECT_EQ(made.parts, 3U);
  EXPECT_EQ(made.root, without_name(inspect.outputs[0]));
  EXPECT_EQ(made.groups, 0U);
  EXPECT_FALSE(made.across_cuts);
  EXPECT_EQ(made.settings, TaskFile{});
}

TEST(TaskRows, are_not_read_as_another_kind_and_not_made_without_a_file) {
  const TaskRow mesh = new_task(JobId{1}, 5, some_mesh());
  EXPECT_DEATH(given_to<DecomposeGiven>(mesh), "");
  EXPECT_DEATH(made_by<InspectMade>(mesh), "");
  MeshGiven lacks = some_mesh();
  lacks.spacing = {};
  EXPECT_DEATH(new_task(JobId{1}, 5, lacks), "");
}

TEST(TaskRows, give_the_file_of_one_leaf) {
  TaskRow order;
  order.kind = TaskKind::order;
  order.outputs = {fake_file("shared:4", "a"), fake_file("shared:44", "b")};
  EXPECT_EQ(made_for_leaf(order, &OrderMade::shared, 44), without_name(order.outputs[1]));
  EXPECT_DEATH(made_for_leaf(order, &OrderMade::shared, 5), "");
}

TEST(TaskRows, say_how_large_tasks_on_sub_domains_were_told_to_be) {
  EXPECT_STREQ(field_name(&DecomposeGiven::work), field_name(&MeshGiven::work));
  EXPECT_STREQ(field_name(&DecomposeGiven::needles), field_name(&MeshGiven::needles));
  TaskRow mesh = new_task(JobId{1}, 5, some_mesh());
  EXPECT_EQ(told_size(mesh)->elements, 1000);
  EXPECT_EQ(told_size(mesh)->needles, 0);
  mesh.parameters["needles"] = "7";
  EXPECT_EQ(told_size(mesh)->needles, 7);
  mesh.parameters["work"] = "many";
  EXPECT_EQ(told_size(mesh)->elements, 0);
  EXPECT_FALSE(told_size(inspected(1)));
}

TEST(TaskRows, tell_no_more_elements_than_a_contract_takes) {
  EXPECT_EQ(told_work(0.4), 0U);
  EXPECT_EQ(told_work(0.5), 1U);
  EXPECT_EQ(told_work(1e300), most_of_a_count);
  EXPECT_EQ(told_work(std::numeric_limits<double>::infinity()), most_of_a_count);
}

}  // namespace
}  // namespace tetfarm
