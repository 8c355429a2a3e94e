#include "mesh/library/mesh_surface.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/core/signed_volume.h"
#include "mesh/core/validate.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

double volume_of(const MeshedSurface& mesh, std::int32_t region) {
  double volume = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (mesh.region_of_tet[t] != region) continue;
    const auto at = [&](int i) {
      return mesh.nodes[static_cast<std::size_t>(mesh.tets[t][static_cast<std::size_t>(i)])];
    };
    volume += static_cast<double>(signed_volume(at(0), at(1), at(2), at(3)));
  }
  return volume;
}

TEST(MeshSurface, keeps_vertices_and_triangles_of_a_cube) {
  const SurfaceMesh cube = shapes::unit_cube();
  MeshSurfaceOptions options;
  options.spacing.background = 0.3;
  options.spacing.inherit_surface = false;
  const MeshedSurface mesh = mesh_surface(cube, options);
  ASSERT_EQ(mesh.region_of_tet.size(), mesh.tets.size());
  for (std::size_t v = 0; v < cube.vertices.size(); ++v) {
    EXPECT_TRUE(mesh.nodes[v] == cube.vertices[v]);
  }
  const TetMesh tets{mesh.nodes, mesh.tets, static_cast<std::int32_t>(cube.vertices.size())};
  EXPECT_THAT(validate(tets, mesh.surface.triangles), IsEmpty());
  EXPECT_GT(mesh.nodes.size(), cube.vertices.size() + 20);
}

TEST(MeshSurface, meshes_each_region_and_shares_the_nodes_between_them) {
  const auto cubes =
      shapes::voxel_surface({{4, 2, 2}, [](int x, int, int) { return x < 1 ? 1 : 2; }});
  MeshSurfaceOptions options;
  options.regions.wishes.push_back({.at = {0.5, 0.5, 0.6}, .name = "steel"});
  const MeshedSurface mesh = mesh_surface(cubes.surface, options);
  ASSERT_EQ(mesh.surface.region_names.size(), 2U);
  EXPECT_EQ(mesh.surface.region_names[0], "steel");
  EXPECT_NEAR(volume_of(mesh, 1), 4, 1e-12);
  EXPECT_NEAR(volume_of(mesh, 2), 12, 1e-12);
}

TEST(MeshSurface, meshes_the_space_round_a_body) {
  MeshSurfaceOptions options;
  options.outer = {.kind = OuterBoundary::Kind::box, .factor = 3};
  const MeshedSurface mesh = mesh_surface(shapes::unit_cube(), options);
  EXPECT_NEAR(volume_of(mesh, 1), 26, 1e-9);
}

TEST(MeshSurface, refuses_an_open_surface_with_its_triangles) {
  SurfaceMesh open = shapes::unit_cube();
  open.triangles.pop_back();
  try {
    mesh_surface(open);
    FAIL() << "an open surface was meshed";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("the surface cannot be meshed\n  open edge: "));
    EXPECT_EQ(error.triangles().size(), 3U);
  }
}

}  // namespace
}  // namespace tetfarm
