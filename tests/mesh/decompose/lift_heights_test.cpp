#include "mesh/decompose/lift_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/array_index.h"
#include "mesh/decompose/intersection_repair.h"
#include "mesh/decompose/split_subdomain.h"
#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

TEST(RimAngles, bisector_halves_the_corner_of_a_cube) {
  const Subdomain cube = root_subdomain(shapes::unit_cube());
  const SurfaceTopology topology = make_surface_topology(cube);
  for (HalfEdge h = 0; h < static_cast<HalfEdge>(topology.twin.size()); ++h) {
    const RimEdge edge{end_of(cube.triangles, h), start_of(cube.triangles, h), triangle_of(h),
                       triangle_of(topology.twin[at(h)])};
    const RimCorner corner = rim_corner(cube, topology, edge);
    const bool is_flat = norm(corner.left_inward - corner.right_inward) < 1e-12;
    EXPECT_NEAR(cosine_at_bisector(corner), is_flat ? 0 : std::sqrt(0.5), 1e-12);
    const Vec3 middle = 0.5 * (cube.vertices[at(edge.from)] + cube.vertices[at(edge.to)]);
    EXPECT_GT(dot(bisector(corner), Vec3{0.5, 0.5, 0.5} - middle), 0);
    EXPECT_EQ(cosine_to_sides(corner, -bisector(corner)), 1);
  }
}

TEST(RimAngles, bisector_of_a_notch_points_into_the_material) {
  // The inner shell of a box in a box: the material fills 270 degrees round its edges.
  const SurfaceMesh hollow =
      shapes::between(shapes::box({-1, -1, -1}, {2, 2, 2}, 1), shapes::unit_cube());
  const Subdomain box = root_subdomain(hollow);
  const SurfaceTopology topology = make_surface_topology(box);
  for (HalfEdge h = 36; h < 72; ++h) {
    const RimEdge edge{end_of(box.triangles, h), start_of(box.triangles, h), triangle_of(h),
                       triangle_of(topology.twin[at(h)])};
    const RimCorner corner = rim_corner(box, topology, edge);
    const Vec3 middle = 0.5 * (box.vertices[at(edge.from)] + box.vertices[at(edge.to)]);
    EXPECT_LT(dot(bisector(corner), Vec3{0.5, 0.5, 0.5} - middle), 0);
    EXPECT_LT(cosine_at_bisector(corner), 1e-12);
  }
}

TEST(RimAngles, cosine_is_right_without_the_library) {
  for (const double degrees : {0.0, 8.0, 20.0, 30.0, 40.0, 45.0, 60.0, 90.0}) {
    EXPECT_NEAR(cosine_of_degrees(degrees), std::cos(degrees * 3.14159265358979323846 / 180),
                1e-15);
  }
}

TEST(InterdomainMesh, keeps_the_rim_and_fills_the_region) {
  const FlatCut cut = cap_of_sphere();
  double area = 0;
  for (const auto& [i, j, k] : cut.mesh.planar.triangles) {
    const Vec2& a = cut.mesh.planar.points[at(i)];
    const Vec2& b = cut.mesh.planar.points[at(j)];
    const Vec2& c = cut.mesh.planar.points[at(k)];
    area += 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  EXPECT_NEAR(area, 3.14 * (1 - 0.49), 0.15);
  for (std::size_t i = 0; i < cut.mesh.rim.size(); ++i) {
    EXPECT_EQ(node_position(cut.mesh, cut.subdomain, static_cast<std::int32_t>(i)),
              cut.subdomain.vertices[at(cut.mesh.rim[i].from)]);
  }
}

TEST(InterdomainMesh, has_no_chord_that_is_an_edge_of_the_surface) {
  // A spacing so large that the mesh would have chords everywhere.
  const FlatCut cut(shapes::box({0, 0, 0}, {1, 0.25, 1}, 4), make_cut_plane({0, 0, 1}, 0.4), 10);
  std::set<std::array<std::int32_t, 2>> surface;
  for (const Triangle& t : cut.subdomain.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      surface.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    }
  }
  ASSERT_FALSE(cut.mesh.planar.triangles.empty());
  int chords = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(cut.mesh.planar.triangles.size()); ++t) {
    for (const auto& [a, b] : chords_of_triangle(cut.mesh, t)) {
      ++chords;
      const auto [v, w] = std::minmax(cut.mesh.rim_vertices[at(a)], cut.mesh.rim_vertices[at(b)]);
      EXPECT_FALSE(surface.contains({v, w}));
    }
  }
  EXPECT_GT(chords, 0);
}

TEST(LiftHeights, meets_a_sphere_at_better_angles_than_the_plane) {
  FlatCut cut = cap_of_sphere();
  const double flat = cut.worst_cosine();
  lift_heights(cut.mesh, cut.corners, cut.weights(), {});
  EXPECT_GT(flat, cosine_of_degrees(45));
  EXPECT_LT(cut.worst_cosine(), cosine_of_degrees(50));
}

TEST(LiftHeights, leaves_a_flat_cut_of_a_box_flat) {
  FlatCut cut(shapes::box({0, 0, 0}, {1, 1, 1}, 4), make_cut_plane({1, 0, 0}, 0.5), 0.25);
  lift_heights(cut.mesh, cut.corners, cut.weights(), {});
  for (const double height : cut.mesh.heights) EXPECT_NEAR(height, 0, 1e-12);
}

TEST(LiftHeights, puts_pushed_nodes_where_they_are_pushed) {
  FlatCut cut = cap_of_sphere();
  std::vector<std::optional<double>> pushed(cut.mesh.heights.size());
  pushed.back() = 0.05;
  lift_heights(cut.mesh, cut.corners, cut.weights(), pushed);
  EXPECT_EQ(cut.mesh.heights.back(), 0.05);
}

TEST(IntersectionRepair, pushes_the_cut_off_a_plate_that_it_nearly_touches) {
  FlatCut cut = cut_at_plate(0.51, 0.6);
  std::vector<std::optional<double>> pushed;
  const auto nearby = find_nearby_surface(cut.mesh, cut.subdomain, cut.topology, 2);
  for (int i = 0; i < 4; ++i) {
    lift_heights(cut.mesh, cut.corners, cut.weights(), pushed);
    const auto contacts = find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4);
    if (i == 0) {
      EXPECT_EQ(judge_contacts(contacts), "clearance");
    }
    if (push_nodes(cut.mesh, cut.subdomain, cut.colours, contacts, pushed) == 0) break;
  }
  const auto contacts = find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4);
  EXPECT_EQ(judge_contacts(contacts), "");
  EXPECT_TRUE(
      shells_are_on_their_sides(cut.mesh, cut.subdomain, cut.colours, cut.topology.triangle2shell));
}

TEST(SplitSubdomain, keeps_old_origins_and_numbers_new_ones_from_zero) {
  const FlatCut cut = cap_of_sphere();
  const std::size_t new_nodes = cut.mesh.planar.points.size() - cut.mesh.rim_vertices.size();
  for (const Side side : {Side::left, Side::right}) {
    const Subdomain half = half_of(cut.subdomain, cut.colours, cut.mesh, side);
    EXPECT_TRUE(validate(half).empty());
    std::size_t seen = 0;
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
      if (half.node_origin[v].owner == 0) {
        EXPECT_EQ(half.vertices[v], cut.subdomain.vertices[half.node_origin[v].index]);
      } else {
        EXPECT_EQ(half.node_origin[v], (Origin{1, static_cast<std::uint32_t>(seen++)}));
      }
    }
    EXPECT_EQ(seen, new_nodes);
  }
}

/// The largest height of a new node, in largest heights of rim nodes.
double rise_of(double steepest_slope) {
  FlatCut cut = cap_of_sphere();
  LiftOptions options;
  options.steepest_slope = steepest_slope;
  lift_heights(cut.mesh, cut.corners, cut.weights(), {}, options);
  double rim = 0;
  double inside = 0;
  for (std::size_t v = 0; v < cut.mesh.heights.size(); ++v) {
    double& largest = v < cut.mesh.rim_vertices.size() ? rim : inside;
    largest = std::max(largest, std::fabs(cut.mesh.heights[v]));
  }
  return inside / rim;
}

TEST(LiftHeights, are_no_steeper_at_the_rim_than_allowed) {
  EXPECT_GT(rise_of(2), 1.4) << "beyond the rim, where the bisectors lead";
  EXPECT_LT(rise_of(1), 0.9 * rise_of(2));
  EXPECT_LT(rise_of(0.5), 0.9 * rise_of(1));
  EXPECT_LT(rise_of(0), 1) << "level from the rim inward";
}

}  // namespace
}  // namespace tetfarm
