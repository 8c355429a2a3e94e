#include "mesh/spacing/lattice_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetfarm {
namespace {

constexpr double nodes_per_cell = 2;
/// Powers of the inverse of the root of x^4 = x + 1: multiples of them, less their whole parts,
/// fill a cube evenly (M. Roberts, "The unreasonable effectiveness of quasirandom sequences",
/// 2018).
constexpr std::array<double, 3> even_steps = {0.8191725133961645, 0.6710436067037893,
                                              0.5497004779019703};

/// The part of an octree leaf that lies in the box.
struct LeafInBox {
  Box3 part;
  bool is_whole = true;
  double lattice_edge = 0;
};

/// Calls `take` for each leaf that meets the box, in Morton order.
template <class Take>
class LeavesInBox {
 public:
  LeavesInBox(const SpacingOctree& octree, const Box3& box, const Take& take)
      : octree_(octree), box_(box), take_(take) {}

  void visit(std::size_t node, const LatticeCell& cell) const {
    const std::int32_t size = size_at_level(cell.level);
    const Box3 whole{octree_.frame.position(cell.low),
                     octree_.frame.position(corner_of(cell.low, size, 7))};
    if (!whole.overlaps(box_)) return;
    const std::int32_t child = octree_.child_of[node];
    if (child >= 0) {
      const std::int32_t half = size / 2;
      for (std::size_t k = 0; k < 8; ++k) {
        visit(static_cast<std::size_t>(child) + k, {cell.level + 1, corner_of(cell.low, half, k)});
      }
      return;
    }
    LeafInBox leaf;
    for (int axis = 0; axis < 3; ++axis) {
      leaf.part.low[axis] = std::max(whole.low[axis], box_.low[axis]);
      leaf.part.high[axis] = std::min(whole.high[axis], box_.high[axis]);
      leaf.is_whole = leaf.is_whole && leaf.part.low[axis] == whole.low[axis] &&
                      leaf.part.high[axis] == whole.high[axis];
    }
    const auto number = static_cast<std::size_t>(~child);
    leaf.lattice_edge = size_at_level(octree_.lattice_level[number]) * octree_.frame.unit;
    take_(number, cell, leaf);
  }

 private:
  const SpacingOctree& octree_;
  const Box3& box_;
  const Take& take_;
};

template <class Take>
void for_each_leaf(const SpacingOctree& octree, const Box3& box, const Take& take) {
  LeavesInBox<Take>(octree, box, take).visit(0, {0, {}});
}

double nodes_in(const LeafInBox& leaf) {
  const Vec3 cells = leaf.part.size() / leaf.lattice_edge;
  return nodes_per_cell * cells.x * cells.y * cells.z;
}

double even_share(std::size_t number, std::size_t axis) {
  const double multiple = (static_cast<double>(number) + 0.5) * even_steps[axis];
  return multiple - std::floor(multiple);
}

LatticeNode node_in(const LeafInBox& leaf, std::size_t number) {
  LatticeNode node;
  const Vec3 size = leaf.part.size();
  for (int axis = 0; axis < 3; ++axis) {
    const double share = even_share(number, static_cast<std::size_t>(axis));
    node.at[axis] = leaf.part.low[axis] + share * size[axis];
  }
  node.cell_edge = leaf.lattice_edge;
  return node;
}

}  // namespace

double cells_to_walk(const SpacingOctree& octree, const Box3& box) {
  double cells = 0;
  for_each_leaf(octree, box,
                [&](std::size_t number, const LatticeCell& cell, const LeafInBox& leaf) {
                  cells += 1;
                  const bool is_block = octree.lattice_level[number] > cell.level;
                  const bool is_even = octree.owned_corners[number] != 0;
                  if (!is_block || (is_even && leaf.is_whole)) return;
                  const Vec3 n = leaf.part.size() / leaf.lattice_edge + Vec3{1, 1, 1};
                  cells += 2 * (n.x * n.y + n.y * n.z + n.z * n.x);
                });
  return cells;
}

LatticeSample sample_by_volume(const SpacingOctree& octree, const Box3& box, std::size_t most) {
  double nodes = 0;
  for_each_leaf(octree, box, [&](std::size_t, const LatticeCell&, const LeafInBox& leaf) {
    nodes += nodes_in(leaf);
  });
  LatticeSample sample;
  sample.nodes_for_each = nodes / static_cast<double>(most);
  sample.nodes.reserve(most);
  double below = 0;
  for_each_leaf(octree, box, [&](std::size_t, const LatticeCell&, const LeafInBox& leaf) {
    below += nodes_in(leaf);
    while (sample.nodes.size() < most &&
           (static_cast<double>(sample.nodes.size()) + 0.5) * sample.nodes_for_each <= below) {
      sample.nodes.push_back(node_in(leaf, sample.nodes.size()));
    }
  });
  return sample;
}

}  // namespace tetfarm
