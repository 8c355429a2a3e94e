#include "mesh/adaptation/mesh_location.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/mesh/adaptation/transfer_shapes.h"

namespace tetfarm {
namespace {

Vec2 place_of(const TriangleComplex& complex, const PlaneLocation& location) {
  Vec2 place;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& p = complex.point(complex.nodes(location.triangle)[i]);
    place.x += location.weights[i] * p.x;
    place.y += location.weights[i] * p.y;
  }
  return place;
}

double distance_between(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Of the closest place of any border edge, by trying all.
double distance_from_border(const TriangleComplex& complex, const Vec2& p) {
  double distance = HUGE_VAL;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) != no_edge) continue;
      const Vec2& a = complex.point(complex.node(t, next(i)));
      const Vec2& b = complex.point(complex.node(t, previous(i)));
      const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      const double share =
          std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square, 0.0, 1.0);
      distance = std::min(
          distance, distance_between({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}, p));
    }
  }
  return distance;
}

TEST(MeshLocation, finds_points_inside_from_any_triangle) {
  const PlaneMesh mesh = plane_test::square_with_hole(0.3, 8, 6);
  const TriangleComplex complex = checked_complex(mesh);
  const MeshLocation location(complex);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-1, 1);
  std::uniform_int_distribution<std::int32_t> hint(0, complex.size() - 1);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 p{place(random), place(random)};
    if (std::hypot(p.x, p.y) < 0.3) continue;
    const PlaneLocation found = location.locate(p, hint(random));
    EXPECT_EQ(found.distance, 0);
    EXPECT_LT(distance_between(place_of(complex, found), p), 1e-14);
    for (const double weight : found.weights) EXPECT_GE(weight, 0);
  }
}

TEST(MeshLocation, takes_the_closest_place_of_the_border_for_points_outside) {
  const PlaneMesh mesh = plane_test::ell(3);
  const TriangleComplex complex = checked_complex(mesh);
  const MeshLocation location(complex);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-3, 5);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 p{place(random), place(random)};
    const bool is_inside = p.x >= 0 && p.y >= 0 && p.x <= 2 && p.y <= 2 && (p.x <= 1 || p.y <= 1);
    if (is_inside) continue;
    const PlaneLocation found = location.locate(p, 0);
    EXPECT_NEAR(found.distance, distance_from_border(complex, p), 1e-14);
    EXPECT_NEAR(distance_between(place_of(complex, found), p), found.distance, 1e-14);
  }
}

TEST(MeshLocation, is_not_held_up_by_distances_of_any_size) {
  const PlaneMesh mesh = plane_test::square(3);
  const TriangleComplex complex = checked_complex(mesh);
  const MeshLocation location(complex);
  EXPECT_DOUBLE_EQ(location.locate({1e50, 0.5}, 0).distance, 1e50);
  EXPECT_DOUBLE_EQ(location.locate({0.5, -1e-50}, 0).distance, 1e-50);
}

TEST(MeshLocation, finds_nodes_and_middles_of_edges_of_its_own_mesh_inside) {
  const PlaneMesh mesh = plane_test::disc(5);
  const TriangleComplex complex = checked_complex(mesh);
  const std::vector<PlaneLocation> places = locate_nodes(MeshLocation(complex), complex);
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_EQ(places[v].distance, 0);
    EXPECT_LT(distance_between(place_of(complex, places[v]), mesh.points[v]), 1e-15);
  }
}

/// A strip of two cells above a wall of the given thickness, and one below it, joined at the left.
PlaneMesh round_a_thin_wall(double thickness) {
  PlaneMesh mesh;
  const double up = thickness / 2;
  mesh.points = {{0, up},  {1, up},  {2, up}, {0, 1},  {1, 1},  {2, 1},  {0, -up},
                 {1, -up}, {2, -up}, {0, -1}, {1, -1}, {2, -1}, {-1, 1}, {-1, -1}};
  mesh.triangles = {{0, 1, 3},  {1, 4, 3},   {1, 2, 4},   {2, 5, 4},  {9, 7, 6},  {9, 10, 7},
                    {10, 8, 7}, {10, 11, 8}, {12, 13, 0}, {12, 0, 3}, {13, 9, 6}, {13, 6, 0}};
  mesh.regions.assign(mesh.triangles.size(), 0);
  return mesh;
}

TEST(MeshLocation, keeps_to_its_side_of_a_wall_thinner_than_the_border_is_off) {
  const TriangleComplex complex = checked_complex(round_a_thin_wall(0.01));
  const MeshLocation location(complex);
  // Each point is 0.02 beyond its wall: in the domain on the other side.
  const PlaneLocation of_upper = location.locate_on_border({1.5, -0.015}, {{0, 1}, 0.3}, 0);
  EXPECT_NEAR(place_of(complex, of_upper).y, 0.005, 1e-15);
  EXPECT_NEAR(of_upper.distance, 0.02, 1e-15);
  const PlaneLocation of_lower = location.locate_on_border({1.5, 0.015}, {{0, -1}, 0.3}, 0);
  EXPECT_NEAR(place_of(complex, of_lower).y, -0.005, 1e-15);
  // In the wall, nearer to the other side.
  const PlaneLocation within = location.locate_on_border({0.5, 0.004}, {{0, -1}, 0.3}, 0);
  EXPECT_NEAR(place_of(complex, within).y, -0.005, 1e-15);
}

TEST(MeshLocation, takes_a_node_of_the_border_that_is_inside_as_it_is) {
  const TriangleComplex complex = checked_complex(round_a_thin_wall(0.01));
  const MeshLocation location(complex);
  const PlaneLocation above = location.locate_on_border({1.5, 0.01}, {{0, 1}, 0.3}, 0);
  EXPECT_EQ(above.distance, 0);
  EXPECT_NEAR(place_of(complex, above).y, 0.01, 1e-15);
  // Far from any border that looks its way: another geometry, not the same a little off.
  const PlaneLocation far = location.locate_on_border({1.5, -0.9}, {{0, 1}, 0.001}, 0);
  EXPECT_EQ(far.distance, 0);
}

TEST(MeshLocation, puts_each_node_of_a_finer_circle_on_the_chord_beside_it) {
  const PlaneMesh coarse = plane_test::square_with_hole(0.3, 3, 4);
  const PlaneMesh fine = plane_test::square_with_hole(0.3, 8, 9);
  const TriangleComplex complex = checked_complex(coarse);
  const std::vector<PlaneLocation> places =
      locate_nodes(MeshLocation(complex), checked_complex(fine));
  // The sagitta of a twelfth of the circle.
  const double sagitta = 0.3 * (1 - std::cos(std::numbers::pi / 12));
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_LE(places[v].distance, sagitta * 1.001);
    EXPECT_NEAR(distance_between(place_of(complex, places[v]), fine.points[v]), places[v].distance,
                1e-15);
  }
}

}  // namespace
}  // namespace tetfarm
