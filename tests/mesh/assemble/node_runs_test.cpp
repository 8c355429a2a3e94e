#include "mesh/assemble/node_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/assemble/node_blocks.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/assemble/part_edges.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

/// Nodes whose x is their number.
NumberedPart with_numbers(const std::vector<std::int64_t>& numbers) {
  NumberedPart part;
  part.local2global = numbers;
  for (const std::int64_t number : numbers)
    part.nodes.push_back({static_cast<double>(number), 0, 0});
  return part;
}

std::string runs_of(const std::vector<std::int64_t>& numbers) {
  std::string text;
  for_each_node_run(with_numbers(numbers), [&](std::int64_t first, const std::vector<Vec3>& nodes) {
    text += std::to_string(first) + ":";
    for (const Vec3& p : nodes) text += " " + std::to_string(static_cast<int>(p.x));
    text += "; ";
  });
  return text;
}

TEST(NodeRuns, are_of_consecutive_numbers_ascending_whatever_the_order) {
  EXPECT_EQ(runs_of({}), "");
  EXPECT_EQ(runs_of({0}), "0: 0; ");
  EXPECT_EQ(runs_of({5, 6, 7}), "5: 5 6 7; ");
  EXPECT_EQ(runs_of({7, 8, 2, 0, 1, 9, 4}), "0: 0 1 2; 4: 4; 7: 7 8 9; ");
  EXPECT_EQ(runs_of({3, 2, 1}), "1: 1 2 3; ");
}

TEST(NodeBlocks, are_the_numbers_of_all_tets_in_their_order) {
  NumberedPart part = with_numbers({10, 20, 30, 40, 50});
  part.tets = {{0, 1, 2, 3}, {4, 3, 2, 1}};
  std::vector<std::int64_t> all;
  for_each_block_of_nodes<std::int64_t>(part, 1, [&](const std::vector<std::int64_t>& nodes) {
    all.insert(all.end(), nodes.begin(), nodes.end());
  });
  EXPECT_THAT(all, ElementsAre(11, 21, 31, 41, 51, 41, 31, 21));
  part.tets.assign(2 * 16384 + 1, {0, 1, 2, 3});
  part.tets.back() = {4, 3, 2, 1};
  std::vector<std::size_t> sizes;
  std::int32_t last = 0;
  for_each_block_of_nodes<std::int32_t>(part, 0, [&](const std::vector<std::int32_t>& nodes) {
    sizes.push_back(nodes.size());
    last = nodes.back();
  });
  EXPECT_THAT(sizes, ElementsAre(65536, 65536, 4));
  EXPECT_EQ(last, 20);
}

TEST(PartEdges, are_each_there_once_in_the_order_of_their_nodes) {
  NumberedPart part;
  part.nodes.resize(9);
  part.tets = {{3, 1, 2, 0}, {1, 2, 3, 8}};
  ElementBlock& pyramids = part.blocks[ElementType::pyramid];
  pyramids.nodes = {4, 5, 6, 7, 8};
  pyramids.regions = {1};
  std::string text;
  for (const auto& [a, b] : edges_of(part)) text += std::to_string(a) + std::to_string(b) + " ";
  EXPECT_EQ(text, "01 02 03 12 13 18 23 28 38 45 47 48 56 58 67 68 78 ");
}

TEST(PartCells, are_counted_tets_first_and_boundary_faces_triangles_first) {
  NumberedPart part;
  part.region = 4;
  part.nodes.resize(8);
  part.tets = {{0, 1, 2, 3}};
  part.faces = {{0, 2, 1}};
  part.patch_of_face = {6};
  ElementBlock& hexes = part.blocks[ElementType::hex];
  hexes.nodes = {0, 1, 2, 3, 4, 5, 6, 7};
  hexes.regions = {5};
  ElementBlock& prisms = part.blocks[ElementType::prism];
  prisms.nodes = {0, 1, 2, 3, 4, 5, 1, 2, 3, 4, 5, 6};
  prisms.regions = {2, 3};
  ElementBlock& quads = part.blocks[ElementType::quad];
  quads.nodes = {0, 3, 2, 1};
  quads.regions = {7};
  quads.patches = {8};
  std::string text;
  for_each_cell(part, [&](std::int32_t cell, ElementType type,
                          std::span<const std::int32_t> nodes) {
    text += std::to_string(cell) + std::string(element(type).name) + std::to_string(nodes[0]) + " ";
  });
  EXPECT_EQ(text, "0tet0 1prism0 2prism1 3hex0 ");
  EXPECT_THAT(regions_of_cells(part), ElementsAre(4, 2, 3, 5));
  EXPECT_THAT(regions_of_boundary(part), ElementsAre(4, 7));
  EXPECT_THAT(patches_of_boundary(part), ElementsAre(6, 8));
  EXPECT_EQ(cells_of(part), 4);
  EXPECT_EQ(boundary_faces_of(part), 2);
  part.region_of_tet = {9};
  part.region_of_face = {1};
  EXPECT_THAT(regions_of_cells(part), ElementsAre(9, 2, 3, 5));
  EXPECT_THAT(regions_of_boundary(part), ElementsAre(1, 7));
  const ElementBlock turned = reordered(ElementType::prism, prisms, {1, 0});
  EXPECT_THAT(turned.regions, ElementsAre(3, 2));
  EXPECT_THAT(turned.nodes, ElementsAre(1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5));
  EXPECT_EQ(counts_of(part.blocks)[ElementType::prism], 2);
}

}  // namespace
}  // namespace tetfarm
