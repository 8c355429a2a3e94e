#include "mesh/geometry/point_location.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

Vec3 random_point(std::mt19937_64& random, double size) {
  const auto coordinate = [&] { return size * static_cast<double>(random() >> 11U) * 0x1p-53; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  while (points.size() < count) points.push_back(random_point(random, 1));
  return points;
}

/// No face of the tet has the point outside.
bool holds(const TetComplex& complex, std::int32_t tet, const Vec3& point) {
  for (int face = 0; face < 4; ++face) {
    const auto [a, b, c] = complex.face_nodes(face_handle(tet, face));
    const auto place = [&](std::int32_t v) { return complex.points[static_cast<std::size_t>(v)]; };
    if (orient3d(place(a), place(b), place(c), point) > 0) return false;
  }
  return true;
}

TEST(PointLocation, finds_a_tet_that_holds_the_point_from_wherever_it_starts) {
  const TetComplex complex = bowyer_watson(random_points(200, 1)).complex;
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    std::int32_t start = 0;
    do {
      start = static_cast<std::int32_t>(random() % complex.nodes.size());
    } while (!complex.is_live(start));
    const Vec3 point = random_point(random, 1);
    const Location found = locate(complex, point, start);
    ASSERT_GE(found.tet, 0);
    EXPECT_EQ(found.node, -1);
    EXPECT_TRUE(complex.is_live(found.tet));
    EXPECT_TRUE(holds(complex, found.tet, point));
  }
}

TEST(PointLocation, knows_the_node_that_lies_in_the_very_place) {
  const TetComplex complex = bowyer_watson(random_points(200, 3)).complex;
  for (std::int32_t v = 0; v < 200; ++v) {
    const Vec3& place = complex.points[static_cast<std::size_t>(v)];
    const Location found = locate(complex, place, complex.node2tet[0]);
    EXPECT_EQ(found.node, v);
    EXPECT_GE(complex.local_node(found.tet, v), 0);
    // One bit beside it is no node.
    const Location beside =
        locate(complex, {std::nextafter(place.x, 2), place.y, place.z}, complex.node2tet[0]);
    EXPECT_EQ(beside.node, -1);
    EXPECT_GE(beside.tet, 0);
  }
}

TEST(PointLocation, on_faces_and_edges_of_a_grid_finds_one_of_the_tets_there) {
  std::vector<Vec3> grid;
  for (int i = 0; i < 64; ++i) grid.push_back({i % 4 * 1.0, i / 4 % 4 * 1.0, i / 16 * 1.0});
  const TetComplex complex = bowyer_watson(grid).complex;
  for (int i = 0; i < 343; ++i) {
    const Vec3 point{i % 7 * 0.5, i / 7 % 7 * 0.5, i / 49 * 0.5};
    const Location found = locate(complex, point, complex.node2tet[0]);
    ASSERT_GE(found.tet, 0);
    EXPECT_TRUE(holds(complex, found.tet, point));
    EXPECT_EQ(found.node >= 0, i % 7 % 2 == 0 && i / 7 % 7 % 2 == 0 && i / 49 % 2 == 0);
  }
}

TEST(PointLocation, finds_nothing_outside) {
  TetMesh one;
  one.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  one.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  one.boundary_nodes = 5;
  const TetComplex complex = make_tet_complex(one);
  ASSERT_TRUE(validate(complex).empty());
  for (const std::int32_t start : {0, 1}) {
    for (const Vec3& outside : {Vec3{-0.1, 0.2, 0.2}, Vec3{2, 2, 2}, Vec3{0.9, 0.9, 0}}) {
      EXPECT_EQ(locate(complex, outside, start).tet, -1);
    }
    EXPECT_EQ(locate(complex, {0.1, 0.1, 0.1}, start).tet, 0);
    EXPECT_EQ(locate(complex, {0.6, 0.6, 0.6}, start).tet, 1);
  }
}

}  // namespace
}  // namespace tetfarm
