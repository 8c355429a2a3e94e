// Meshes of planar regions, known by their digests (tests/golden/planar.txt).
#include <gtest/gtest.h>

#include "mesh/planar/constrained_delaunay.h"
#include "mesh/planar/edge_flips.h"
#include "mesh/planar/edge_recovery.h"
#include "mesh/planar/point_insertion.h"
#include "mesh/planar/restricted_cavity.h"
#include "mesh/planar/smoothing.h"
#include "tests/mesh/planar/regions.h"
#include "tests/support/chance.h"
#include "tests/support/result_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void add_points(ResultDigest& result, const std::vector<Vec2>& points) {
  result.add(points.size());
  for (const Vec2& p : points) result.add(p.x, p.y);
}

void add_complex(ResultDigest& result, const TriangleComplex& complex) {
  add_points(result, complex.points);
  result.add(complex.triangles, complex.neighbours, complex.constrained, complex.node2triangle);
}

/// A star of so many points by chance, about the origin.
std::vector<Vec2> star(int corners, std::uint64_t seed, double size) {
  shapes::Chance chance(seed);
  // Directions that turn anticlockwise, by the perimeter of a square.
  std::vector<Vec2> loop;
  for (int i = 0; i < corners; ++i) {
    const double along = 8.0 * i / corners;
    const Vec2 p = along < 2   ? Vec2{1, along - 1}
                   : along < 4 ? Vec2{3 - along, 1}
                   : along < 6 ? Vec2{-1, 5 - along}
                               : Vec2{along - 7, -1};
    const double radius = size * chance.between(0.3, 1);
    loop.push_back({radius * p.x, radius * p.y});
  }
  return loop;
}

std::vector<Vec2> backwards(std::vector<Vec2> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

PlanarRegion region_with_hole(std::uint64_t seed) {
  PlanarRegion region;
  planar_test::add_loop(region, star(29, seed, 1));
  planar_test::add_loop(region, backwards(star(13, seed + 50, 0.25)));
  region.points.push_back({0.27, 0.02});  // of no edge
  region.points.push_back({5, 5});
  return region;
}

double graded(const Vec2& p) { return 0.08 + 0.1 * (p.x + 1); }

TEST(PlanarResults, of_regions_are_known) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const PlanarRegion region = region_with_hole(seed);
    ResultDigest result;
    const ConstrainedDelaunay coarse = constrained_delaunay(region);
    result.add(coarse.failure.has_value());
    add_complex(result, coarse.complex);
    PlanarOptions options;
    options.forbidden_chords = {{0, 2}, {3, 6}, {1, 30}, {7, 33}};
    for (const PlanarOptions& asked : {PlanarOptions{}, options}) {
      const PlanarResult made = mesh_region(region, graded, asked);
      result.add(made.failure.has_value(), made.mesh.triangles);
      add_points(result, made.mesh.points);
    }
    test::expect_known("planar", "region_" + std::to_string(seed), result);
  }
  ResultDigest even;
  const PlanarRegion square = planar_test::rectangle({0, 0}, {2, 1}, 8);
  const PlanarResult made = mesh_region(square, [](const Vec2&) { return 0.11; });
  even.add(made.mesh.triangles);
  add_points(even, made.mesh.points);
  test::expect_known("planar", "rectangle", even);
}

TEST(PlanarResults, of_single_steps_are_known) {
  TriangleComplex complex = constrained_delaunay(region_with_hole(2)).complex;
  ResultDigest result;
  result.add(estimated_triangles(complex, graded));
  result.add(insert_points(complex, graded, 5000));
  add_complex(result, complex);
  result.add(smooth(complex, 44));
  add_complex(result, complex);
  result.add(flip_to_delaunay(complex));
  add_complex(result, complex);
  Cavity cavity;
  for (const Vec2& p : {Vec2{0.41, 0.1}, Vec2{-0.4, 0.33}, Vec2{0.1, -0.4}}) {
    const auto holder = locate(complex, 0, p);
    result.add(holder.has_value());
    if (!holder) continue;
    result.add(*holder, find_cavity(complex, *holder, p, cavity), cavity.triangles);
    for (const Cavity::RimEdge& edge : cavity.rim) {
      result.add(edge.from, edge.to, edge.outside, edge.is_constrained);
    }
  }
  test::expect_known("planar", "steps", result);
}

TEST(PlanarResults, of_recovered_edges_are_known) {
  // Scattered points in a square, and edges between those that are far apart.
  PlanarRegion region = planar_test::rectangle({0, 0}, {1, 1}, 1);
  shapes::Chance chance(7);
  for (int i = 0; i < 40; ++i) {
    const double x = chance.between(0.02, 0.98);
    region.points.push_back({x, chance.between(0.02, 0.98)});
  }
  TriangleComplex complex = constrained_delaunay(region).complex;
  ResultDigest result;
  for (std::int32_t a = 4; a < 20; ++a) {
    const auto failure = recover_edge(complex, a, 44 - a);
    result.add(failure.has_value());
    if (!failure) continue;
    result.add(failure->reason);
    add_points(result, failure->where);
  }
  result.add(flip_to_delaunay(complex));
  add_complex(result, complex);
  test::expect_known("planar", "edges", result);
}

TEST(PointInsertion, takes_as_many_triangles_as_are_allowed_and_no_more) {
  const TriangleComplex coarse = constrained_delaunay(region_with_hole(2)).complex;
  TriangleComplex complex = coarse;
  ASSERT_TRUE(insert_points(complex, graded, 100000));
  const std::int64_t triangles = complex.size();
  complex = coarse;
  EXPECT_TRUE(insert_points(complex, graded, triangles));
  complex = coarse;
  EXPECT_FALSE(insert_points(complex, graded, triangles - 1));
}

}  // namespace
}  // namespace tetfarm
