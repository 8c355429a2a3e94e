#include "worker/task_cost.h"

#include <gmock/gmock.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

constexpr double megabyte = 1e6;

TEST(TaskCost, more_elements_triangles_and_spacing_take_more) {
  const SubdomainSize size{1e6, 5e4, 4e6};
  for (const auto& larger :
       {SubdomainSize{2e6, 5e4, 4e6}, SubdomainSize{1e6, 9e4, 4e6}, SubdomainSize{1e6, 5e4, 8e6}}) {
    EXPECT_GT(mesh_cost(larger).bytes, mesh_cost(size).bytes);
    EXPECT_GT(decompose_cost(larger).bytes, decompose_cost(size).bytes);
  }
  EXPECT_GT(mesh_cost({2e6, 5e4, 4e6}).seconds, 1.5 * mesh_cost(size).seconds);
}

TEST(TaskCost, needles_take_seconds_but_no_memory) {
  const SubdomainSize good{1e5, 5e4, 4e6};
  const SubdomainSize bad{1e5, 5e4, 4e6, 4000};
  EXPECT_GT(mesh_cost(bad).seconds, 2 * mesh_cost(good).seconds);
  EXPECT_GT(decompose_cost(bad).seconds, decompose_cost(good).seconds);
  EXPECT_EQ(mesh_cost(bad).bytes, mesh_cost(good).bytes);
}

TEST(TaskCost, a_subdomain_that_fits_is_one_part_and_one_that_does_not_is_more) {
  const SubdomainSize size{1e6, 2e4, 1e6};
  const double own = leaf_bytes(size);
  EXPECT_EQ(parts_for_memory(size, own), 1);
  EXPECT_EQ(parts_for_memory(size, own - 1), 2);
  EXPECT_GE(parts_for_memory(size, 100 * megabyte), 4);
}

TEST(TaskCost, as_many_equal_parts_as_it_says_fit) {
  for (const double most : {60 * megabyte, 100 * megabyte, 300 * megabyte, 1000 * megabyte}) {
    const SubdomainSize size{3e6, 6e4, 2e6};
    const auto parts = static_cast<double>(parts_for_memory(size, most));
    EXPECT_LE(leaf_bytes({size.elements / parts, size.triangles / parts, size.spacing_bytes}),
              most);
  }
}

TEST(TaskCost, a_leaf_is_no_larger_than_its_turn_in_cosmetics_allows) {
  const SubdomainSize small{2e4, 4e3, 1e6};
  EXPECT_GT(turn_elements(small), small.elements) << "those of the neighbours too";
  EXPECT_GT(leaf_bytes(small), mesh_cost(small).bytes);
  const SubdomainSize large{4e6, 4e4, 1e6};
  EXPECT_LT(turn_elements(large), large.elements) << "those near cuts only";
  EXPECT_EQ(leaf_bytes(large), mesh_cost(large).bytes);
}

TEST(TaskCost, no_limit_below_the_process_itself_gives_endless_parts) {
  EXPECT_EQ(parts_for_memory({1e6, 1e4, 1e6}, 1), 1'000'000);
}

TEST(TaskCost, the_least_memory_has_room_for_every_task_that_does_not_shrink) {
  const SubdomainSize root{1e7, 2e5, 9e6};
  const double least = least_memory(1e7, root);
  EXPECT_GE(least, inspect_cost(1e7, root).bytes);
  EXPECT_GE(least, decompose_cost(root).bytes);
  EXPECT_GE(least, number_cost(root.triangles).bytes);
  EXPECT_LT(least, mesh_cost(root).bytes) << "else nothing is gained by cutting";
  EXPECT_LT(parts_for_memory(root, least), 1'000'000);
}

/// By the numbers of each kind, worked out by hand: a process has 19 MB.
TEST(TaskCost, is_so_many_bytes_for_each_element_triangle_and_byte_read) {
  const SubdomainSize size{1e6, 1e5, 2e6, 50};
  EXPECT_NEAR(inspect_cost(3e6, size).bytes, (19 + 8 + 1.2 * 3 + 2.5 * 2 + 22) * megabyte, 1);
  EXPECT_NEAR(decompose_cost(size).bytes, (19 + 13 + 2 + 1 + 26) * megabyte, 1);
  EXPECT_NEAR(mesh_cost(size).bytes, (19 + 2 + 2 + 330 * 1.15 + 70) * megabyte, 1);
  EXPECT_NEAR(assimilate_cost(1e5, 2e4).bytes, (19 + 0.8 + 10) * megabyte, 1);
  EXPECT_NEAR(order_cost(1e5, 2e4).bytes, (19 + 3.2 + 4) * megabyte, 1);
  EXPECT_NEAR(extract_cost(1e6, 1e5).bytes, (19 + 190 + 20) * megabyte, 1);
  EXPECT_NEAR(cosmetic_cost(1e6, 2e6).bytes, (19 + 4 + 2 + 360) * megabyte, 1);
  EXPECT_NEAR(number_cost(1e5).bytes, (19 + 11) * megabyte, 1);
  EXPECT_NEAR(write_cost(1e6).bytes, (19 + 4 + 150) * megabyte, 1);
  EXPECT_NEAR(assemble_cost(1e5, 5e6, size).bytes, (19 + 4 + 130 * 1.15 + 25) * megabyte, 1)
      << "of all elements those of the largest part are in memory";
}

TEST(TaskCost, is_expected_to_take_what_tasks_of_that_kind_and_size_take) {
  const SubdomainSize size{1e6, 1e5, 2e6, 50};
  const auto expect = [](const TaskCost& cost, TaskKind kind, const TaskSize& task) {
    EXPECT_EQ(cost.kind, kind);
    EXPECT_EQ(cost.size.elements, task.elements) << name_of(kind);
    EXPECT_EQ(cost.size.triangles, task.triangles) << name_of(kind);
    EXPECT_EQ(cost.size.needles, task.needles) << name_of(kind);
    EXPECT_EQ(cost.seconds, usual_seconds(kind, task).expected) << name_of(kind);
  };
  expect(inspect_cost(3e6, size), TaskKind::inspect, {1e6, 1e5, 50});
  expect(decompose_cost(size), TaskKind::decompose, {1e6, 1e5, 50});
  expect(mesh_cost(size), TaskKind::mesh, {1e6, 1e5, 50});
  expect(assimilate_cost(1e5, 2e4), TaskKind::assimilate, {0, 1e5, 0});
  expect(order_cost(1e5, 2e4), TaskKind::order, {0, 1e5, 0});
  expect(extract_cost(1e6, 1e5), TaskKind::extract, {1e6, 1e5, 0});
  expect(cosmetic_cost(1e6, 2e6), TaskKind::cosmetic, {1e6, 0, 0});
  expect(number_cost(1e5), TaskKind::number, {0, 1e5, 0});
  expect(write_cost(1e6), TaskKind::write, {1e6, 0, 0});
  expect(grow_cost(1e6), TaskKind::grow, {1e6, 0, 0});
  expect(assemble_cost(1e5, 5e6, size), TaskKind::assemble, {5e6, 1e5, 0});
}

TEST(TaskCost, of_a_leaf_is_that_of_its_largest_task) {
  EXPECT_EQ(turn_elements({1000, 100}), 2300) << "23 for each triangle";
  EXPECT_EQ(turn_elements({100, 100}), 250) << "or two and a half for each of its own";
  // (330 * 1.15 * 1e6 + 700 * 1e3) against 360 * 23e3 against (190 * 1.15 * 1e6 + 200 * 1e3)
  EXPECT_NEAR(leaf_bytes({1e6, 1e3, 2e6}), (19 + 2 + 2 + 379.5 + 0.7) * megabyte, 1);
  EXPECT_NEAR(leaf_bytes({1e4, 1e3, 2e6}), (19 + 4 + 2 + 360 * 0.023) * megabyte, 1);
  EXPECT_NEAR(leaf_bytes({1e4, 1e3, 2e6}), cosmetic_cost(23'000, 2e6).bytes, 1);
}

TEST(TaskCost, leaves_have_more_triangles_than_the_surface_the_more_there_are) {
  EXPECT_NEAR(triangles_of_leaves({1e6, 500}, 1), 500 + 3.33 * 1e4, 1e-6);
  EXPECT_NEAR(triangles_of_leaves({1e6, 500}, 8), 500 + 3.33 * 2 * 1e4, 1e-6);
  EXPECT_NEAR(triangles_of_leaves({8e6, 500}, 8), 500 + 3.33 * 2 * 4e4, 1e-6);
}

TEST(TaskCost, parts_share_what_a_leaf_has_beside_its_fixed_part) {
  const SubdomainSize size{1e6, 1e3, 2e6};
  const double fixed = leaf_bytes({0, 0, 2e6});
  const double rest = leaf_bytes(size) - fixed;
  EXPECT_EQ(parts_for_memory(size, fixed + rest / 3.5), 4);
  EXPECT_EQ(parts_for_memory(size, fixed + rest / 4.5), 5);
  EXPECT_EQ(parts_for_memory(size, fixed), 1'000'000);
  EXPECT_EQ(parts_for_memory(size, fixed + rest / 5e6), 1'000'000);
}

TEST(TaskCost, the_least_memory_is_that_of_the_largest_task_that_does_not_shrink) {
  EXPECT_EQ(least_memory(1e9, {1e6, 1e3, 1e6}), inspect_cost(1e9, {1e6, 1e3, 1e6}).bytes);
  EXPECT_EQ(least_memory(0, {1e8, 1e5, 0}), decompose_cost({1e8, 1e5, 0}).bytes);
  EXPECT_EQ(least_memory(0, {0, 0, 0}), 19 * megabyte / 2 + leaf_bytes({}))
      << "half a process for what a leaf is made of";
}

TEST(TaskCost, counts_triangles_and_needles_of_a_sub_domain) {
  Subdomain subdomain;
  subdomain.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1e-6, 0}};
  subdomain.triangles = {{0, 1, 2}, {0, 1, 3}};
  const SubdomainSize size = size_of(subdomain, 77, {"hash", 4000});
  EXPECT_EQ(size.elements, 77);
  EXPECT_EQ(size.triangles, 2);
  EXPECT_EQ(size.spacing_bytes, 4000);
  EXPECT_EQ(size.needles, 1);
}

TEST(TaskCost, is_reported_with_the_result) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const wire::Assign assign;
  TaskIo io(store, assign, [](const wire::Doing&) {});
  TaskCost cost;
  cost.bytes = 1;
  cost.seconds = 2;
  cost.size = {3, 4, 5};
  report_cost(io, cost);
  using testing::Pair;
  EXPECT_THAT(io.done().numbers(),
              testing::UnorderedElementsAre(Pair("expected_bytes", 1), Pair("expected_seconds", 2),
                                            Pair("size_elements", 3), Pair("size_triangles", 4),
                                            Pair("size_needles", 5)));
}

}  // namespace
}  // namespace tetfarm
