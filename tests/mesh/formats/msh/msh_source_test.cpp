#include "mesh/formats/msh/msh_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/formats/registry/export_mesh.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

const std::string version_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 1\n1 0 0 0 1 1 1 1 2 0\n"
    "1 0 0 0 1 1 1 1 3 0\n$EndEntities\n$Nodes\n2 4 1 4\n2 1 0 3\n4\n1\n2\n0 0 1\n0 0 0\n1 0 0\n"
    "3 1 0 1\n3\n0 1 0\n$EndNodes\n$Elements\n2 2 1 2\n2 1 2 1\n1 1 3 2\n3 1 4 1\n2 1 2 3 4\n"
    "$EndElements\n";
const std::string version_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
    "$EndNodes\n$Elements\n3\n1 15 2 0 1 1\n2 2 2 5 1 1 3 2\n3 4 4 3 1 1 7 1 2 3 4\n"
    "$EndElements\n";

TEST(MshSource, reads_nodes_in_any_order_and_the_groups_of_entities) {
  for (const std::string& text : {version_4, version_2}) {
    const TempFolder folder;
    write_file_atomically(folder.path() / "a.msh", text);
    const NumberedPart part = open_mesh(folder.path() / "a.msh", folder.path())->part(0);
    EXPECT_EQ(part.nodes, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(part.tets, (std::vector<Tet>{{0, 1, 2, 3}}));
    EXPECT_EQ(part.region, 3);
    EXPECT_EQ(part.faces, (std::vector<Triangle>{{0, 2, 1}}));
    EXPECT_EQ(part.patch_of_face.front(), text == version_4 ? 1 : 4);
  }
}

TEST(MshSource, refuses_node_tags_with_gaps_or_twice) {
  EXPECT_THAT(refusal_of("a.msh", changed(version_4, "4\n1\n2\n", "9\n1\n2\n")),
              HasSubstr("1 to N"));
  EXPECT_THAT(refusal_of("a.msh", changed(version_4, "4\n1\n2\n", "4\n4\n2\n")),
              HasSubstr("two nodes have the tag 4"));
  EXPECT_THAT(refusal_of("a.msh", changed(version_2, "4 0 0 1", "4444444444444 0 0 1")),
              HasSubstr("1 to N"));
}

TEST(MshSource, names_the_line_of_what_is_wrong) {
  EXPECT_THAT(refusal_of("a.msh", changed(version_2, "1 3 2\n", "1 3 x\n")),
              HasSubstr("a.msh:14: "));
  EXPECT_THAT(refusal_of("a.msh", changed(version_4, "2 1 2 1\n", "2 1 9 1\n")),
              HasSubstr("6-node triangle"));
  EXPECT_THAT(refusal_of("a.msh", changed(version_4, "2 1 0 3", "2 1 0 333")),
              HasSubstr("a count of 333"));
  EXPECT_THAT(refusal_of("a.msh", changed(version_4, "4.1", "4.0")), HasSubstr("a.msh:2: "));
}

TEST(MshSource, a_partition_stands_for_all_when_it_is_the_first) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  export_mesh(grid, find_mesh_format("msh41-split", ""), folder.path() / "a.msh");
  EXPECT_EQ(open_mesh(folder.path() / "a_1.msh")->size(), 3U);
  try {
    open_mesh(folder.path() / "a_2.msh");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("give the file whose name ends in _1"));
  }
}

}  // namespace
}  // namespace tetfarm
