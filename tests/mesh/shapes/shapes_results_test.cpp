// The surfaces that are made by name, known by their digests (tests/golden/shapes.txt): the same
// bits on every machine, as they are made by + - * / and sqrt only.
#include <gtest/gtest.h>

#include "mesh/shapes/box_and_sphere.h"
#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/shapes/wing_section.h"
#include "tests/support/result_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void add_surface(ResultDigest& result, const SurfaceMesh& surface) {
  result.add(surface.vertices, surface.triangles, surface.patch_of_triangle, surface.patch_names);
}

TEST(ShapesResults, of_every_name_are_known_bit_by_bit) {
  for (const std::string& name : shape_names()) {
    ResultDigest result;
    for (const double spacing : {0.2, 0.171, 0.131}) {
      add_surface(result, make_shape(name, {.spacing = spacing, .growth = 0.4}));
    }
    test::expect_known("shapes", name, result);
  }
}

TEST(ShapesResults, of_boxes_spheres_circles_and_sections_are_known_bit_by_bit) {
  ResultDigest result;
  for (const int n : {1, 2, 3, 4, 5}) {
    add_surface(result, box_surface({{-1, 0, 2}, {1, 3, 2.5}}, n));
    const SurfaceMesh sphere = sphere_surface({1, 2, 3}, 0.5, n);
    add_surface(result, sphere);
    result.add(nearest_plane(sphere, {1, 2, 3}));
  }
  for (std::int64_t k = -25; k <= 25; ++k) {
    const CirclePoint p = circle_point(k, 23);
    const CirclePoint q = circle_point(3 * k + 1, 64);
    result.add(p.cosine, p.sine, q.cosine, q.sine);
  }
  const std::vector<SectionPoint> half = upper_half();
  for (const SectionPoint& p : half) result.add(p.at, p.normal);
  for (const Ring& ring : {Ring{}, Ring{0.5, 0.3}, Ring{0, 10}}) {
    const std::vector<Vec3> line = upper_line(half, ring);
    result.add(line, length_of(line), even_points(line, 7), even_points(line, 40));
  }
  test::expect_known("shapes", "parts", result);
}

}  // namespace
}  // namespace tetfarm
