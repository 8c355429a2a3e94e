#include "mesh/layers/layer_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh/core/element_block.h"
#include "mesh/core/vec3.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

/// A wall triangle whose normal points down, with layers 1 high above it.
Vec3 place_of(const CellNode& node) {
  const std::array<Vec3, 3> wall = {{{0, 0, 0}, {0, 3, 0}, {3, 0, 0}}};
  return wall[static_cast<std::size_t>(node.corner)] + Vec3{0, 0, static_cast<double>(node.level)};
}

std::vector<Vec3> places_of(const LayerCell& cell) {
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < nodes_of(cell.type); ++k) places.push_back(place_of(cell.nodes[k]));
  return places;
}

/// Calls visit(stops) for those of lines whose neighbours may be a layer apart, and more.
template <class Visit>
void for_all_stops(const Visit& visit) {
  for (int a = 0; a <= 3; ++a) {
    for (int b = 0; b <= 3; ++b) {
      for (int c = 0; c <= 3; ++c) visit(std::array<int, 3>{a, b, c});
    }
  }
}

/// Of each of these with all lines that are early, or not.
template <class Visit>
void for_all_columns(const Visit& visit) {
  for_all_stops([&visit](const std::array<int, 3>& stops) {
    for (int mask = 0; mask < 8; ++mask) {
      visit(LayerColumn{stops, {(mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0}});
    }
  });
}

TEST(LayerCells, are_prism_pyramid_or_tet_by_how_many_lines_go_on) {
  EXPECT_EQ(layer_cell({1, 1, 1}, 1).type, ElementType::prism);
  EXPECT_EQ(layer_cell({1, 0, 1}, 1).type, ElementType::pyramid);
  EXPECT_EQ(layer_cell({0, 1, 0}, 1).type, ElementType::tet);
  EXPECT_EQ(layer_cell({2, 3, 2}, 2).type, ElementType::prism);
  EXPECT_EQ(layer_cell({2, 3, 2}, 3).type, ElementType::tet);
}

TEST(LayerCells, where_a_line_is_early_are_two_one_after_the_other) {
  const CellsOfLayer one = cells_of_layer({{2, 2, 2}, {true, false, false}}, 2);
  ASSERT_EQ(one.count, 2U);
  EXPECT_EQ(one.cells[0].type, ElementType::tet);
  EXPECT_EQ(one.cells[1].type, ElementType::pyramid);
  const CellsOfLayer two = cells_of_layer({{2, 2, 2}, {true, false, true}}, 1);
  ASSERT_EQ(two.count, 2U);
  EXPECT_EQ(two.cells[0].type, ElementType::pyramid);
  EXPECT_EQ(two.cells[1].type, ElementType::tet);
  EXPECT_EQ(cells_of_layer({{2, 2, 2}, {true, true, true}}, 1).cells[0].type, ElementType::prism);
  EXPECT_EQ(cells_of_layer({{2, 1, 1}, {true, false, false}}, 2).count, 1U);
}

TEST(LayerCells, every_tet_of_every_division_is_positive) {
  for_all_columns([](const LayerColumn& column) {
    long double volume = 0;
    for (int layer = 1; layer <= layers_above(column.stops); ++layer) {
      for (const LayerCell& cell : cells_of_layer(column, layer)) {
        const std::vector<Vec3> p = places_of(cell);
        EXPECT_GT(element_volume(cell.type, p), 0);
        volume += element_volume(cell.type, p);
        for (const auto& tet : component_tets(cell.type)) {
          EXPECT_GT(orient3d(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]), 0)
              << column.stops[0] << column.stops[1] << column.stops[2] << " layer " << layer;
        }
      }
    }
    // The prism of area 9/2 whose edges are as high as the stops.
    EXPECT_NEAR(static_cast<double>(volume),
                1.5 * (column.stops[0] + column.stops[1] + column.stops[2]), 1e-12);
  });
}

/// Of four corners of a prism all that do not lie in one plane.
TEST(LayerCells, a_prism_has_all_twelve_tets_that_its_corners_make) {
  const std::vector<Vec3> p = places_of(layer_cell({1, 1, 1}, 1));
  std::set<std::set<int>> expected;
  for (int mask = 0; mask < 64; ++mask) {
    std::vector<int> corners;
    for (int k = 0; k < 6; ++k) {
      if ((mask >> k & 1) != 0) corners.push_back(k);
    }
    if (corners.size() != 4) continue;
    const auto at = [&](int i) {
      return p[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])];
    };
    if (orient3d(at(0), at(1), at(2), at(3)) != 0) {
      expected.emplace(corners.begin(), corners.end());
    }
  }
  std::set<std::set<int>> found;
  for (const auto& tet : component_tets(ElementType::prism)) found.emplace(tet.begin(), tet.end());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), 12U);
}

using NodeKey = std::pair<int, int>;

/// Faces within the column cancel; left are the wall, the top, and quads and triangles at the
/// sides, the same for the same two lines whatever the third is.
TEST(LayerCells, of_two_triangles_agree_on_the_sides_between_them) {
  using Ends = std::array<int, 4>;  // stops, and whether early
  std::map<Ends, std::set<std::set<NodeKey>>> side_of_ends;
  for_all_columns([&](const LayerColumn& column) {
    std::map<std::set<NodeKey>, int> faces;
    for (int layer = 1; layer <= layers_above(column.stops); ++layer) {
      for (const LayerCell& cell : cells_of_layer(column, layer)) {
        const std::span<const CellNode> nodes(cell.nodes.data(), nodes_of(cell.type));
        for_each_face_of(cell.type, nodes, [&](ElementType, std::span<const CellNode> face) {
          std::set<NodeKey> key;
          for (const CellNode& n : face) key.emplace(n.corner, n.level);
          ++faces[key];
        });
      }
    }
    std::set<std::set<NodeKey>> side;  // between corners 0 and 1
    for (const auto& [face, count] : faces) {
      EXPECT_LE(count, 2);
      const bool has_third =
          std::any_of(face.begin(), face.end(), [](const NodeKey& n) { return n.first == 2; });
      if (count == 1 && !has_third) side.insert(face);
    }
    const Ends ends = {column.stops[0], column.stops[1], column.early[0] ? 1 : 0,
                       column.early[1] ? 1 : 0};
    const auto [known, is_new] = side_of_ends.emplace(ends, side);
    EXPECT_EQ(known->second, side);
  });
}

}  // namespace
}  // namespace tetfarm
