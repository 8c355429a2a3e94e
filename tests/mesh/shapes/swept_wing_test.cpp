#include "mesh/shapes/swept_wing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/array_index.h"

namespace tetfarm {
namespace {

TEST(SweptWing, has_fewer_points_on_a_section_the_shorter_its_chord_is) {
  constexpr double spacing = 0.1;
  const SurfaceMesh mesh = swept_wing(spacing, 0.2);
  std::vector<double> lengths;  // of edges along sections near the tip, twice each
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_names[at(mesh.patch_of_triangle[t])] != "wing") continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& from = mesh.vertices[at(mesh.triangles[t][i])];
      const Vec3& to = mesh.vertices[at(mesh.triangles[t][(i + 1) % 3])];
      if (from.y != to.y || from.y < 1 || from.y > 1.19) continue;
      lengths.push_back(distance(from, to));
    }
  }
  ASSERT_GT(lengths.size(), 20U);
  std::ranges::sort(lengths);
  EXPECT_NEAR(lengths[lengths.size() / 2], spacing, 0.15 * spacing);
}

}  // namespace
}  // namespace tetfarm
