#include "mesh/spacing/octree_refine.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

/// Returns the first of the 8 new children.
std::size_t split(RefinedTree& tree, std::size_t node, int level) {
  TF_CHECK(level < octree_max_level && tree.child_of[node] == 0);
  const std::size_t first = tree.child_of.size();
  if (first > std::size_t{most_leaves} / 7 * 8) {
    throw InvalidInput("the spacing asks for more than " + std::to_string(most_leaves) +
                           " octree cells; is a spacing or an edge too small for the domain?",
                       "spacing");
  }
  const int lattice_level = std::max<int>(tree.lattice_level[node], level + 1);
  tree.child_of[node] = static_cast<std::int32_t>(first);
  tree.child_of.resize(first + 8, 0);
  tree.lattice_level.resize(first + 8, static_cast<std::uint8_t>(lattice_level));
  return first;
}

class Refinement {
 public:
  Refinement(const SpacingDemand& demand, const GridFrame& frame, const Box3& domain,
             std::uint64_t looks)
      : demand_(demand), frame_(frame), domain_(domain), inside_(demand), most_looks_(looks) {
    while (is_too_large(ceiling_level_, demand.ceiling)) ++ceiling_level_;
  }

  RefinedTree run() {
    visit(0, {0, {}}, std::nullopt);
    return std::move(tree_);
  }

 private:
  /// What was asked for at the centre of a cell round this one.
  struct Known {
    Vec3 at;
    double spacing = 0;
  };
  enum class Verdict { leaf, split, unknown };

  bool is_too_large(int level, double spacing) const {
    if (level < coarsest_level) return true;
    return level < octree_max_level &&
           size_at_level(level) * frame_.unit > cell_fit / lattice_ratio * spacing;
  }

  /// A spacing twice which does not make a cell too large, whatever the rounding.
  double enough_in(int level) const {
    constexpr double rounding = 1e-6;
    return 0.5 * (1 + rounding) * size_at_level(level) * frame_.unit * lattice_ratio / cell_fit;
  }

  bool is_far_outside(const LatticeCell& cell) const {
    const std::int32_t size = size_at_level(cell.level);
    Box3 wide;
    wide.add(frame_.position(cell.low));
    wide.add(frame_.position(corner_of(cell.low, size, 7)));
    const double edge = size * frame_.unit;
    wide.low -= {edge, edge, edge};
    wide.high += {edge, edge, edge};
    return !wide.overlaps(domain_);
  }

  /// What growth alone tells of a cell: most are far enough from the spacing that would split them,
  /// or keep them whole. The same as asking, always.
  Verdict verdict_by_growth(int level, const CellDemand::Cell& cell,
                            const std::optional<Known>& known) const {
    if (!known || demand_.grows_too_fast() || level < coarsest_level) return Verdict::unknown;
    constexpr double rounding = 1e-9;
    const double change = demand_.growth * distance(known->at, cell.centre);
    const double least = (1 - rounding) * known->spacing - (1 + rounding) * change;
    const double most = (1 + rounding) * (known->spacing + change);
    if (most >= demand_.ceiling) return Verdict::unknown;
    if (is_too_large(level, most)) return Verdict::split;
    const double lowest = least - (1 + rounding) * demand_.growth * cell.half_diagonal;
    if (lowest < enough_in(level) || is_too_large(level, least)) return Verdict::unknown;
    return Verdict::leaf;
  }

  void visit(std::size_t node, const LatticeCell& cell, std::optional<Known> known) {
    const CellDemand::Cell ball = demand_cell(frame_, cell);
    const Verdict verdict = verdict_by_growth(cell.level, ball, known);
    if (verdict == Verdict::leaf) return;
    inside_.enter(ball);
    if (inside_.looked_at() > most_looks_) {
      throw InvalidInput("too many sources or edges ask for a small spacing at one place",
                         "spacing");
    }
    if (verdict == Verdict::split || asks_for_split(node, cell, known)) {
      split_and_visit(node, cell, known);
    }
    inside_.leave();
  }

  /// Asks, and notes what is known then. @pre the cell has been entered.
  bool asks_for_split(std::size_t node, const LatticeCell& cell, std::optional<Known>& known) {
    const CellDemand::Bounds bounds = inside_.bounds(enough_in(cell.level));
    known = Known{demand_cell(frame_, cell).centre, bounds.at_centre};
    if (bounds.is_ceiling) {
      tree_.lattice_level[node] = static_cast<std::uint8_t>(std::max(cell.level, ceiling_level_));
      return false;
    }
    return is_too_large(cell.level, std::min(bounds.at_centre, 2 * bounds.lowest));
  }

  void split_and_visit(std::size_t node, const LatticeCell& cell,
                       const std::optional<Known>& known) {
    if (demand_.background <= 0 && is_far_outside(cell)) return;
    const std::size_t first = split(tree_, node, cell.level);
    const std::int32_t half = size_at_level(cell.level + 1);
    for (std::size_t k = 0; k < 8; ++k) {
      visit(first + k, {cell.level + 1, corner_of(cell.low, half, k)}, known);
    }
  }

  const SpacingDemand& demand_;
  const GridFrame& frame_;
  const Box3& domain_;
  CellDemand inside_;
  std::uint64_t most_looks_;
  int ceiling_level_ = 0;
  RefinedTree tree_;
};

class Balance {
 public:
  explicit Balance(RefinedTree& tree) : tree_(tree) { collect(0, {0, {}}); }

  void run() {
    for (int level = octree_max_level - 1; level > 0; --level) {
      // Splits below append to coarser levels only.
      for (const GridPoint& low : split_at(level)) refine_neighbours(level, low);
    }
  }

 private:
  std::vector<GridPoint>& split_at(int level) { return split_[static_cast<std::size_t>(level)]; }

  void collect(std::size_t node, const LatticeCell& cell) {
    if (tree_.child_of[node] == 0) return;
    split_at(cell.level).push_back(cell.low);
    const std::int32_t half = size_at_level(cell.level + 1);
    const auto first = static_cast<std::size_t>(tree_.child_of[node]);
    for (std::size_t k = 0; k < 8; ++k) {
      collect(first + k, {cell.level + 1, corner_of(cell.low, half, k)});
    }
  }

  void refine_neighbours(int level, const GridPoint& low) {
    const std::int32_t size = size_at_level(level);
    for (std::int32_t dz = -1; dz <= 1; ++dz) {
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const GridPoint p{low[0] + dx * size, low[1] + dy * size, low[2] + dz * size};
          if (std::ranges::all_of(p, [](auto i) { return i >= 0 && i < octree_span; })) {
            refine_to(level, p);
          }
        }
      }
    }
  }

  void refine_to(int level, const GridPoint& p) {
    TF_CHECK(level <= octree_max_level);
    std::size_t node = 0;
    for (int at = 0; at < level; ++at) {
      if (tree_.child_of[node] == 0) {
        if (tree_.lattice_level[node] >= level) return;
        const std::int32_t mask = ~(size_at_level(at) - 1);
        split_at(at).push_back({p[0] & mask, p[1] & mask, p[2] & mask});
        split(tree_, node, at);
      }
      node =
          static_cast<std::size_t>(tree_.child_of[node]) + child_number(p, octree_max_level - at);
    }
  }

  RefinedTree& tree_;
  std::array<std::vector<GridPoint>, octree_max_level> split_;
};

}  // namespace

CellDemand::Cell demand_cell(const GridFrame& frame, const LatticeCell& cell) {
  const std::int32_t half = size_at_level(cell.level) / 2;
  const double half_edge = half * frame.unit;
  return {frame.position(corner_of(cell.low, half, 7)), std::sqrt(3 * half_edge * half_edge)};
}

RefinedTree refine(const SpacingDemand& demand, const GridFrame& frame, const Box3& domain,
                   std::uint64_t looks) {
  return Refinement(demand, frame, domain, looks).run();
}

void balance(RefinedTree& tree) { Balance(tree).run(); }

}  // namespace tetfarm
