#include "mesh/core/complaints.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mesh/core/element_section.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/tet_complex.h"
#include "mesh/core/validate.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Complaints, are_the_first_twenty_lines) {
  Complaints complaints;
  EXPECT_TRUE(complaints.empty());
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(complaints.full()) << i;
    complaints.add(std::to_string(i));
  }
  EXPECT_TRUE(complaints.full());
  complaints.add("one too many");
  EXPECT_FALSE(complaints.empty());
  const std::vector<std::string> lines = complaints.take();
  ASSERT_THAT(lines, SizeIs(20));
  EXPECT_EQ(lines.front(), "0");
  EXPECT_EQ(lines.back(), "19");
}

TEST(Complaints, give_numbers_with_nine_digits) {
  EXPECT_EQ(text_of(0.0), "0");
  EXPECT_EQ(text_of(-1.5), "-1.5");
  EXPECT_EQ(text_of(1.0 / 3), "0.333333333");
  EXPECT_EQ(text_of(123456789.0), "123456789");
  EXPECT_EQ(text_of(1234567891.0), "1.23456789e+09");
  EXPECT_EQ(text_of(1e-7), "1e-07");
  EXPECT_EQ(text_of(HUGE_VAL), "inf");
  EXPECT_EQ(text_of(Vec3{1, -0.25, 1e20}), "(1, -0.25, 1e+20)");
}

Subdomain cube() { return root_subdomain(shapes::unit_cube()); }

std::vector<std::string> complaints_of(void (*break_it)(Subdomain&)) {
  Subdomain subdomain = cube();
  break_it(subdomain);
  return validate(subdomain);
}

TEST(ValidateSubdomain, says_what_breaks_it_word_by_word) {
  EXPECT_THAT(complaints_of([](Subdomain&) {}), IsEmpty());
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.node_origin.pop_back(); }),
              ElementsAre("8 vertices but 7 origins of vertices"));
  EXPECT_THAT(complaints_of([](Subdomain& s) {
                s.triangle_origin.push_back({0, 99});
              }),
              ElementsAre("12 triangles but 13 origins of triangles"));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.region = -1; }),
              ElementsAre("region -1 with sides of 0 triangles"));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.region = 0; }),
              ElementsAre("region 0 with sides of 0 triangles"));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.sides.resize(12); }),
              ElementsAre("region 1 with sides of 12 triangles"));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.path.heap = 0; }),
              ElementsAre("the tree path is 0, which is not a place in a tree"));
  EXPECT_THAT(complaints_of([](Subdomain& s) {
                s.triangles[3] = {1, 8, 2};
              }),
              ElementsAre("triangle 3 (1, 8, 2) has a vertex that does not exist"));
  EXPECT_THAT(complaints_of([](Subdomain& s) {
                s.triangles[3] = {-1, 1, 2};
              }),
              ElementsAre("triangle 3 (-1, 1, 2) has a vertex that does not exist"));
  EXPECT_THAT(complaints_of([](Subdomain& s) {
                s.triangles[3] = {4, 5, 4};
              }),
              ElementsAre("triangle 3 (4, 5, 4) uses a vertex twice"));
  EXPECT_THAT(complaints_of([](Subdomain& s) {
                s.vertices.push_back({2, 3, 4});
                s.node_origin.push_back({0, 50});
              }),
              ElementsAre("vertex 8 (2, 3, 4) is in no triangle"));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.vertices[3].z = HUGE_VAL; }), SizeIs(1));
  EXPECT_THAT(complaints_of([](Subdomain& s) { s.triangle_origin[1] = s.triangle_origin[7]; }),
              ElementsAre("two triangles have the origin (owner 0, index 7)"));
  EXPECT_THAT(
      complaints_of([](Subdomain& s) { s.node_origin[1] = s.node_origin[2] = s.node_origin[0]; }),
      ElementsAre("two vertices have the origin (owner 0, index 0)",
                  "two vertices have the origin (owner 0, index 0)"));
}

TEST(ValidateSubdomain, names_the_edges_of_a_hole_word_by_word) {
  Subdomain tet = root_subdomain(shapes::tetrahedron());
  tet.triangles.erase(tet.triangles.begin());
  tet.triangle_origin.pop_back();
  EXPECT_THAT(validate(tet),
              ElementsAre("edge 2-1 from (0, 1, 0) to (1, 0, 0) is not used equally often in both "
                          "directions",
                          "edge 1-3 from (1, 0, 0) to (0, 0, 1) is not used equally often in both "
                          "directions",
                          "edge 3-2 from (0, 0, 1) to (0, 1, 0) is not used equally often in both "
                          "directions"));
}

TetMesh one_tet() {
  TetMesh mesh;
  mesh.nodes = shapes::tetrahedron().vertices;
  mesh.tets = {{0, 1, 2, 3}};
  mesh.boundary_nodes = 4;
  return mesh;
}

std::vector<std::string> complaints_of(void (*break_it)(TetMesh&, std::vector<Triangle>&)) {
  TetMesh mesh = one_tet();
  std::vector<Triangle> triangles = shapes::tetrahedron().triangles;
  break_it(mesh, triangles);
  return validate(mesh, triangles);
}

TEST(ValidateTetMesh, says_what_breaks_it_word_by_word) {
  using Triangles = std::vector<Triangle>;
  EXPECT_THAT(complaints_of([](TetMesh&, Triangles&) {}), IsEmpty());
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) { m.boundary_nodes = 5; }),
              ElementsAre("5 boundary nodes of 4 nodes"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) { m.boundary_nodes = -1; }),
              ElementsAre("-1 boundary nodes of 4 nodes"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) {
                m.tets.push_back({0, 1, 4, 2});
              }),
              ElementsAre("tet 1 (0, 1, 4, 2) does not have four different nodes that exist"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) {
                m.tets.push_back({0, 1, 1, 2});
              }),
              ElementsAre("tet 1 (0, 1, 1, 2) does not have four different nodes that exist"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) {
                m.tets.push_back({0, 1, -1, 2});
              }),
              ElementsAre("tet 1 (0, 1, -1, 2) does not have four different nodes that exist"));
  EXPECT_THAT(
      complaints_of([](TetMesh& m, Triangles&) { m.boundary_nodes = 3; }),
      ElementsAre(
          "boundary triangle 0 (1, 2, 3) does not have three different nodes of the boundary",
          "boundary triangle 1 (0, 3, 2) does not have three different nodes of the boundary",
          "boundary triangle 2 (0, 1, 3) does not have three different nodes of the "
          "boundary"));
  EXPECT_THAT(
      complaints_of([](TetMesh&, Triangles& t) {
        t[2] = {3, 0, 3};
      }),
      ElementsAre("boundary triangle 2 (3, 0, 3) does not have three different nodes of the "
                  "boundary"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) {
                m.nodes.push_back({2, 2, 2});
              }),
              ElementsAre("node 4 (2, 2, 2) is in no tet"));
  EXPECT_THAT(complaints_of([](TetMesh&, Triangles& t) { t.pop_back(); }),
              ElementsAre("face (0, 1, 2) at (0, 0, 0) is used by 1 tets (0 in one, 1 in the other "
                          "direction) and 0 boundary triangles (0, 0)",
                          "the tets fill 0.166666667 but the boundary encloses 0.0833333333"));
  EXPECT_THAT(complaints_of([](TetMesh&, Triangles& t) { t.push_back(t[3]); }),
              ElementsAre("face (0, 1, 2) at (0, 0, 0) is used by 1 tets (0 in one, 1 in the other "
                          "direction) and 2 boundary triangles (0, 2)",
                          "the tets fill 0.166666667 but the boundary encloses 0.25"));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles&) { m.tets.push_back(m.tets[0]); }),
              SizeIs(5));
  EXPECT_THAT(complaints_of([](TetMesh& m, Triangles& t) {
                std::swap(m.tets[0][0], m.tets[0][1]);
                for (Triangle& x : t) std::swap(x[0], x[1]);
              }),
              ElementsAre("tet 0 (1, 0, 2, 3) at (1, 0, 0) has the volume -0.166666667"));
}

TEST(ValidateTetMesh, allows_volumes_to_differ_by_rounding_only) {
  TetMesh mesh = one_tet();
  mesh.nodes.push_back({0.25, 0.25, 0.25});
  mesh.tets = {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}};
  EXPECT_THAT(validate(mesh, shapes::tetrahedron().triangles), IsEmpty());
}

TEST(ValidateElementSection, says_what_breaks_it_word_by_word) {
  const auto complaints = [](void (*break_it)(ElementSection&)) {
    ElementSection section;
    section.sharers = {4, 7};
    section.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    section.node_origin = {{0, 1}, {0, 2}, {1, 0}, {4, 0}};
    section.tets = {{0, 1, 2, 3}};
    section.tet_owner = {0};
    section.triangles = {{0, 2, 1}};
    section.triangle_index = {6};
    section.triangle_owner = {0};
    break_it(section);
    return validate(section);
  };
  EXPECT_THAT(complaints([](ElementSection&) {}), IsEmpty());
  EXPECT_THAT(complaints([](ElementSection& s) { s.node_origin.pop_back(); }),
              ElementsAre("nodes and their origins differ in number"));
  EXPECT_THAT(complaints([](ElementSection& s) { s.tet_owner.push_back(1); }),
              ElementsAre("tets and owners differ in number"));
  EXPECT_THAT(complaints([](ElementSection& s) { s.triangle_index.clear(); }),
              ElementsAre("triangles, their numbers and owners differ in number"));
  EXPECT_THAT(complaints([](ElementSection& s) { s.triangle_owner.push_back(0); }),
              ElementsAre("triangles, their numbers and owners differ in number"));
  EXPECT_THAT(complaints([](ElementSection& s) {
                s.sharers = {7, 7};
              }),
              ElementsAre("the sharers do not ascend"));
  EXPECT_THAT(complaints([](ElementSection& s) { s.triangle_owner[0] = 2; }),
              ElementsAre("an owner is not a sharer"));
  EXPECT_THAT(complaints([](ElementSection& s) {
                s.node_origin[2] = {0, 2};
              }),
              ElementsAre("the origins of the nodes do not ascend"));
  EXPECT_THAT(complaints([](ElementSection& s) { s.tets[0][3] = 4; }),
              ElementsAre("an element has a node that is not there"));
  EXPECT_THAT(complaints([](ElementSection& s) {
                s.nodes.push_back({5, 5, 5});
                s.node_origin.push_back({9, 9});
              }),
              ElementsAre("a node is in no tet"));
}

TEST(ValidateElementSection, lets_no_more_share_than_an_owner_can_tell) {
  ElementSection section;
  for (std::uint64_t sharer = 1; sharer <= most_sharers; ++sharer)
    section.sharers.push_back(sharer);
  EXPECT_THAT(validate(section), IsEmpty());
  section.sharers.push_back(1000);
  EXPECT_THAT(validate(section), ElementsAre("the sharers do not ascend"));
}

TEST(ValidateTetComplex, says_what_breaks_it_word_by_word) {
  const auto complaints = [](void (*break_it)(TetComplex&)) {
    TetMesh mesh = one_tet();
    mesh.nodes.push_back({1, 1, 1});
    mesh.tets.push_back({1, 3, 2, 4});
    if (tet_volume(mesh.nodes[1], mesh.nodes[3], mesh.nodes[2], mesh.nodes[4]) < 0) {
      std::swap(mesh.tets[1][1], mesh.tets[1][2]);
    }
    TetComplex complex = make_tet_complex(mesh);
    break_it(complex);
    return validate(complex);
  };
  EXPECT_THAT(complaints([](TetComplex&) {}), IsEmpty());
  EXPECT_THAT(complaints([](TetComplex& c) { c.neighbours.pop_back(); }),
              ElementsAre("neighbours: wrong length"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.node2tet.pop_back(); }),
              ElementsAre("node2tet: wrong length"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.nodes[0][2] = 5; }),
              testing::Contains("tet 0 has node 5"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.nodes[0][2] = 1; }),
              testing::Contains("tet 0 has node 1 twice"));
  EXPECT_THAT(complaints([](TetComplex& c) {
                c.points[4] = {1.0 / 3, 1.0 / 3, 1.0 / 3};
              }),
              testing::Not(IsEmpty()));
  EXPECT_THAT(complaints([](TetComplex& c) { c.neighbours[0][0] = 17; }),
              testing::Contains("tet 0 has across face 0 tet 4 which does not exist"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.neighbours[0][1] = face_handle(1, 1); }),
              ElementsAre("tet 0 has across face 1 tet 1 which does not point back"));
  EXPECT_THAT(complaints([](TetComplex& c) {
                c.neighbours[0][1] = face_handle(1, 1);
                c.neighbours[1][1] = face_handle(0, 1);
              }),
              ElementsAre("tet 0 has across face 1 tet 1 with other nodes",
                          "tet 1 has across face 1 tet 0 with other nodes"));
  EXPECT_THAT(
      complaints([](TetComplex& c) { c.kill_tet(1); }),
      ElementsAre("tet 0 has across face 0 tet 1 which is dead", "node2tet of node 4 is tet 1"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.free_tets.push_back(0); }),
              ElementsAre("free_tets does not list the dead tets", "free_tets holds tet 0"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.free_tets.push_back(2); }),
              ElementsAre("free_tets does not list the dead tets", "free_tets holds tet 2"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.node2tet[4] = 0; }),
              ElementsAre("node2tet of node 4 is tet 0"));
  EXPECT_THAT(complaints([](TetComplex& c) { c.node2tet[4] = -1; }), IsEmpty());
  EXPECT_THAT(complaints([](TetComplex& c) { c.node2tet[0] = 2; }),
              ElementsAre("node2tet of node 0 is tet 2"));
}

}  // namespace
}  // namespace tetfarm
