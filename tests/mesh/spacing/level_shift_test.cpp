#include "mesh/spacing/level_shift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

namespace tetfarm {
namespace {

/// A root of eight leaves of level 1, of which some are divided once more.
SpacingOctree octree_with_divided(std::initializer_list<std::size_t> divided) {
  SpacingOctree octree;
  octree.child_of = {1};
  octree.child_of.resize(9);
  std::int32_t leaf = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    if (std::find(divided.begin(), divided.end(), k) == divided.end()) {
      octree.child_of[1 + k] = ~leaf++;
      octree.lattice_level.push_back(1);
      continue;
    }
    octree.child_of[1 + k] = static_cast<std::int32_t>(octree.child_of.size());
    for (int i = 0; i < 8; ++i) {
      octree.child_of.push_back(~leaf++);
      octree.lattice_level.push_back(2);
    }
  }
  return octree;
}

constexpr std::int32_t half = octree_span / 2;
constexpr std::int32_t quarter = octree_span / 4;
using Shift = std::array<std::int8_t, 3>;

TEST(LevelShift, is_none_where_no_larger_cell_is_near) {
  const SpacingOctree octree = octree_with_divided({0});
  EXPECT_EQ(shift_to_coarser(octree, {quarter, quarter, quarter}, 2), (Shift{0, 0, 0}));
  EXPECT_EQ(shift_to_coarser(octree, {0, 0, 0}, 2), (Shift{0, 0, 0}));
  EXPECT_EQ(shift_to_coarser(octree, {0, quarter, quarter}, 2), (Shift{0, 0, 0}));
  EXPECT_EQ(shift_to_coarser(octree_with_divided({}), {half, half, half}, 1), (Shift{0, 0, 0}));
}

TEST(LevelShift, of_the_middle_of_a_larger_face_is_towards_it) {
  // Four of the eight octants round the corner are the larger cell's, each of which pulls by 5.
  const SpacingOctree octree = octree_with_divided({0});
  EXPECT_EQ(shift_to_coarser(octree, {half, quarter, quarter}, 2), (Shift{20, 0, 0}));
  EXPECT_EQ(shift_to_coarser(octree, {quarter, half, quarter}, 2), (Shift{0, 20, 0}));
  EXPECT_EQ(shift_to_coarser(octree, {quarter, quarter, half}, 2), (Shift{0, 0, 20}));
}

TEST(LevelShift, of_the_middle_of_a_larger_edge_is_towards_all_larger_cells_at_it) {
  // Six of the eight octants round the corner are larger cells': four lie ahead along x, two
  // behind.
  const SpacingOctree octree = octree_with_divided({0});
  EXPECT_EQ(shift_to_coarser(octree, {half, half, quarter}, 2), (Shift{10, 10, 0}));
  EXPECT_EQ(shift_to_coarser(octree, {quarter, half, half}, 2), (Shift{0, 10, 10}));
}

TEST(LevelShift, of_a_corner_of_larger_cells_is_by_seven_for_each) {
  const SpacingOctree octree = octree_with_divided({0});
  EXPECT_EQ(shift_to_coarser(octree, {half, half, half}, 2), (Shift{7, 7, 7}));
  EXPECT_EQ(shift_to_coarser(octree_with_divided({7}), {half, half, half}, 2), (Shift{-7, -7, -7}));
  EXPECT_EQ(shift_to_coarser(octree_with_divided({0, 1, 2, 3}), {half, half, half}, 2),
            (Shift{0, 0, 28}));
}

TEST(LevelShift, of_a_place_on_the_border_of_the_octree_looks_at_what_is_inside) {
  const SpacingOctree octree = octree_with_divided({0});
  EXPECT_EQ(shift_to_coarser(octree, {half, 0, quarter}, 2), (Shift{10, 10, 0}));
  EXPECT_EQ(shift_to_coarser(octree_with_divided({7}), {octree_span, half, half + quarter}, 2),
            (Shift{-10, -10, 0}));
}

}  // namespace
}  // namespace tetfarm
