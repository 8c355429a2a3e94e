#include "mesh/recovery/recovery_guard.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

/// Points without tets, to ask guards about.
struct Points {
  explicit Points(std::vector<Vec3> places) : complex{std::move(places), {}, {}, {}, {}} {}
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh{complex, constrained};
};

TEST(RecoveryGuard, of_an_edge_counts_what_crosses_it_and_nothing_that_shares_an_end) {
  const Points p({{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {-1, 0, 0}});
  const auto guard = RecoveryGuard::of_edge(p.mesh, 0, 1);
  EXPECT_EQ(guard.crossings(2, 3, 4), 1);
  EXPECT_EQ(guard.crossings(3, 4, 5), 0);
  EXPECT_EQ(guard.crossings(0, 2, 3), 0);
  EXPECT_EQ(guard.crossings(2, 5), 1);
  EXPECT_EQ(guard.crossings(3, 4), 0);
  EXPECT_EQ(guard.crossings(0, 5), 0);
  EXPECT_EQ(RecoveryGuard::of_nothing(p.mesh).crossings(2, 3, 4), 0);
  EXPECT_EQ(RecoveryGuard::of_nothing(p.mesh).crossings(2, 5), 0);
}

TEST(RecoveryGuard, of_a_face_counts_edges_through_it_or_across_its_sides) {
  const Points p({{0, 0, 0},
                  {1, 0, 0},
                  {0, 1, 0},
                  {0.2, 0.2, 1},
                  {0.2, 0.2, -1},
                  {2, 2, -1},
                  {0.3, -1, 0},
                  {0.3, 0.2, 0}});
  const auto guard = RecoveryGuard::of_face(p.mesh, {0, 1, 2});
  EXPECT_EQ(guard.crossings(3, 4), 1);
  EXPECT_EQ(guard.crossings(3, 5), 0);
  EXPECT_EQ(guard.crossings(6, 7), 1);
  EXPECT_EQ(guard.crossings(0, 1), 0);
}

TEST(SegmentsCross, only_between_their_ends_and_in_one_plane) {
  const auto cross = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Points p({a, b, c, d});
    return segments_cross(p.mesh, 0, 1, 2, 3);
  };
  EXPECT_TRUE(cross({0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 1e-9}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}));
  EXPECT_FALSE(cross({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}));
}

TEST(SegmentsCross, no_triangle_that_they_only_touch) {
  const auto crosses = [](const Vec3& p, const Vec3& q) {
    const Points points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, p, q});
    return segment_crosses_triangle(points.mesh, 3, 4, {0, 1, 2});
  };
  EXPECT_TRUE(crosses({0.2, 0.2, -1}, {0.2, 0.2, 1}));
  EXPECT_TRUE(crosses({0.5, 0.5, -1}, {0.5, 0.5, 1}));
  EXPECT_FALSE(crosses({1, 0, -1}, {1, 0, 1}));
  EXPECT_FALSE(crosses({0.2, 0.2, 0}, {0.2, 0.2, 1}));
  EXPECT_FALSE(crosses({0.8, 0.8, -1}, {0.8, 0.8, 1}));
}

}  // namespace
}  // namespace tetfarm
