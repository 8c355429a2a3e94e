#include "mesh/filling/core_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/array_index.h"
#include "mesh/geometry/triangle_distance.h"
#include "tests/mesh/filling/lattice_cases.h"

namespace tetfarm {
namespace {

using Place = std::array<std::int32_t, 3>;

/// Cells of the lattice by their sizes and centres, and the nodes' places.
struct Lattice {
  explicit Lattice(const std::vector<LatticeNode>& nodes) {
    for (const LatticeNode& node : nodes) {
      places.insert(node.grid);
      if (is_centre(node)) cells.emplace(node.cell_size(), node.grid);
    }
  }
  static bool is_centre(const LatticeNode& node) {
    return (node.grid[0] & (node.cell_size() / 2)) != 0;
  }
  /// Whether every cell within `steps` halves of a cell edge on each axis is of that size.
  bool is_even(const LatticeNode& node, int steps) const {
    const std::int32_t half = node.cell_size() / 2;
    const int first = is_centre(node) ? 0 : 1;
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -steps; y <= steps; ++y) {
        for (int z = -steps; z <= steps; ++z) {
          if ((x & 1) != first || (y & 1) != first || (z & 1) != first) continue;
          const Place cell = {node.grid[0] + x * half, node.grid[1] + y * half,
                              node.grid[2] + z * half};
          if (!cells.contains({node.cell_size(), cell})) return false;
        }
      }
    }
    return true;
  }

  std::set<Place> places;
  std::set<std::pair<std::int32_t, Place>> cells;
};

double distance2_to(const Subdomain& domain, const Vec3& p) {
  double least = HUGE_VAL;
  for (const Triangle& t : domain.triangles) {
    const auto corner = [&](std::size_t k) { return domain.vertices[at(t[k])]; };
    least = std::min(least, distance2_to_triangle(p, corner(0), corner(1), corner(2)));
  }
  return least;
}

std::vector<std::uint8_t> kinds_of(const std::vector<LatticeNode>& nodes, const Subdomain& domain) {
  return find_core_nodes(nodes, LatticeGrid(nodes), domain,
                         BoxTree(triangle_boxes(domain.vertices, domain.triangles)),
                         find_lattice_boundary(nodes, domain));
}

TEST(CoreNodes, are_all_that_lie_among_equal_cells_and_clear_of_the_boundary) {
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1.2, 2));
  Box3 box;
  box.add(Vec3{-1.6, -1.6, -1.6});
  box.add(Vec3{1.6, 1.6, 1.6});
  for (const auto make_field : {lattice_cases::uniform, lattice_cases::graded}) {
    const SpacingField field = make_field();
    const std::vector<LatticeNode> nodes = field.lattice_nodes(box);
    const Lattice lattice(nodes);
    const std::vector<std::uint8_t> kinds = kinds_of(nodes, domain);
    ASSERT_EQ(kinds.size(), nodes.size());
    std::size_t core = 0;
    std::size_t uneven = 0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const LatticeNode& node = nodes[i];
      EXPECT_NE(kinds[i], core_at_cut) << "there are no cuts";
      const double reach = core_reach * node.cell_edge;
      const bool is_clear = distance2_to(domain, node.at) >= reach * reach;
      if (kinds[i] == core_away) {
        ++core;
        EXPECT_TRUE(is_clear);
        // The cells at a corner, those round a centre.
        EXPECT_TRUE(lattice.is_even(node, Lattice::is_centre(node) ? 2 : 1));
        outside += norm(node.at) > 1.2 ? 1U : 0U;
      } else if (is_clear) {
        ++uneven;
        // A cell of another size, or none at all, within two edges.
        EXPECT_FALSE(lattice.is_even(node, Lattice::is_centre(node) ? 4 : 3));
      }
    }
    EXPECT_GT(core, 300U);
    EXPECT_GT(uneven, 100U);
    EXPECT_GT(outside, 50U);
  }
}

TEST(CoreNodes, are_none_where_the_boundary_is_everywhere_near) {
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 0.15, 2));
  const std::vector<LatticeNode> nodes =
      lattice_cases::uniform().lattice_nodes(bounding_box(domain.vertices));
  ASSERT_FALSE(nodes.empty());
  for (const std::uint8_t kind : kinds_of(nodes, domain)) EXPECT_EQ(kind, not_core);
}

}  // namespace
}  // namespace tetfarm
