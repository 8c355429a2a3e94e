#include "mesh/assemble/face_balance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

/// Two tets with a common face, as two parts; the second has its nodes in another order.
std::array<NumberedPart, 2> two_parts() {
  NumberedPart first;
  first.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  first.local2global = {0, 1, 2, 3};
  first.tets = {{0, 1, 2, 3}};
  first.faces = {{0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  NumberedPart second;
  second.nodes = {{1, 1, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  second.local2global = {4, 3, 1, 2};
  second.tets = {{2, 3, 1, 0}};
  second.faces = {{3, 1, 0}, {2, 0, 1}, {2, 3, 0}};
  return {first, second};
}

bool is_even(const std::array<NumberedPart, 2>& parts) {
  std::uint64_t sum = 0;
  for (const NumberedPart& part : parts) sum += face_sum_of(part);
  return sum == 0;
}

TEST(FaceBalance, is_even_when_every_face_has_its_other_side) { EXPECT_TRUE(is_even(two_parts())); }

TEST(FaceBalance, is_odd_when_a_part_is_missing_or_there_twice) {
  auto parts = two_parts();
  parts[1] = {};
  EXPECT_FALSE(is_even(parts));
  parts[1] = parts[0];
  EXPECT_FALSE(is_even(parts));
}

TEST(FaceBalance, notices_one_bit_of_a_shared_node_and_a_wrong_number) {
  for (double Vec3::*coordinate : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    auto parts = two_parts();
    double& moved = parts[1].nodes[2].*coordinate;
    moved = std::nextafter(moved, 9);
    EXPECT_FALSE(is_even(parts));
  }
  auto parts = two_parts();
  std::swap(parts[1].local2global[1], parts[1].local2global[2]);
  EXPECT_FALSE(is_even(parts));
}

TEST(FaceBalance, notices_a_boundary_triangle_that_is_turned_or_missing) {
  auto parts = two_parts();
  std::swap(parts[0].faces[1][0], parts[0].faces[1][1]);
  EXPECT_FALSE(is_even(parts));
  parts = two_parts();
  parts[1].faces.pop_back();
  EXPECT_FALSE(is_even(parts));
}

TEST(FaceBalance, notices_that_both_sides_run_the_same_way) {
  auto parts = two_parts();
  std::swap(parts[1].tets[0][0], parts[1].tets[0][1]);
  for (Triangle& face : parts[1].faces) std::swap(face[0], face[1]);
  EXPECT_FALSE(is_even(parts));
}

std::uint64_t sum_of(const HybridGrid& grid) {
  std::uint64_t sum = 0;
  for (const NumberedPart& part : grid.parts) sum += face_sum_of(part);
  return sum;
}

TEST(FaceBalance, is_even_for_cells_of_every_type_however_they_are_cut) {
  for (const int slabs : {1, 2, 4}) EXPECT_EQ(sum_of(HybridGrid(4, slabs)), 0U) << slabs;
}

TEST(FaceBalance, notices_a_cell_of_any_type_that_is_turned_or_missing) {
  for (const ElementType type : cell_block_types) {
    HybridGrid turned(4, 2);
    ElementBlock& block = turned.parts[1].blocks[type];
    ASSERT_FALSE(block.empty());
    std::swap(block.nodes[0], block.nodes[1]);
    EXPECT_NE(sum_of(turned), 0U);
    HybridGrid cut(4, 2);
    ElementBlock& shorter = cut.parts[1].blocks[type];
    shorter.nodes.resize(shorter.nodes.size() - nodes_of(type));
    shorter.regions.pop_back();
    EXPECT_NE(sum_of(cut), 0U);
  }
}

TEST(FaceBalance, notices_a_quad_whose_corners_are_paired_otherwise) {
  HybridGrid grid(4, 2);
  ElementBlock& quads = grid.parts[0].blocks[ElementType::quad];
  std::rotate(quads.nodes.begin(), quads.nodes.begin() + 1, quads.nodes.begin() + 4);
  EXPECT_EQ(sum_of(grid), 0U) << "it may begin anywhere";
  std::swap(quads.nodes[1], quads.nodes[2]);
  EXPECT_NE(sum_of(grid), 0U);
}

}  // namespace
}  // namespace tetfarm
