#include "mesh/core/tet_complex.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A cube of six tets round the diagonal from node 0 to node 7; node numbers are bits x, y, z.
TetMesh kuhn_cube() {
  TetMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.nodes.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  mesh.tets = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  mesh.boundary_nodes = 8;
  return mesh;
}

std::size_t boundary_faces(const TetComplex& complex) {
  std::size_t faces = 0;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    for (const FaceHandle across : complex.neighbours[t]) {
      faces += complex.is_live(static_cast<std::int32_t>(t)) && across == no_face;
    }
  }
  return faces;
}

TEST(TetComplex, neighbours_of_a_cube_of_six_tets) {
  const TetComplex complex = make_tet_complex(kuhn_cube());
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(boundary_faces(complex), 12u);
  EXPECT_EQ(complex.live_tets(), 6u);
}

TEST(TetComplex, a_single_tet_has_no_neighbours) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  const TetComplex complex = make_tet_complex(mesh);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(boundary_faces(complex), 4u);
}

TEST(TetComplex, an_empty_mesh_is_valid) { EXPECT_THAT(validate(make_tet_complex({})), IsEmpty()); }

TEST(TetComplex, an_unused_node_has_no_tet) {
  TetMesh mesh = kuhn_cube();
  mesh.nodes.push_back({5, 5, 5});
  const TetComplex complex = make_tet_complex(mesh);
  EXPECT_EQ(complex.node2tet.back(), -1);
  EXPECT_EQ(complex.node2tet[7], 0);
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(TetComplex, comes_back_as_the_mesh_it_was_made_of) {
  const TetMesh mesh = kuhn_cube();
  const TetMesh again = to_tet_mesh(make_tet_complex(mesh), 8);
  EXPECT_EQ(again.nodes, mesh.nodes);
  EXPECT_EQ(again.tets, mesh.tets);
  EXPECT_EQ(again.boundary_nodes, 8);
}

TEST(TetComplex, a_killed_tet_is_filled_again_first) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  const auto around = complex.neighbours[2];
  for (const FaceHandle across : around) complex.glue(across, no_face);
  complex.kill_tet(2);
  complex.node2tet[6] = 3;
  EXPECT_FALSE(complex.is_live(2));
  EXPECT_EQ(complex.live_tets(), 5u);
  EXPECT_EQ(to_tet_mesh(complex, 8).tets.size(), 5u);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.new_tet(), 2);
  EXPECT_EQ(complex.new_tet(), 6);
}

TEST(TetComplex, local_node_finds_each_node_and_no_other) {
  const TetComplex complex = make_tet_complex(kuhn_cube());
  EXPECT_EQ(complex.local_node(1, 0), 0);
  EXPECT_EQ(complex.local_node(1, 7), 3);
  EXPECT_EQ(complex.local_node(1, 5), -1);
}

TEST(TetComplexValidate, tells_an_inverted_tet) {
  TetMesh mesh = kuhn_cube();
  std::swap(mesh.tets[3][0], mesh.tets[3][1]);
  EXPECT_THAT(validate(make_tet_complex(mesh)),
              Contains(HasSubstr("tet 3 has no positive volume")));
}

TEST(TetComplexValidate, tells_a_node_that_comes_twice) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  complex.nodes[4][1] = complex.nodes[4][2];
  EXPECT_THAT(validate(complex), Contains(HasSubstr("tet 4 has node 5 twice")));
}

TEST(TetComplexValidate, tells_a_one_sided_neighbour) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  for (FaceHandle& across : complex.neighbours[0]) across = no_face;
  EXPECT_THAT(validate(complex), Contains(HasSubstr("does not point back")));
}

TEST(TetComplexValidate, tells_faces_glued_to_the_wrong_ones) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  complex.glue(face_handle(0, 0), face_handle(3, 3));
  EXPECT_THAT(validate(complex), Contains(HasSubstr("with other nodes")));
}

TEST(TetComplexValidate, tells_a_node_whose_tet_does_not_hold_it) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  complex.node2tet[5] = 0;
  EXPECT_THAT(validate(complex), Contains(HasSubstr("node2tet of node 5 is tet 0")));
}

TEST(TetComplexValidate, tells_a_free_list_that_holds_a_live_tet) {
  TetComplex complex = make_tet_complex(kuhn_cube());
  complex.free_tets.push_back(1);
  EXPECT_THAT(validate(complex), Contains(HasSubstr("free_tets")));
}

}  // namespace
}  // namespace tetfarm
