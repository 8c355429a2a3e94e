#include "mesh/decompose/work_estimate.h"

#include <gtest/gtest.h>

#include "mesh/decompose/planar_cut.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

double estimated_volume(const SurfaceMesh& surface, double h) {
  return estimated_elements(root_subdomain(surface), SpacingField(h)) * h * h * h /
         SpacingField::elements_per_h3;
}

void expect_volume(const SurfaceMesh& surface, double h) {
  const double volume = enclosed_volume(surface.vertices, surface.triangles);
  EXPECT_NEAR(estimated_volume(surface, h), volume, 0.04 * volume);
}

TEST(WorkEstimate, of_a_box_is_exact) {
  EXPECT_NEAR(estimated_volume(shapes::box({-1, 0, 2}, {2, 0.7, 3.1}, 3), 0.1), 3 * 0.7 * 1.1,
              1e-12);
  EXPECT_NEAR(estimated_volume(shapes::box({0, 0, 0}, {100, 1, 1}, 2), 0.1), 100, 1e-9);
}

TEST(WorkEstimate, follows_the_volume_of_any_shape) {
  expect_volume(shapes::sphere({1, 2, 3}, 0.5, 3), 0.05);
  expect_volume(shapes::nested_spheres(3), 0.1);
  expect_volume(shapes::torus(0.3, 40, 16), 0.05);
}

TEST(WorkEstimate, is_fine_enough_when_elements_are_few) {
  expect_volume(shapes::sphere({0, 0, 0}, 1, 2), 1.0);
}

TEST(WorkEstimate, keeps_samples_inside) {
  const WorkSamples work =
      sample_work(root_subdomain(shapes::nested_spheres(3)), SpacingField(0.1));
  double total = 0;
  for (const WorkSample& s : work.samples) {
    EXPECT_LT(norm(s.at), 1.0);
    EXPECT_GT(norm(s.at), 0.38);
    total += s.work;
  }
  EXPECT_NEAR(total, work.total, 1e-9 * total);
}

}  // namespace
}  // namespace tetfarm
