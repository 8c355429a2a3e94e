#include "mesh/formats/listed_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two tets on one face, with the boundary triangle behind each; node 5 is in neither.
ListedMesh two_tets() {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0},  {0, 1, 0},
                                   {0, 0, 1}, {0, 0, -1}, {7, 7, 7}};
  const std::vector<ListedMesh::Nodes> tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  ListedMesh mesh;
  mesh.name = "a";
  mesh.nodes = 6;
  mesh.read_nodes = [nodes](std::int64_t first, std::span<Vec3> into) {
    std::copy_n(nodes.begin() + first, into.size(), into.begin());
  };
  mesh.read_tets = [tets](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    std::copy_n(tets.begin() + first, into.size(), into.begin());
  };
  mesh.runs = {{1, 1, 0}, {1, 2, 1}};
  // Of the second tet, of the first, turned the wrong way.
  mesh.triangles = {{{4, 2, 1}, 0}, {{2, 3, 1}, 1}, {{0, 1, 4}, 2}, {{0, 3, 1}, 3}};
  return mesh;
}

TEST(ListedMesh, triangles_go_with_the_tet_that_has_them_and_the_others_with_the_last_part) {
  const auto source = open_listed(two_tets(), 1);
  ASSERT_EQ(source->size(), 2U);
  EXPECT_THAT(source->part(0).patch_of_face, ElementsAre(1));
  EXPECT_THAT(source->part(1).patch_of_face, ElementsAre(0, 2, 3));
  EXPECT_THAT(source->part(1).local2global, ElementsAre(0, 1, 2, 3, 4));
}

TEST(ListedMesh, parts_are_pieces_or_subdomains) {
  for (const bool knows_subdomains : {false, true}) {
    ListedMesh mesh = two_tets();
    mesh.knows_subdomains = knows_subdomains;
    if (knows_subdomains) mesh.runs[1].subdomain = 0;
    const auto source = open_listed(std::move(mesh));
    EXPECT_EQ(source->size(), knows_subdomains ? 1U : 2U);
    EXPECT_EQ(source->knows_subdomains(), knows_subdomains);
    if (knows_subdomains) {
      EXPECT_THAT(source->part(0).region_of_tet, ElementsAre(1, 2));
      EXPECT_THAT(source->part(0).region_of_face, ElementsAre(2, 1, 1, 1));
    }
  }
}

TEST(ListedMesh, nodes_that_nothing_has_are_complained_of) {
  EXPECT_THAT(open_listed(two_tets())->complaints(), ElementsAre(HasSubstr("node 5 is in no tet")));
}

TEST(ListedMesh, runs_join_when_they_are_of_the_same) {
  std::vector<TetRun> runs;
  for (const TetRun& run : {TetRun{1, 1, 0}, {2, 1, 0}, {3, 2, 0}, {4, 2, 1}}) add_tets(runs, run);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].tets, 3);
}

}  // namespace
}  // namespace tetfarm
