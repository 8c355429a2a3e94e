#include "mesh/core/validate.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The cube with a node in the middle joined to each of its triangles.
TetMesh star_of_cube() {
  const SurfaceMesh cube = shapes::unit_cube();
  TetMesh mesh;
  mesh.nodes = cube.vertices;
  mesh.boundary_nodes = static_cast<std::int32_t>(mesh.nodes.size());
  mesh.nodes.push_back({0.5, 0.5, 0.5});
  for (const auto& [a, b, c] : cube.triangles) mesh.tets.push_back({8, a, b, c});
  return mesh;
}

std::vector<Triangle> cube_triangles() { return shapes::unit_cube().triangles; }

TEST(UnmatchedEdges, none_in_closed_shapes) {
  EXPECT_THAT(unmatched_edges(shapes::unit_cube().triangles), IsEmpty());
  EXPECT_THAT(unmatched_edges(shapes::torus(0.2, 7, 5).triangles), IsEmpty());
  EXPECT_THAT(unmatched_edges({}), IsEmpty());
}

TEST(UnmatchedEdges, gives_the_edges_of_a_lone_triangle_in_its_direction) {
  EXPECT_THAT(unmatched_edges({{2, 0, 1}}),
              ElementsAre(std::array{0, 1}, std::array{2, 0}, std::array{1, 2}));
}

TEST(UnmatchedEdges, accepts_an_edge_used_twice_in_each_direction) {
  EXPECT_THAT(unmatched_edges({{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 3, 1}}), IsEmpty());
}

TEST(ValidateTetMesh, accepts_a_good_mesh) {
  EXPECT_THAT(validate(star_of_cube(), cube_triangles()), IsEmpty());
  TetMesh one;
  one.nodes = shapes::tetrahedron().vertices;
  one.tets = {{0, 1, 2, 3}};
  one.boundary_nodes = 4;
  EXPECT_THAT(validate(one, shapes::tetrahedron().triangles), IsEmpty());
}

TEST(ValidateTetMesh, accepts_a_thin_wall_that_is_boundary_on_both_sides) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.boundary_nodes = 5;
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  std::vector<Triangle> triangles;
  for (const Tet& tet : mesh.tets) {
    for (const auto& [i, j, k] : tet_face_nodes) {
      triangles.push_back({tet[static_cast<std::size_t>(i)], tet[static_cast<std::size_t>(j)],
                           tet[static_cast<std::size_t>(k)]});
    }
  }
  EXPECT_THAT(validate(mesh, triangles), IsEmpty());
}

TEST(ValidateTetMesh, finds_a_wall_that_is_boundary_on_both_sides_and_no_face) {
  std::vector<Triangle> triangles = cube_triangles();
  triangles.push_back({0, 1, 7});
  triangles.push_back({0, 7, 1});
  EXPECT_THAT(validate(star_of_cube(), triangles), Contains(HasSubstr("used by 0 tets")));
}

TEST(ValidateTetMesh, finds_a_missing_tet) {
  TetMesh mesh = star_of_cube();
  mesh.tets.pop_back();
  const auto lines = validate(mesh, cube_triangles());
  EXPECT_THAT(lines, SizeIs(5));  // the boundary triangle, three faces, the volume
  EXPECT_THAT(lines, Contains(HasSubstr("encloses")));
}

TEST(ValidateTetMesh, finds_a_tet_given_twice) {
  TetMesh mesh = star_of_cube();
  mesh.tets.push_back(mesh.tets[3]);
  EXPECT_THAT(validate(mesh, cube_triangles()), SizeIs(5));
}

TEST(ValidateTetMesh, finds_two_tets_on_the_same_side_of_a_face) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
  mesh.boundary_nodes = 5;
  mesh.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}};
  std::vector<Triangle> triangles;
  for (const Tet& tet : mesh.tets) {
    for (const auto& [i, j, k] : {tet_face_nodes[0], tet_face_nodes[1], tet_face_nodes[2]}) {
      triangles.push_back({tet[static_cast<std::size_t>(i)], tet[static_cast<std::size_t>(j)],
                           tet[static_cast<std::size_t>(k)]});
    }
  }
  EXPECT_THAT(validate(mesh, triangles), Contains(HasSubstr("face (0, 1, 2)")));
}

TEST(ValidateTetMesh, finds_a_missing_boundary_triangle) {
  std::vector<Triangle> triangles = cube_triangles();
  triangles.pop_back();
  EXPECT_THAT(validate(star_of_cube(), triangles), SizeIs(2));
}

TEST(ValidateTetMesh, finds_a_turned_boundary) {
  std::vector<Triangle> triangles = cube_triangles();
  for (Triangle& t : triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(validate(star_of_cube(), triangles), SizeIs(13));
}

TEST(ValidateTetMesh, finds_an_inverted_tet) {
  TetMesh mesh = star_of_cube();
  std::swap(mesh.tets[0][0], mesh.tets[0][1]);
  EXPECT_THAT(validate(mesh, cube_triangles()), Contains(HasSubstr("has the volume -0.08")));
}

TEST(ValidateTetMesh, finds_a_flat_tet) {
  TetMesh mesh = star_of_cube();
  mesh.nodes.back() = {0.5, 0.5, 0};
  const auto lines = validate(mesh, cube_triangles());
  EXPECT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines, Contains(testing::EndsWith("0")));
}

TEST(ValidateTetMesh, finds_a_bad_index_an_unused_node_and_a_bad_boundary_count) {
  TetMesh mesh = star_of_cube();
  mesh.tets[2][1] = 9;
  EXPECT_THAT(validate(mesh, cube_triangles()), SizeIs(1));
  mesh = star_of_cube();
  mesh.nodes.push_back({0.25, 0.25, 0.25});
  EXPECT_THAT(validate(mesh, cube_triangles()), SizeIs(1));
  mesh = star_of_cube();
  mesh.boundary_nodes = 7;
  EXPECT_THAT(validate(mesh, cube_triangles()), Contains(HasSubstr("nodes of the boundary")));
  mesh.boundary_nodes = 10;
  EXPECT_THAT(validate(mesh, cube_triangles()), SizeIs(1));
}

TEST(ValidateTetMesh, finds_a_node_that_is_not_a_number) {
  TetMesh mesh = star_of_cube();
  mesh.nodes.back().x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(validate(mesh, cube_triangles()), Contains(HasSubstr("not finite")));
}

}  // namespace
}  // namespace tetfarm
