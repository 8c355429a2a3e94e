#include "mesh/formats/parsed_mesh.h"

#include <gtest/gtest.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

constexpr std::int64_t many = 2 * 16384 + 3;  ///< more than are kept in memory at once

Vec3 place_of(std::int64_t node) { return {static_cast<double>(node), 0.5, -2}; }

TEST(ParsedMesh, has_all_nodes_that_came_in_order) {
  const TempFolder folder;
  ParsedMesh parsed(folder.path());
  for (std::int64_t node = 0; node < many; ++node) parsed.add_node(place_of(node));
  EXPECT_EQ(parsed.nodes(), many);
  const ListedMesh mesh = parsed.take();
  EXPECT_EQ(mesh.nodes, many);
  std::vector<Vec3> read(static_cast<std::size_t>(many));
  mesh.read_nodes(0, read);
  for (std::int64_t node = 0; node < many; ++node) {
    ASSERT_EQ(read[static_cast<std::size_t>(node)], place_of(node)) << node;
  }
  std::vector<Vec3> last(2);
  mesh.read_nodes(many - 2, last);
  EXPECT_EQ(last[0], place_of(many - 2));
}

TEST(ParsedMesh, has_nodes_at_their_numbers_in_whatever_order_they_come) {
  const TempFolder folder;
  ParsedMesh parsed(folder.path());
  for (const std::int64_t node : {5, 6, 7, 0, 1, 4, 3, 2}) parsed.set_node(node, place_of(node));
  EXPECT_EQ(parsed.nodes(), 8);
  parsed.add_node(place_of(77));  // behind number 2
  EXPECT_EQ(parsed.nodes(), 8);
  std::vector<Vec3> read(8);
  parsed.take().read_nodes(0, read);
  for (std::int64_t node = 0; node < 8; ++node) {
    EXPECT_EQ(read[static_cast<std::size_t>(node)], place_of(node == 3 ? 77 : node)) << node;
  }
}

TEST(ParsedMesh, has_tets_and_cells_in_the_order_in_which_they_came) {
  const TempFolder folder;
  ParsedMesh parsed(folder.path());
  parsed.set_node(many + 9, {});
  for (std::int64_t i = 0; i < many; ++i) {
    parsed.add_tet({i, i + 1, i + 2, i + 3}, i < 5 ? 1 : 2, i < 9 ? 3 : 4);
    const std::array<std::int64_t, 5> pyramid = {i, i + 1, i + 2, i + 3, i + 5};
    parsed.add_cell(ElementType::pyramid, pyramid, i < 7 ? 4 : 5);
  }
  EXPECT_EQ(parsed.tets(), many);
  const ListedMesh mesh = parsed.take();
  ASSERT_EQ(mesh.runs.size(), 3U);
  EXPECT_EQ(mesh.runs[0].tets, 5);
  EXPECT_EQ(mesh.runs[0].region, 1);
  EXPECT_EQ(mesh.runs[0].subdomain, 3);
  EXPECT_EQ(mesh.runs[1].tets, 4);
  EXPECT_EQ(mesh.runs[1].region, 2);
  EXPECT_EQ(mesh.runs[1].subdomain, 3);
  EXPECT_EQ(mesh.runs[2].tets, many - 9);
  EXPECT_EQ(mesh.runs[2].subdomain, 4);
  const auto& pyramids = mesh.cells[ElementType::pyramid];
  ASSERT_EQ(pyramids.runs.size(), 2U);
  EXPECT_EQ(pyramids.runs[0].tets, 7);
  EXPECT_EQ(pyramids.runs[1].region, 5);
  EXPECT_FALSE(mesh.cells[ElementType::hex].read) << "there are none";
  for (const std::int64_t first : {std::int64_t{0}, std::int64_t{16384}, many - 1}) {
    std::vector<ListedMesh::Nodes> tet(1);
    mesh.read_tets(first, tet);
    EXPECT_EQ(tet[0], (ListedMesh::Nodes{first, first + 1, first + 2, first + 3}));
    std::vector<std::int64_t> nodes(5);
    pyramids.read(first, nodes);
    EXPECT_EQ(nodes,
              (std::vector<std::int64_t>{first, first + 1, first + 2, first + 3, first + 5}));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "its files have no names";
}

TEST(ParsedMesh, keeps_tets_with_tets_and_faces_by_their_type) {
  const TempFolder folder;
  ParsedMesh parsed(folder.path());
  const std::array<std::int64_t, 4> four = {3, 2, 1, 0};
  const std::array<std::int64_t, 3> three = {2, 1, 0};
  parsed.add_cell(ElementType::tet, four, 6, 7);
  parsed.add_face(ElementType::triangle, three, 8);
  parsed.add_face(ElementType::quad, four, 9);
  parsed.mesh().patch_names = {"a"};
  const ListedMesh mesh = parsed.take();
  ASSERT_EQ(mesh.runs.size(), 1U);
  EXPECT_EQ(mesh.runs[0].region, 6);
  EXPECT_EQ(mesh.runs[0].subdomain, 7);
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.triangles[0].nodes, three);
  EXPECT_EQ(mesh.triangles[0].patch, 8);
  ASSERT_EQ(mesh.quads.size(), 1U);
  EXPECT_EQ(mesh.quads[0].nodes, four);
  EXPECT_EQ(mesh.quads[0].patch, 9);
  EXPECT_EQ(mesh.patch_names, std::vector<std::string>{"a"});
  EXPECT_EQ(mesh.nodes, 0);
}

}  // namespace
}  // namespace tetfarm
