#include "mesh/decompose/rim_angles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/array_index.h"
#include "tests/support/shapes.h"

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

}  // namespace
}  // namespace tetfarm
