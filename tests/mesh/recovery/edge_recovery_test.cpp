#include "mesh/recovery/edge_recovery.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/face_recovery.h"

namespace tetfarm {
namespace {

std::vector<Vec3> points_of(std::size_t count, int grid, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = grid == 0 ? std::uniform_real_distribution<double>(0, 1)(random)
                          : std::uniform_int_distribution<int>(0, grid)(random);
    }
  }
  return points;
}

TEST(EdgeRecovery, most_edges_between_random_points_come_back_by_flips) {
  int tried = 0;
  int recovered = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    TetComplex complex = bowyer_watson(points_of(40, 0, seed)).complex;
    std::vector<std::uint8_t> constrained;
    LocalRemeshing mesh(complex, constrained);
    const RecoverySurface no_surface({}, 40);
    EdgeRemoval removal(mesh, no_surface);
    for (std::int32_t b = 1; b < 10; ++b) {
      if (mesh.find_edge(0, b) >= 0) continue;
      ++tried;
      removal.set_budget(3000);
      const bool is_back = recover_edge(mesh, removal, 0, b, 2);
      ASSERT_EQ(is_back, mesh.find_edge(0, b) >= 0);
      recovered += is_back ? 1 : 0;
    }
    ASSERT_TRUE(validate(complex).empty());
  }
  EXPECT_GT(tried, 50);
  EXPECT_GT(recovered, tried * 8 / 10);
}

TEST(EdgeRecovery, a_walk_counts_the_faces_between_its_ends_in_order) {
  TetComplex complex = bowyer_watson(points_of(200, 0, 1)).complex;
  std::vector<std::uint8_t> constrained;
  const LocalRemeshing mesh(complex, constrained);
  for (std::int32_t b = 1; b < 200; ++b) {
    const SegmentWalk there = walk_segment(mesh, 0, b);
    const SegmentWalk back = walk_segment(mesh, b, 0);
    ASSERT_EQ(there.is_edge, mesh.find_edge(0, b) >= 0);
    ASSERT_EQ(there.crossings.size(), back.crossings.size());
    ASSERT_EQ(there.crossings.empty(), there.is_edge);
  }
}

TEST(EdgeRecovery, a_walk_on_a_grid_meets_nodes_and_edges_exactly) {
  std::vector<Vec3> points;
  for (int i = 0; i < 27; ++i) points.push_back({i % 3 * 1.0, i / 3 % 3 * 1.0, i / 9 * 1.0});
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> constrained;
  const LocalRemeshing mesh(complex, constrained);
  EXPECT_EQ(walk_segment(mesh, 0, 2).node_on_it, 1);
  EXPECT_TRUE(walk_segment(mesh, 0, 1).is_edge);
  // One of the diagonals of each unit square is there; the other crosses it.
  const bool has = mesh.find_edge(0, 4) >= 0;
  const SegmentWalk other = has ? walk_segment(mesh, 1, 3) : walk_segment(mesh, 0, 4);
  ASSERT_EQ(other.crossings.size(), 1U);
  EXPECT_EQ(other.crossings.front().face, no_face);
}

TEST(EdgeRecovery, the_other_diagonals_of_a_grid_come_back) {
  std::vector<Vec3> points;
  for (int i = 0; i < 125; ++i) points.push_back({i % 5 * 1.0, i / 5 % 5 * 1.0, i / 25 * 1.0});
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  const RecoverySurface no_surface({}, 125);
  EdgeRemoval removal(mesh, no_surface);
  for (std::int32_t v = 0; v < 20; ++v) {
    if (v % 5 == 4) continue;
    for (const auto& [a, b] : {std::array{v, v + 6}, std::array{v + 1, v + 5}}) {
      removal.set_budget(1000);
      EXPECT_TRUE(recover_edge(mesh, removal, a, b, 2)) << a << " " << b;
    }
  }
  EXPECT_TRUE(validate(complex).empty());
}

TEST(FaceRecovery, faces_with_all_their_edges_come_back_when_pierced) {
  int pierced = 0;
  int recovered = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    TetComplex complex = bowyer_watson(points_of(30, 0, 100 + seed)).complex;
    std::vector<std::uint8_t> constrained;
    LocalRemeshing mesh(complex, constrained);
    for (std::int32_t a = 0; a < 30; ++a) {
      for (std::int32_t b = a + 1; b < 30; ++b) {
        for (std::int32_t c = b + 1; c < 30; ++c) {
          if (mesh.find_edge(a, b) < 0 || mesh.find_edge(b, c) < 0 || mesh.find_edge(a, c) < 0 ||
              mesh.find_face(a, b, c) != no_face || pierced > 200) {
            continue;
          }
          ++pierced;
          EXPECT_FALSE(piercing_edges(mesh, {a, b, c}).empty());
          const std::vector<Triangle> face = {{a, b, c}};
          const RecoverySurface surface(face, 30);
          EdgeRemoval removal(mesh, surface);
          removal.set_budget(2000);
          const bool is_back = recover_face(mesh, removal, face.front(), 2);
          ASSERT_EQ(is_back, mesh.find_face(a, b, c) != no_face);
          recovered += is_back ? 1 : 0;
        }
      }
    }
    ASSERT_TRUE(validate(complex).empty());
  }
  EXPECT_GT(pierced, 30);
  EXPECT_GT(recovered, pierced / 2);
}

}  // namespace
}  // namespace tetfarm
