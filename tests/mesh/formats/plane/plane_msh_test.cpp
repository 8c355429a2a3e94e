#include "mesh/formats/plane/plane_msh.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"
#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;

const std::string square_22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"                      // lines 1 to 3
    "$PhysicalNames\n2\n1 7 \"lower wall\"\n2 3 \"fluid\"\n"      // 4 to 7
    "$EndPhysicalNames\n"                                         // 8
    "$Nodes\n4\n10 0 0 0\n20 1 0 0\n30 1 1.5 0\n40 0 1 0\n"       // 9 to 14
    "$EndNodes\n"                                                 // 15
    "$Elements\n5\n1 15 2 0 1 10\n2 1 2 7 1 10 20\n"              // 16 to 19
    "3 1 2 -8 2 20 30\n4 2 2 3 1 10 20 30\n5 2 2 0 2 10 30 40\n"  // 20 to 22
    "$EndElements\n";

const std::string square_41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n2\n1 7 \"lower wall\"\n2 3 \"fluid\"\n$EndPhysicalNames\n"
    "$Entities\n0 2 2 0\n1 0 0 0 1 0 0 1 7 0\n2 1 0 0 1 1 0 1 8 0\n"
    "1 0 0 0 1 1 0 1 3 0\n2 0 0 0 1 1 0 0 0\n$EndEntities\n"
    "$Nodes\n1 4 10 40\n2 1 0 4\n10\n20\n30\n40\n0 0 0\n1 0 0\n1 1.5 0\n0 1 0\n$EndNodes\n"
    "$Elements\n4 4 1 4\n1 1 1 1\n1 10 20\n1 2 1 1\n2 20 30\n2 1 2 1\n3 10 20 30\n"
    "2 2 2 1\n4 10 30 40\n$EndElements\n";

std::string refusal_of_msh(const std::string& name, const std::string& text) {
  try {
    read_plane_msh(text, name);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PlaneMsh, reads_triangles_and_lines_with_their_groups_in_both_versions) {
  for (const std::string& text : {square_22, square_41}) {
    const PlaneMesh mesh = read_plane_msh(text, "a.msh");
    EXPECT_THAT(mesh.points, ElementsAre(Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1.5}, Vec2{0, 1}));
    EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
    EXPECT_THAT(mesh.regions, ElementsAre(3, 0));
    EXPECT_THAT(mesh.edges, ElementsAre(ElementsAre(0, 1), ElementsAre(1, 2)));
    EXPECT_THAT(mesh.patches, ElementsAre(7, 8));
    EXPECT_THAT(mesh.patch_names, ElementsAre(Pair(7, "lower wall")));
    EXPECT_THAT(mesh.region_names, ElementsAre(Pair(3, "fluid")));
  }
}

TEST(PlaneMsh, refuses_what_is_wrong_with_the_line) {
  expect_refusals(
      "a.msh", square_22,
      {{"5 2 2 0 2 10 30 40", "5 3 2 0 2 10 20 30 40",
        "a.msh:22: a quadrangle: only lines of 2 and triangles of 3 nodes are read"},
       {"3 1 2 -8 2 20 30", "3 8 2 8 2 20 30 40",
        "a.msh:20: a 3-node line: only lines of 2 and triangles of 3 nodes are read"},
       {"5 2 2 0 2 10 30 40", "5 4 2 0 2 10 20 30 40",
        "a.msh:22: a tetrahedron: only lines of 2 and triangles of 3 nodes are read"},
       {"10 30 40", "10 30 41", "a.msh:22: there is no node 41"},
       {"40 0 1 0", "40 0 1 0.5", "a.msh:14: the nodes do not lie in one plane z = constant"},
       {"40 0 1 0", "30 0 1 0", "a.msh:15: two nodes have the tag 30"},
       {"30 1 1.5 0", "30 1 inf 0", "a.msh:13: a coordinate is inf"},
       {"2 2 3 1 10", "2 2 3000000000 1 10", "a.msh:21: a physical tag is too large"},
       {"2.2 0 8", "3 0 8", "a.msh:2: Gmsh format \"3\" is not supported; save it as 4.1 or 2.2"}},
      refusal_of_msh);
}

TEST(PlaneMsh, refuses_any_beginning_of_a_file) {
  for (const std::string& text : {square_22, square_41}) {
    for (std::size_t end = 0; end < text.size() - 1; ++end) {
      EXPECT_NE(refusal_of_msh("a.msh", text.substr(0, end)), "") << end;
    }
  }
}

TEST(PlaneMsh, gives_back_what_it_wrote_bit_by_bit) {
  PlaneMesh mesh = square_ring();
  mesh.points[5] = {2 + 1.0 / 3, std::nextafter(1, 2)};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "ring.msh";
  write_plane_msh(mesh, path);
  const PlaneMesh back = read_plane_msh(read_file(path), "ring.msh");
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_EQ(back.edges, mesh.edges);
  EXPECT_EQ(back.patches, mesh.patches);
  EXPECT_EQ(back.patch_names, mesh.patch_names);
  EXPECT_EQ(back.region_names, mesh.region_names);
}

}  // namespace
}  // namespace tetfarm
