#include "mesh/library/append_mesh.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/library/leaf_mesh.h"
#include "mesh/library/mesh_surface.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(AppendMesh, gives_boundary_nodes_their_places_and_inner_ones_new_places) {
  TetMesh part;
  part.nodes = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
  part.tets = {{0, 1, 2, 3}, {3, 4, 1, 0}};
  part.boundary_nodes = 3;
  std::vector<Vec3> nodes = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}};
  std::vector<Tet> tets = {{0, 1, 2, 3}};
  append_mesh(part, {2, 0, 3}, nodes, tets);
  EXPECT_THAT(nodes, ElementsAre(Vec3{0, 0, 1}, Vec3{0, 0, 2}, Vec3{0, 0, 3}, Vec3{0, 0, 4},
                                 Vec3{4, 0, 0}, Vec3{5, 0, 0}));
  EXPECT_THAT(tets, ElementsAre(Tet{0, 1, 2, 3}, Tet{2, 0, 3, 4}, Tet{4, 5, 0, 2}));
}

TEST(AppendMesh, goes_on_with_the_numbers_of_what_was_appended_before) {
  const TetMesh part{{{9, 9, 9}}, {{0, 0, 0, 0}}, 0};
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
  append_mesh(part, {}, nodes, tets);
  append_mesh(part, {}, nodes, tets);
  EXPECT_THAT(tets, ElementsAre(Tet{0, 0, 0, 0}, Tet{1, 1, 1, 1}));
  EXPECT_EQ(nodes.size(), 2U);
}

TEST(LeafMeshers, refuse_a_cut_whose_halves_are_not_recovered_and_then_have_none) {
  const SpacingField spacing(0.6);
  const LeafMeshers meshers = leaf_meshers(spacing, {.cosmetics = false}, {});
  const Subdomain ball = root_subdomain(shapes::sphere({0, 0, 0}, 1, 2));
  const CutOutcome cut = meshers.cut(ball);
  ASSERT_TRUE(cut.cut) << cut.reason;
  EXPECT_TRUE(meshers.mesh(cut.cut->left).mesh);
  EXPECT_TRUE(meshers.mesh(cut.cut->right).mesh);
}

TEST(MeshSurface, of_a_defective_surface_says_all_that_is_wrong_and_lists_the_triangles) {
  SurfaceMesh surface = shapes::unit_cube();
  surface.triangles.erase(surface.triangles.begin() + 5);
  surface.triangles.push_back({0, 0, 1});
  try {
    mesh_surface(surface);
    ADD_FAILURE() << "meshed";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_THAT(text, testing::StartsWith("the surface cannot be meshed\n  degenerate triangle: 1 "
                                          "triangle without area: triangle 11 "));
    EXPECT_THAT(text, testing::HasSubstr("\n  open edge: 3 open edges (on one triangle only): "));
    EXPECT_EQ(error.triangles().back(), 11);
    EXPECT_EQ(error.triangles().size(), 4U);
    EXPECT_TRUE(std::is_sorted(error.triangles().begin(), error.triangles().end()));
  }
}

TEST(MeshSurface, has_its_vertices_first_and_the_outside_when_that_is_asked_for) {
  MeshSurfaceOptions options;
  options.outer = {.kind = OuterBoundary::Kind::box, .factor = 2};
  options.spacing.background = 0.6;
  const SurfaceMesh body = shapes::unit_cube();
  const MeshedSurface meshed = mesh_surface(body, options);
  ASSERT_GT(meshed.nodes.size(), meshed.surface.vertices.size());
  for (std::size_t v = 0; v < meshed.surface.vertices.size(); ++v) {
    EXPECT_EQ(meshed.nodes[v], meshed.surface.vertices[v]);
  }
  double volume = 0;
  for (const Tet& t : meshed.tets) {
    const auto p = [&](std::size_t i) { return meshed.nodes[static_cast<std::size_t>(t[i])]; };
    volume += tet_volume(p(0), p(1), p(2), p(3));
  }
  EXPECT_NEAR(volume, 8 - 1, 1e-9);
  EXPECT_THAT(meshed.region_of_tet, testing::Each(1));
  EXPECT_EQ(meshed.region_of_tet.size(), meshed.tets.size());
}

TEST(MeshSurface, is_no_coarser_at_the_outer_boundary_than_the_job_asks_for_everywhere) {
  MeshSurfaceOptions options;
  options.outer = {.kind = OuterBoundary::Kind::box, .factor = 2};
  options.spacing.background = 0.25;
  options.volume.fill = false;
  const MeshedSurface meshed = mesh_surface(shapes::unit_cube(), options);
  EXPECT_EQ(meshed.surface.triangles.size(), 12U + 12 * 64) << "8 squares along a side of 2";
}

}  // namespace
}  // namespace tetfarm
