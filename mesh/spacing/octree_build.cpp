#include "mesh/spacing/octree_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/spacing/corner_spacing.h"
#include "mesh/spacing/even_blocks.h"
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

  void run() {
    CornerSpacing::Numbers numbers = unknown_numbers<8>();
    visit(0, 0, {0, {}}, numbers);
  }

  SpacingOctree octree_;
  CornerSpacing corners_;

 private:
  template <std::size_t count>
  static std::array<std::uint32_t, count> unknown_numbers() {
    std::array<std::uint32_t, count> numbers;
    numbers.fill(CornerSpacing::unknown);
    return numbers;
  }

  /// Of the 27 corners that the children of a cell have, the one that child k has as its corner.
  static std::size_t corner_among_27(std::size_t k, std::size_t corner) {
    const auto both = [&](std::size_t axis) { return (k >> axis & 1U) + (corner >> axis & 1U); };
    return both(0) + 3 * both(1) + 9 * both(2);
  }

  /// Corner numbers go down and up the tree: few corners are looked up more than once.
  void visit(std::size_t from, std::size_t to, const LatticeCell& cell,
             CornerSpacing::Numbers& numbers) {
    inside_.enter(demand_cell(octree_.frame, cell));
    if (tree_.child_of[from] == 0) {
      octree_.child_of[to] = ~octree_.leaf_count();
      octree_.lattice_level.push_back(tree_.lattice_level[from]);
      corners_.add_leaf(cell, tree_.lattice_level[from] > cell.level, numbers,
                        [&](const GridPoint& p) { return inside_.at(octree_.frame.position(p)); });
    } else {
      visit_children(from, to, cell, numbers);
    }
    inside_.leave();
  }

  void visit_children(std::size_t from, std::size_t to, const LatticeCell& cell,
                      CornerSpacing::Numbers& numbers) {
    const auto first = static_cast<std::size_t>(tree_.child_of[from]);
    const std::size_t first_to = octree_.child_of.size();
    octree_.child_of[to] = static_cast<std::int32_t>(first_to);
    octree_.child_of.resize(first_to + 8);
    auto among_27 = unknown_numbers<27>();
    for (std::size_t k = 0; k < 8; ++k) among_27[corner_among_27(k, k)] = numbers[k];
    for (std::size_t k = 0; k < 8; ++k) {
      CornerSpacing::Numbers of_child;
      for (std::size_t c = 0; c < 8; ++c) of_child[c] = among_27[corner_among_27(k, c)];
      const std::int32_t half = size_at_level(cell.level + 1);
      visit(first + k, first_to + k, {cell.level + 1, corner_of(cell.low, half, k)}, of_child);
      for (std::size_t c = 0; c < 8; ++c) among_27[corner_among_27(k, c)] = of_child[c];
    }
    for (std::size_t k = 0; k < 8; ++k) numbers[k] = among_27[corner_among_27(k, k)];
  }

  const RefinedTree& tree_;
  CellDemand inside_;
};

}  // namespace

double ideal_cell(double spacing) {
  TF_CHECK(spacing > 0);
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
  octree.owned_corners = layout.corners_.owned_corners(octree);
  mark_even_blocks(octree);
  TF_CHECK(octree.values.size() == octree.lattice_level.size() &&
           octree.owned_corners.size() == octree.lattice_level.size());
  return octree;
}

}  // namespace tetfarm
