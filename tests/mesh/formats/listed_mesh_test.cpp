#include "mesh/formats/listed_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

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

/// Tets in a row over nodes in a row, of which each has four.
ListedMesh row_of_tets(std::int64_t tets, std::int64_t gap = 1) {
  ListedMesh mesh;
  mesh.name = "row";
  mesh.nodes = 4 * gap * tets;
  mesh.read_nodes = [](std::int64_t first, std::span<Vec3> into) {
    for (Vec3& p : into) p = {static_cast<double>(first++), 0, 0};
  };
  mesh.read_tets = [gap](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    for (ListedMesh::Nodes& tet : into) {
      const std::int64_t node = 4 * gap * first++;
      tet = {node + 3 * gap, node + 2 * gap, node + gap, node};
    }
  };
  mesh.runs = {{tets, 1, 0}};
  return mesh;
}

TEST(ListedMesh, nodes_come_from_their_places_in_the_list_however_far_apart) {
  for (const std::int64_t gap : {1, 16, 17, 40'000}) {
    const auto source = open_listed(row_of_tets(3, gap), 2);
    ASSERT_EQ(source->size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const NumberedPart part = source->part(i);
      EXPECT_EQ(part.tets.size(), i == 0 ? 2U : 1U);
      EXPECT_THAT(part.tets[0], ElementsAre(3, 2, 1, 0));
      ASSERT_EQ(part.nodes.size(), i == 0 ? 8U : 4U);
      for (std::size_t v = 0; v < part.nodes.size(); ++v) {
        EXPECT_EQ(part.local2global[v], (static_cast<std::int64_t>(v) + (i == 0 ? 0 : 8)) * gap);
        EXPECT_EQ(part.nodes[v].x, static_cast<double>(part.local2global[v]));
      }
    }
  }
}

TEST(ListedMesh, pieces_of_many_tets_are_gone_through_to_the_last) {
  constexpr std::int64_t tets = 65536 + 2;
  EXPECT_THAT(open_listed(row_of_tets(tets))->complaints(), testing::IsEmpty());
  ListedMesh mesh = row_of_tets(tets);
  mesh.nodes -= 1;
  EXPECT_THAT([&] { open_listed(mesh); },
              testing::ThrowsMessage<InvalidInput>("row: tet 65537 has node 262151 of 262151"));
  const NumberedPart part = open_listed(row_of_tets(tets))->part(0);
  EXPECT_EQ(part.nodes.back().x, 4 * tets - 1);
}

TEST(ListedMesh, pieces_end_with_their_region) {
  ListedMesh mesh = row_of_tets(7);
  mesh.runs = {{3, 1, 0}, {4, 2, 0}};
  std::string text;
  const auto source = open_listed(mesh, 2);
  for (std::size_t i = 0; i < source->size(); ++i) {
    const NumberedPart part = source->part(i);
    text += std::to_string(part.tets.size()) + " of " + std::to_string(part.region) + " from " +
            std::to_string(part.local2global[0]) + "; ";
    EXPECT_EQ(part.number, static_cast<std::int32_t>(i));
  }
  EXPECT_EQ(text, "2 of 1 from 0; 1 of 1 from 8; 2 of 2 from 12; 2 of 2 from 20; ");
}

TEST(ListedMesh, sub_domains_are_consecutive_runs_and_other_cells_go_to_theirs) {
  ListedMesh mesh = row_of_tets(5);
  mesh.knows_subdomains = true;
  mesh.runs = {{2, 1, 4}, {1, 2, 4}, {0, 1, 9}, {2, 1, 2}};
  mesh.cells[ElementType::pyramid].runs = {{1, 3, 2}, {2, 1, 3}, {1, 1, 2}};
  mesh.cells[ElementType::pyramid].read = [](std::int64_t first, std::span<std::int64_t> into) {
    for (std::size_t k = 0; k < into.size(); ++k) {
      into[k] = first + static_cast<std::int64_t>(k / 5 + k % 5);
    }
  };
  const auto source = open_listed(mesh);
  ASSERT_EQ(source->size(), 3U);
  EXPECT_THAT(source->part(0).tets.size(), 2U);
  EXPECT_THAT(source->part(0).blocks[ElementType::pyramid].regions, ElementsAre(1, 3));
  EXPECT_THAT(source->part(1).tets.size(), 0U);
  EXPECT_THAT(source->part(1).blocks[ElementType::pyramid].regions, ElementsAre(1, 1));
  EXPECT_THAT(source->part(2).region_of_tet, ElementsAre(1, 1, 2));
  // The first of region 1 is the last of the list: its nodes are 3 to 7.
  const NumberedPart first = source->part(0);
  EXPECT_EQ(
      first.local2global[static_cast<std::size_t>(first.blocks[ElementType::pyramid].nodes[0])], 3);
}

TEST(ListedMesh, a_sub_domain_may_have_tets_of_one_region_and_other_cells_of_another) {
  ListedMesh mesh = row_of_tets(2);
  mesh.knows_subdomains = true;
  mesh.runs = {{2, 2, 0}};
  mesh.triangles = {{{3, 1, 2}, 0}};
  mesh.cells[ElementType::pyramid].runs = {{1, 1, 0}};
  mesh.cells[ElementType::pyramid].read = [](std::int64_t, std::span<std::int64_t> into) {
    for (std::size_t k = 0; k < into.size(); ++k) into[k] = static_cast<std::int64_t>(k);
  };
  const NumberedPart part = open_listed(mesh)->part(0);
  EXPECT_EQ(part.region, 2);
  EXPECT_THAT(part.region_of_tet, ElementsAre(2, 2));
  EXPECT_THAT(part.region_of_face, ElementsAre(2));
  EXPECT_THAT(part.blocks[ElementType::pyramid].regions, ElementsAre(1));
}

TEST(ListedMesh, without_cells_is_refused) {
  ListedMesh mesh = row_of_tets(0);
  EXPECT_THAT([&] { open_listed(mesh); }, testing::ThrowsMessage<InvalidInput>("row: has no tets"));
}

TEST(ListedMesh, complaints_count_the_nodes_that_nothing_has) {
  ListedMesh mesh = row_of_tets(2);
  mesh.nodes = 11;
  mesh.quads = {{{8, 0, 1, 2}, 0}};
  EXPECT_THAT(open_listed(mesh)->complaints(),
              ElementsAre("node 9 is in no tet and no boundary triangle; such nodes: 2"));
}

TEST(ListedMesh, of_two_equal_boundary_faces_each_tet_gets_one) {
  ListedMesh mesh = two_tets();
  mesh.triangles = {{{0, 1, 2}, 0}, {{1, 2, 0}, 1}, {{2, 1, 0}, 2}, {{0, 2, 1}, 3}};
  const auto source = open_listed(std::move(mesh), 1);
  EXPECT_THAT(source->part(0).patch_of_face, ElementsAre(2));
  EXPECT_THAT(source->part(1).patch_of_face, ElementsAre(0, 1, 3));
}

}  // namespace
}  // namespace tetfarm
