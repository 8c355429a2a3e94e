#include "mesh/recovery/steiner_relocation.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/mesh/recovery/split_cube.h"

namespace tetfarm {
namespace {

TEST(SteinerRelocation, of_a_point_on_an_edge_or_a_face_makes_what_it_split_whole) {
  for (const bool is_on_edge : {true, false}) {
    for (std::int32_t triangle = 0; triangle < 12; ++triangle) {
      SplitCube cube(triangle, is_on_edge);
      ASSERT_TRUE(
          relocate_steiner_point(*cube.mesh, cube.surface, cube.domain.triangles, cube.node));
      const Vec3& moved = cube.complex.points[static_cast<std::size_t>(cube.node)];
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(moved[axis], 0);
        EXPECT_LT(moved[axis], 1);
      }
      EXPECT_TRUE(validate(cube.complex).empty());
      expect_mesh_of(cube.inside_mesh(), cube.domain);
    }
  }
}

TEST(SteinerRelocation, changes_nothing_when_the_surface_has_other_faces_at_the_point) {
  SplitCube cube(0, false);
  std::swap(cube.surface.triangles.back()[0], cube.surface.triangles.back()[1]);
  const auto before = cube.complex.nodes;
  EXPECT_FALSE(relocate_steiner_point(*cube.mesh, cube.surface, cube.domain.triangles, cube.node));
  EXPECT_EQ(cube.complex.nodes, before);
}

}  // namespace
}  // namespace tetfarm
