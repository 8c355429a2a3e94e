#include "coordinator/decisions/task_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tasks/remesh_contract.h"
#include "tests/coordinator/fake_task.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

TEST(TaskGraph, one_part_is_meshed_without_a_cut) {
  const GraphStep step = after_inspect(inspected(1));
  ASSERT_THAT(step.tasks, SizeIs(1));
  EXPECT_EQ(step.tasks[0].kind, TaskKind::mesh);
  EXPECT_EQ(step.tasks[0].path, 1U);
  EXPECT_THAT(names_of(step.tasks[0].inputs), ElementsAre("job", "subdomain", "spacing"));
}

TEST(TaskGraph, several_parts_are_cut_and_the_halves_treated_alike) {
  const TaskRow inspect = inspected(3);
  const GraphStep first = after_inspect(inspect);
  ASSERT_THAT(first.tasks, SizeIs(1));
  TaskRow cut = first.tasks[0];
  EXPECT_EQ(cut.kind, TaskKind::decompose);
  EXPECT_EQ(cut.parameters.at("left_parts"), "1");
  EXPECT_EQ(cut.parameters.at("right_parts"), "2");
  cut.outputs = {fake_file("left", "l"), fake_file("right", "r2")};
  cut.numbers = {{"interdomain_nodes", 17}, {"left_work", 40}, {"right_work", 90}};
  const GraphStep second = after_decompose(inspect, cut, first.subdomains[0], false);
  ASSERT_THAT(second.tasks, SizeIs(2));
  EXPECT_EQ(second.tasks[0].kind, TaskKind::mesh);
  EXPECT_EQ(second.tasks[0].path, 2U);
  EXPECT_EQ(second.tasks[1].kind, TaskKind::decompose);
  EXPECT_EQ(second.tasks[1].path, 3U);
  EXPECT_EQ(second.subdomains[0].interdomain_nodes, 17U);
  EXPECT_EQ(second.subdomains[2].work, 90);
}

TEST(TaskGraph, tasks_on_subdomains_are_told_how_many_needles_they_have) {
  TaskRow inspect = inspected(3);
  inspect.numbers["needles"] = 700;
  const GraphStep first = after_inspect(inspect);
  TaskRow cut = first.tasks[0];
  EXPECT_EQ(cut.parameters.at("needles"), "700");
  const GraphStep whole = after_decompose(inspect, cut, first.subdomains[0], false);
  EXPECT_EQ(whole.tasks.at(0).parameters.at("needles"), "700");
  cut.outputs = {fake_file("left", "l"), fake_file("right", "r2")};
  cut.numbers = {{"left_needles", 0}, {"right_needles", 690}};
  const GraphStep halves = after_decompose(inspect, cut, first.subdomains[0], false);
  EXPECT_FALSE(halves.tasks.at(0).parameters.contains("needles"));
  EXPECT_EQ(halves.tasks.at(1).parameters.at("needles"), "690");
}

TEST(TaskGraph, what_cannot_be_cut_stays_whole) {
  const TaskRow inspect = inspected(3);
  const GraphStep first = after_inspect(inspect);
  const GraphStep second = after_decompose(inspect, first.tasks[0], first.subdomains[0], false);
  ASSERT_THAT(second.tasks, SizeIs(1));
  EXPECT_EQ(second.tasks[0].kind, TaskKind::mesh);
  EXPECT_EQ(second.tasks[0].path, 1U);
}

TEST(TaskGraph, heap_numbers_do_not_overflow) {
  const TaskRow inspect = inspected(8);
  SubdomainRow deep = after_inspect(inspect).subdomains[0];
  deep.path = deepest_cut / 2 + 1;
  TaskRow cut;
  cut.job = JobId{1};
  cut.kind = TaskKind::decompose;
  cut.outputs = {fake_file("left", "l"), fake_file("right", "r2")};
  cut.numbers = {{"left_parts", 4}, {"right_parts", 4}};
  const GraphStep step = after_decompose(inspect, cut, deep, false);
  for (const TaskRow& task : step.tasks) EXPECT_EQ(task.kind, TaskKind::mesh);
}

TEST(TaskGraph, the_numbering_table_is_in_tree_order) {
  SubdomainRow cut{JobId{1}, 1, 2, SubdomainState::cut, 9, 0, 0, false, "h", 1};
  SubdomainRow left{JobId{1}, 2, 1, SubdomainState::leaf, 0, 5, 40, true, "h", 1};
  SubdomainRow right{JobId{1}, 3, 1, SubdomainState::leaf, 0, 6, 50, true, "h", 1};
  const std::vector<SubdomainRow> tree = {cut, left, right};
  EXPECT_EQ(given_to_number(inspected(2), nullptr, tree).table,
            "cut 1 9\nleaf 2 5 40\nleaf 3 6 50\n");
}

TEST(TaskGraph, a_leaf_is_written_from_its_own_mesh_and_what_all_leaves_share) {
  const TaskRow inspect = inspected(1);
  TaskRow mesh = after_inspect(inspect).tasks.at(0);
  mesh.outputs = {fake_file("mesh", "m")};
  TaskRow number;
  number.kind = TaskKind::number;
  number.outputs = {fake_file("numbering", "n")};
  WriteGiven given = given_to_write(inspect, number);
  add_mesh(mesh, given);
  EXPECT_THAT(
      new_task(JobId{1}, 1, given).inputs,
      ElementsAre(fake_file("job", "j"), fake_file("surface", "s"), fake_file("numbering", "n"),
                  fake_file("subdomain", "r"), fake_file("mesh", "m")));
}

TEST(TaskGraph, leaves_below_layers_are_written_with_the_heights_of_the_last_prisms) {
  TaskRow inspect = inspected(1);
  inspect.outputs.push_back(fake_file("top_heights", "h"));
  TaskRow number;
  number.kind = TaskKind::number;
  number.outputs = {fake_file("numbering", "n")};
  EXPECT_EQ(given_to_write(inspect, number).top_heights->hash, fake_file("top_heights", "h").hash);
  EXPECT_FALSE(given_to_write(inspected(1), number).top_heights.has_value());
}

TEST(TaskGraph, results_without_their_files_are_unusable) {
  TaskRow cut;
  cut.kind = TaskKind::decompose;
  TaskResult result;
  EXPECT_FALSE(problem_with(cut, result));
  result.outputs = {fake_file("left", "l")};
  EXPECT_TRUE(problem_with(cut, result));
  result.outputs.push_back(fake_file("right", "r"));
  result.numbers = {{"interdomain_nodes", 17},
                    {"left_work", 40},
                    {"right_work", 90},
                    {"left_needles", 0},
                    {"right_needles", 0}};
  EXPECT_FALSE(problem_with(cut, result));
}

TEST(TaskGraph, where_memory_decides_the_halves_have_the_parts_that_were_found) {
  TaskRow inspect = inspected(4);
  inspect.numbers["most_bytes"] = 5e8;
  const GraphStep first = after_inspect(inspect);
  TaskRow cut = first.tasks[0];
  EXPECT_EQ(cut.parameters.at("most_bytes"), "500000000");
  cut.outputs = {fake_file("left", "l"), fake_file("right", "r2")};
  cut.numbers = {{"left_parts", 1}, {"right_parts", 5}};
  const GraphStep second = after_decompose(inspect, cut, first.subdomains[0], false);
  EXPECT_EQ(second.subdomains[1].state, SubdomainState::leaf);
  EXPECT_EQ(second.subdomains[2].parts, 5U);
}

TEST(TaskGraph, a_remeshed_surface_is_inspected_in_place_of_the_given_one) {
  TaskRow remesh = new_task(
      JobId{7}, 0,
      RemeshGiven{without_name(fake_file("job", "j")), without_name(fake_file("in", "i"))});
  remesh.outputs = {fake_file("surface", "s")};
  const TaskRow inspect = inspect_task(remesh);
  EXPECT_EQ(inspect.job, JobId{7});
  EXPECT_EQ(inspect.path, 0U);
  const auto given = given_to<InspectGiven>(inspect);
  EXPECT_EQ(given.job, without_name(fake_file("job", "j")));
  EXPECT_EQ(given.remeshed_surface, without_name(fake_file("surface", "s")));
  EXPECT_FALSE(given.input_surface.has_value());
}

}  // namespace
}  // namespace tetfarm
