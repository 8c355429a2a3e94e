#include "mesh/assemble/face_balance.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace tetfarm
