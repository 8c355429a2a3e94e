#include "mesh/assemble/forced_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/core/tet_quality.h"
#include "tests/mesh/assemble/cut_grid.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

std::vector<bool> all_of(const SurfaceMesh& surface) {
  return std::vector<bool>(surface.vertices.size(), true);
}

std::int64_t count(const std::vector<bool>& is_forced) {
  return std::count(is_forced.begin(), is_forced.end(), true);
}

/// A box of 4 x 4 squares a face; on its top, far from all edges, a vertex near to its neighbour.
SurfaceMesh box_with_needles() {
  SurfaceMesh box = shapes::box({0, 0, 0}, {4, 4, 4}, 4);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{2, 2, 4}) v.x = 2.999;
  }
  return box;
}

TEST(ForcedNodes, of_a_good_surface_are_none) {
  const SurfaceMesh box = shapes::box({0, 0, 0}, {4, 4, 4}, 4);
  EXPECT_EQ(count(forced_nodes(box, 1, all_of(box))), 0);
}

TEST(ForcedNodes, are_the_corners_of_thin_triangles) {
  const SurfaceMesh box = box_with_needles();
  const std::vector<bool> is_forced = forced_nodes(box, 1, all_of(box));
  EXPECT_GE(count(is_forced), 4);
  for (std::size_t v = 0; v < is_forced.size(); ++v) {
    if (!is_forced[v]) continue;
    EXPECT_LT(distance(box.vertices[v], {2.999, 2, 4}), 1.5) << v;
  }
}

TEST(ForcedNodes, are_the_ends_of_sharp_edges_and_only_inside_the_wedge) {
  // The wedge between z = 0 and the plane through its edge at 3 degrees; good triangles.
  SurfaceMesh wedge;
  wedge.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0.05}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::vector<bool> inside = forced_nodes(wedge, 1, all_of(wedge));
  EXPECT_TRUE(inside[0] && inside[1]);
  SurfaceMesh outside = wedge;
  outside.sides.assign(4, Sides{0, 1});
  const std::vector<bool> is_forced = forced_nodes(outside, 1, all_of(outside));
  // The two triangles at the short edge are thin for either side; at the wedge's edge 2, 3 only.
  EXPECT_EQ(is_forced, std::vector<bool>({true, true, true, true}));
  EXPECT_EQ(count(forced_nodes(outside, 2, all_of(outside))), 0) << "no such region";
}

TEST(ForcedNodes, are_told_of_wanted_ones_only_and_the_same_whatever_else_is_wanted) {
  const SurfaceMesh box = box_with_needles();
  const std::vector<bool> all = forced_nodes(box, 1, all_of(box));
  for (std::size_t v = 0; v < box.vertices.size(); ++v) {
    std::vector<bool> one(box.vertices.size(), false);
    one[v] = true;
    const std::vector<bool> is_forced = forced_nodes(box, 1, one);
    EXPECT_EQ(is_forced[v], all[v]) << v;
    EXPECT_EQ(count(is_forced), all[v] ? 1 : 0) << v;
  }
}

TEST(UnforcedTets, of_a_good_surface_are_all_tets) {
  const CutGrid grid = cut_grid(3);
  for (const std::uint64_t leaf : {2U, 6U, 7U}) {
    const Portion portion = make_portion(grid.parts.at(leaf), grid.surface, grid.numbering());
    const UnforcedTets unforced = unforced_tets(portion, grid.surface, grid.numbering());
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
  const std::vector<bool> is_forced = forced_nodes(grid.surface, 1, all_of(grid.surface));
  ASSERT_TRUE(is_forced[moved]);
  std::int64_t tets = 0;
  std::int64_t unforced = 0;
  double smallest = 180;
  for (const auto& [leaf, part] : grid.parts) {
    const Portion portion = make_portion(part, grid.surface, grid.numbering());
    const UnforcedTets here = unforced_tets(portion, grid.surface, grid.numbering());
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
