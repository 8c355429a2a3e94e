#include "mesh/arrangement/constrained_triangulation.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <set>

namespace tetfarm {
namespace {

std::set<Segment> edges_of(const std::vector<Triangle>& triangles) {
  std::set<Segment> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t[k];
      const std::int32_t b = t[(k + 1) % 3];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return edges;
}

TEST(ConstrainedTriangulation, fills_a_square_with_random_segments_that_are_all_edges) {
  for (int seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    ExactPoints points;
    // A coarse grid: many points on one line, many segments along each other.
    const auto any = [&] {
      return points.add(
          exact_point({static_cast<double>(random() % 9), static_cast<double>(random() % 9), 7}));
    };
    const auto corner = [&](double x, double y) { return points.add(exact_point({x, y, 7})); };
    const std::array<std::int32_t, 4> square = {corner(0, 0), corner(8, 0), corner(8, 8),
                                                corner(0, 8)};
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < 4; ++k) segments.push_back({square[k], square[(k + 1) % 4]});
    for (int i = 0; i < 12; ++i) segments.push_back({any(), any()});
    std::int64_t pairs_left = 10'000;
    const auto pieces = divide_segments(points, segments, 2, pairs_left).value();
    std::vector<std::int32_t> nodes(static_cast<std::size_t>(points.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = static_cast<std::int32_t>(n);
    const std::vector<Triangle> triangles = triangulate(points, nodes, pieces, 2).value();
    mpq_class area;
    for (const Triangle& t : triangles) {
      EXPECT_EQ(seen_turn(points[t[0]], points[t[1]], points[t[2]], 2), 1);
      area += seen_area(points[t[0]], points[t[1]], points[t[2]], 2);
    }
    EXPECT_EQ(area, 128) << "twice the area";
    const std::set<Segment> edges = edges_of(triangles);
    for (const Segment& piece : pieces) EXPECT_TRUE(edges.contains(piece));
  }
}

TEST(ConstrainedTriangulation, takes_the_diagonal_that_makes_better_triangles) {
  ExactPoints points;
  const std::int32_t a = points.add(exact_point({0, 0, 0}));
  const std::int32_t b = points.add(exact_point({3, -1, 0}));
  const std::int32_t c = points.add(exact_point({6, 0, 0}));
  const std::int32_t d = points.add(exact_point({3, 1, 0}));
  const std::vector<Segment> border = {{a, b}, {b, c}, {c, d}, {a, d}};
  EXPECT_TRUE(
      edges_of(triangulate(points, {a, b, c, d}, border, 2).value()).contains(Segment{b, d}));
  std::vector<Segment> with_diagonal = border;
  with_diagonal.push_back({a, c});
  EXPECT_TRUE(edges_of(triangulate(points, {a, b, c, d}, with_diagonal, 2).value())
                  .contains(Segment{a, c}));
}

}  // namespace
}  // namespace tetfarm
