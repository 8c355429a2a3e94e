#include "worker/task_cost.h"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace tetfarm
