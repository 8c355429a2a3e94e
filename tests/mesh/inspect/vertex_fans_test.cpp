#include "mesh/inspect/vertex_fans.h"

#include <gmock/gmock.h>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> touching(const SurfaceMesh& mesh) {
  return vertices_of_several_fans(
      mesh, edge_uses(mesh.triangles, std::vector<char>(mesh.triangles.size(), 1)));
}

TEST(VertexFans, are_single_on_a_manifold) {
  EXPECT_THAT(touching(shapes::sphere({0, 0, 0}, 1, 2)), testing::IsEmpty());
  EXPECT_THAT(touching(shapes::torus(0.3, 6, 5)), testing::IsEmpty());
}

TEST(VertexFans, are_two_where_cubes_meet_in_a_corner) {
  const SurfaceMesh mesh =
      welded(joined(shapes::unit_cube(), shapes::box({1, 1, 1}, {2, 2, 2}, 1)));
  const auto found = touching(mesh);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(mesh.vertices[static_cast<std::size_t>(found[0])], (Vec3{1, 1, 1}));
}

TEST(VertexFans, are_two_where_one_shell_is_pinched) {
  SurfaceMesh mesh = shapes::sphere({0, 0, 0}, 1, 2);
  // Vertices 0 and 3 are opposite corners of the icosahedron: joined, the shell touches itself.
  for (Triangle& t : mesh.triangles) std::ranges::replace(t, 3, 0);
  EXPECT_THAT(touching(mesh), testing::ElementsAre(0));
}

}  // namespace
}  // namespace tetfarm
