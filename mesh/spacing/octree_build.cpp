#include "mesh/spacing/octree_build.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "mesh/spacing/corner_spacing.h"
#include "mesh/spacing/octree_refine.h"

namespace tetfarm {
namespace {

/// Lays the refined tree out in Morton order and fills the corner table on the way.
class Layout {
 public:
  Layout(const SpacingDemand& demand, const RefinedTree& tree, const GridFrame& frame)
      : tree_(tree), inside_(demand) {
    octree_.frame = frame;
    octree_.child_of.reserve(tree.child_of.size());
    octree_.child_of.resize(1);
  }

  void run() { visit(0, 0, {0, {}}); }

  SpacingOctree octree_;
  CornerSpacing corners_;

 private:
  void visit(std::size_t from, std::size_t to, const LatticeCell& cell) {
    const std::int32_t size = size_at_level(cell.level);
    inside_.enter(demand_cell(octree_.frame, cell));
    if (tree_.child_of[from] == 0) {
      octree_.child_of[to] = ~octree_.leaf_count();
      octree_.lattice_level.push_back(tree_.lattice_level[from]);
      corners_.add_leaf(cell, tree_.lattice_level[from] > cell.level,
                        [&](const GridPoint& p) { return inside_.at(octree_.frame.position(p)); });
    } else {
      const auto first = static_cast<std::size_t>(tree_.child_of[from]);
      const std::size_t first_to = octree_.child_of.size();
      octree_.child_of[to] = static_cast<std::int32_t>(first_to);
      octree_.child_of.resize(first_to + 8);
      for (std::size_t k = 0; k < 8; ++k) {
        visit(first + k, first_to + k, {cell.level + 1, corner_of(cell.low, size / 2, k)});
      }
    }
    inside_.leave();
  }

  const RefinedTree& tree_;
  CellDemand inside_;
};

}  // namespace

double ideal_cell(double spacing) {
  int exponent = 0;
  const double mantissa = std::frexp(spacing / lattice_ratio, &exponent);
  return std::ldexp(std::floor(std::ldexp(mantissa, 20)), exponent - 20);
}

GridFrame grid_frame(const Box3& domain, double reference) {
  const Vec3 sides = domain.size();
  const double side = std::max({sides.x, sides.y, sides.z});
  double root = ideal_cell(reference);
  while (root < 1.02 * side) root *= 2;
  while (root >= 2.04 * side) root /= 2;
  GridFrame frame;
  frame.unit = root / octree_span;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = (domain.centre()[static_cast<int>(axis)] - root / 2) / frame.unit;
    if (!(std::abs(low) < static_cast<double>(GridFrame::farthest))) {
      throw InvalidInput("the domain is too far from the origin for its size", "surface");
    }
    frame.low[axis] = static_cast<std::int64_t>(std::floor(low));
  }
  return frame;
}

SpacingOctree build_octree(const SpacingDemand& demand, const GridFrame& frame,
                           const Box3& domain) {
  RefinedTree tree = refine(demand, frame, domain);
  balance(tree);
  Layout layout(demand, tree, frame);
  layout.run();
  SpacingOctree octree = std::move(layout.octree_);
  if (demand.grows_too_fast()) layout.corners_.limit_growth(demand.growth, frame.unit);
  layout.corners_.make_continuous(octree.child_of);
  octree.values = layout.corners_.leaf_values();
  octree.owned_corners = layout.corners_.owned_corners();
  own_beside_blocks(octree);
  return octree;
}

}  // namespace tetfarm
