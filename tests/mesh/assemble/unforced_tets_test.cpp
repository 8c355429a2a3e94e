#include "mesh/assemble/unforced_tets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/assemble/cut_grid.h"

namespace tetfarm {
namespace {

UnforcedTets unforced_tets_of(const CutGrid& grid, std::uint64_t leaf, const Portion& portion) {
  return unforced_tets(portion, grid.numbering_of(grid.parts.at(leaf).subdomain).is_forced);
}

TEST(UnforcedTets, of_a_good_surface_are_all_tets) {
  const CutGrid grid = cut_grid(3);
  for (const std::uint64_t leaf : {2U, 6U, 7U}) {
    const Portion portion = grid.portion(leaf);
    const UnforcedTets unforced = unforced_tets_of(grid, leaf, portion);
    EXPECT_EQ(unforced.tets, portion.tets) << leaf;
    EXPECT_EQ(unforced.min_dihedral_deg, portion.shapes.all.min_dihedral_deg) << leaf;
  }
}

/// The grid with a vertex of its surface moved along an edge until it nearly meets the next one.
CutGrid grid_with_needles(std::size_t moved, const Vec3& to) {
  CutGrid grid = cut_grid(4);
  const Vec3 from = grid.surface.vertices[moved];
  grid.surface.vertices[moved] = to;
  for (auto& [leaf, part] : grid.parts) {
    for (std::vector<Vec3>* nodes : {&part.subdomain.vertices, &part.mesh.nodes}) {
      std::replace(nodes->begin(), nodes->end(), from, to);
    }
  }
  return grid;
}

std::size_t vertex_at(const SurfaceMesh& surface, const Vec3& p) {
  return static_cast<std::size_t>(std::find(surface.vertices.begin(), surface.vertices.end(), p) -
                                  surface.vertices.begin());
}

TEST(UnforcedTets, have_no_node_of_a_thin_triangle_in_whatever_leaf) {
  const CutGrid good = cut_grid(4);
  const auto middle = std::find_if(
      good.surface.vertices.begin(), good.surface.vertices.end(),
      [](const Vec3& p) { return p.z == 0 && p.x > 0.4 && p.x < 0.6 && p.y > 0.4 && p.y < 0.6; });
  ASSERT_NE(middle, good.surface.vertices.end());
  const std::size_t moved = vertex_at(good.surface, *middle);
  const CutGrid grid = grid_with_needles(moved, {middle->x + 0.2499, middle->y, 0});
  const std::vector<ForcedNode> forced = forced_nodes(grid.surface);
  ASSERT_TRUE(std::binary_search(forced.begin(), forced.end(),
                                 ForcedNode{static_cast<std::int32_t>(moved), 1}));
  std::int64_t tets = 0;
  std::int64_t unforced = 0;
  double smallest = 180;
  for (const auto& [leaf, part] : grid.parts) {
    const Portion portion = grid.portion(leaf);
    const UnforcedTets here = unforced_tets_of(grid, leaf, portion);
    tets += portion.tets;
    unforced += here.tets;
    EXPECT_GT(here.min_dihedral_deg, 40) << leaf;
    smallest = std::min(smallest, portion.shapes.all.min_dihedral_deg);
  }
  EXPECT_LT(smallest, 1);
  EXPECT_LT(unforced, tets);
  EXPECT_GT(unforced, tets / 2);
}

}  // namespace
}  // namespace tetfarm
