#include "mesh/shapes/bent_duct.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/core/triangle_angles.h"

namespace tetfarm {
namespace {

double smallest_angle_of(const SurfaceMesh& duct, const std::string& patch) {
  double smallest = 180;
  for (std::size_t t = 0; t < duct.triangles.size(); ++t) {
    if (duct.patch_names[at(duct.patch_of_triangle[t])] != patch) continue;
    const auto& [a, b, c] = duct.triangles[t];
    smallest = std::min(smallest, smallest_angle_deg(duct.vertices[at(a)], duct.vertices[at(b)],
                                                     duct.vertices[at(c)]));
  }
  return smallest;
}

TEST(BentDuct, both_its_ends_have_the_same_angles_however_many_rings_lie_between_them) {
  for (const double spacing : {0.3, 0.25, 0.2, 0.16, 0.13, 0.1}) {
    const SurfaceMesh duct = bent_duct(spacing);
    EXPECT_NEAR(smallest_angle_of(duct, "inlet"), smallest_angle_of(duct, "outlet"), 1e-6)
        << spacing;
  }
}

}  // namespace
}  // namespace tetfarm
