#include "mesh/recovery/steiner_insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/array_index.h"
#include "tests/mesh/recovery/random_tets.h"

namespace tetfarm {
namespace {

/// The point's share of the way from a to b.
double share_on(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b, std::int32_t node) {
  const Vec3 along = mesh.point(b) - mesh.point(a);
  return dot(mesh.point(node) - mesh.point(a), along) / norm2(along);
}

/// How far the point, with all that it has beyond doubles, is from the plane through three others.
double height_over(const LocalRemeshing& mesh, const Triangle& plane, std::int32_t node) {
  return std::fabs(fine_orient3d(mesh.fine_point(plane[0]), mesh.fine_point(plane[1]),
                                 mesh.fine_point(plane[2]), mesh.fine_point(node))
                       .high);
}

TEST(SteinerInsertion, splits_missing_edges_where_something_crosses_them_and_keeps_tets_valid) {
  int inserted = 0;
  int whole = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomTets tets(60, seed);
    const double volume = volume_of(tets.complex);
    const RecoverySurface no_surface({}, 60);
    for (std::int32_t b = 1; b < 12; ++b) {
      const SegmentWalk walk = walk_segment(tets.mesh, 0, b);
      if (walk.crossings.empty()) continue;
      const std::int32_t node = insert_on_edge(tets.mesh, no_surface, {0, b}, walk);
      ASSERT_EQ(node, std::ssize(tets.complex.points) - 1);
      ++inserted;
      const double share = share_on(tets.mesh, 0, b, node);
      EXPECT_GT(share, 0);
      EXPECT_LT(share, 1);
      EXPECT_FALSE(tets.mesh.fine_point(node).is_plain());
      for (std::int32_t v = 20; v < 25; ++v) {
        EXPECT_LT(height_over(tets.mesh, {0, b, v}, node), 1e-28);
      }
      if (walk.crossings.size() == 1) {
        ++whole;
        EXPECT_GE(tets.mesh.find_edge(0, node), 0);
        EXPECT_GE(tets.mesh.find_edge(node, b), 0);
      }
    }
    EXPECT_TRUE(validate(tets.complex).empty());
    EXPECT_NEAR(volume_of(tets.complex), volume, 1e-9 * volume);
  }
  EXPECT_GT(inserted, 40);
  EXPECT_GT(whole, 2);
}

TEST(SteinerInsertion, takes_the_crossing_in_the_middle) {
  // A stack of tets along z between three rails, crossed one after the other.
  TetMesh stack;
  constexpr std::int32_t levels = 6;
  for (std::int32_t i = 0; i < levels; ++i) {
    stack.nodes.push_back({0, 0, static_cast<double>(i)});
    stack.nodes.push_back({3, 0, static_cast<double>(i)});
    stack.nodes.push_back({0, 3, static_cast<double>(i)});
  }
  stack.nodes.push_back({1, 1, -1});
  stack.nodes.push_back({1, 1, static_cast<double>(levels)});
  const std::int32_t low = 3 * levels;
  for (std::int32_t i = 0; i + 3 < low; ++i) stack.tets.push_back({i, i + 1, i + 2, i + 3});
  stack.tets.push_back({0, 2, 1, low});
  stack.tets.push_back({low - 3, low - 2, low - 1, low + 1});
  for (Tet& t : stack.tets) {
    const auto p = [&](std::size_t i) { return stack.nodes[at(t[i])]; };
    if (tet_volume(p(0), p(1), p(2), p(3)) < 0) std::swap(t[0], t[1]);
  }
  TetComplex complex = make_tet_complex(stack);
  ASSERT_TRUE(validate(complex).empty());
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  const SegmentWalk walk = walk_segment(mesh, low, low + 1);
  const std::size_t crossings = walk.crossings.size();
  ASSERT_GT(crossings, 10U);
  const std::array<std::int32_t, 3> middle = complex.face_nodes(walk.crossings[crossings / 2].face);
  const RecoverySurface no_surface({}, low + 2);
  const std::int32_t node = insert_on_edge(mesh, no_surface, {low, low + 1}, walk);
  ASSERT_GE(node, 0);
  EXPECT_LT(height_over(mesh, middle, node), 1e-28);
  EXPECT_EQ(mesh.find_face(middle[0], middle[1], middle[2]), no_face);
  for (const std::int32_t v : middle) EXPECT_GE(mesh.find_edge(v, node), 0);
  EXPECT_TRUE(validate(complex).empty());
}

TEST(SteinerInsertion, leaves_constrained_faces_whole_and_splits_a_tet_beside_them) {
  // Two tets over one face, which the edge between their tips crosses.
  TetMesh pair;
  pair.nodes = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}};
  pair.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  for (const bool is_constrained : {false, true}) {
    TetComplex complex = make_tet_complex(pair);
    std::vector<std::uint8_t> constrained;
    LocalRemeshing mesh(complex, constrained);
    if (is_constrained) mesh.constrain(mesh.find_face(0, 1, 2), true);
    const RecoverySurface no_surface({}, 5);
    const std::int32_t node = insert_on_edge(mesh, no_surface, {3, 4}, walk_segment(mesh, 3, 4));
    ASSERT_EQ(node, 5);
    EXPECT_TRUE(validate(complex).empty());
    EXPECT_EQ(mesh.find_face(0, 1, 2) != no_face, is_constrained);
    if (is_constrained) {
      EXPECT_TRUE(mesh.is_constrained(mesh.find_face(0, 1, 2)));
      EXPECT_EQ(std::fabs(mesh.point(node).z), 0.5);
      EXPECT_EQ(complex.live_tets(), 5U);
    } else {
      EXPECT_EQ(mesh.point(node), (Vec3{1, 1, 0}));
      EXPECT_EQ(complex.live_tets(), 6U);
    }
  }
}

/// A triangle, nodes 2 to 4, that the edge of the nodes 0 and 1 goes through, with four nodes far
/// round them.
TetComplex pierced_triangle() {
  return bowyer_watson({{{0.1, 0, -0.7}, {0.1, 0, 0.7}, {1, 0, 0}, {-0.5, 1, 0}, {-0.5, -1, 0}}})
      .complex;
}

TEST(SteinerInsertion, makes_a_pierced_face_of_three_parts_where_the_edge_goes_through) {
  TetComplex complex = pierced_triangle();
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  ASSERT_EQ(mesh.ring(0, 1)->apexes.size(), 3U);
  const std::size_t tets = complex.live_tets();
  const std::int32_t node = insert_on_face(mesh, RecoverySurface({}, 5), {2, 3, 4});
  ASSERT_EQ(node, std::ssize(complex.points) - 1);
  EXPECT_EQ(mesh.point(node), (Vec3{0.1, 0, 0}));
  EXPECT_EQ(complex.live_tets(), tets + 3);
  EXPECT_TRUE(validate(complex).empty());
  for (const auto& [a, b] : {std::array{2, 3}, std::array{3, 4}, std::array{4, 2}}) {
    EXPECT_NE(mesh.find_face(a, b, node), no_face);
  }
  EXPECT_LT(mesh.find_edge(0, 1), 0);
}

TEST(SteinerInsertion, has_no_room_on_a_face_when_all_tets_at_its_piercing_edge_are_held_apart) {
  TetComplex complex = pierced_triangle();
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  mesh.constrain(mesh.find_face(0, 1, 2), true);
  const auto before = complex.nodes;
  const std::size_t points = complex.points.size();
  EXPECT_EQ(insert_on_face(mesh, RecoverySurface({}, 5), {2, 3, 4}), -1);
  EXPECT_EQ(complex.nodes, before);
  EXPECT_EQ(complex.points.size(), points);
}

}  // namespace
}  // namespace tetfarm
