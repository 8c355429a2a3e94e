/// The octree that carries the spacing: look-up, interpolation, and the body-centred lattice.
///
/// Source: docs/kernel.md, "Points inside". Leaves are balanced 2:1 across faces, edges and
/// corners. Positions are integers in half-units: the root cube spans 2^21 of them on an axis, so
/// that the centre of the smallest cell (level 20) is an integer too. A leaf where nothing but the
/// background asks stays one *block*, whatever its size: its lattice is that of its
/// `lattice_level`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/spacing/tree_array.h"

namespace tetfarm {

inline constexpr int octree_max_level = 20;
inline constexpr std::int32_t octree_span = 1 << (octree_max_level + 1);

/// A position in half-units from the root's low corner, each in [0, octree_span].
using GridPoint = std::array<std::int32_t, 3>;

/// The corner (or child) number k has its x, y, z offset in bits 0, 1, 2.
inline GridPoint corner_of(const GridPoint& low, std::int32_t size, std::size_t k) {
  const auto bit = [k](std::size_t axis) { return static_cast<std::int32_t>((k >> axis) & 1U); };
  return {low[0] + size * bit(0), low[1] + size * bit(1), low[2] + size * bit(2)};
}
/// Which child holds `p`: bit `shift` of each coordinate.
inline std::size_t child_number(const GridPoint& p, int shift) {
  const auto bit = [shift](std::int32_t i) { return static_cast<std::size_t>((i >> shift) & 1); };
  return bit(p[0]) | bit(p[1]) << 1U | bit(p[2]) << 2U;
}
inline std::int32_t size_at_level(int level) { return octree_span >> level; }

/// Where the grid lies. `unit` has at most 21 significant bits and the low corner is a whole number
/// of units, so that coordinates are exact unless the domain lies thousands of its sizes from the
/// origin.
struct GridFrame {
  std::array<std::int64_t, 3> low{};
  double unit = 1;

  /// A low corner farther from 0 leaves no room for the grid between doubles.
  static constexpr std::int64_t farthest = std::int64_t{1} << 51;

  double coordinate(std::size_t axis, std::int32_t i) const {
    return static_cast<double>(low[axis] + i) * unit;
  }
  Vec3 position(const GridPoint& p) const {
    return {coordinate(0, p[0]), coordinate(1, p[1]), coordinate(2, p[2])};
  }
};

/// A cell of the lattice: a leaf, or a cell of a block's uniform lattice.
struct LatticeCell {
  int level = 0;
  GridPoint low{};
};

/// Invariants (checked by validate):
///  1. child_of[n] >= 0: the first of 8 consecutive children; else node n is the leaf ~child_of[n];
///  2. leaves are numbered in Morton order, each is one node's, none deeper than octree_max_level;
///  3. values are positive and finite; lattice_level is at least the leaf's level;
///  4. owned_corners has bit k set when the leaf owns its corner k, see owner_of; of a block, when
///     each of its cells owns its corner k (even_blocks.h), or else it is 0.
struct SpacingOctree {
  GridFrame frame;
  TreeArray<std::int32_t> child_of;
  TreeArray<std::array<float, 8>> values;
  TreeArray<std::uint8_t> lattice_level;
  TreeArray<std::uint8_t> owned_corners;

  std::int32_t leaf_count() const { return static_cast<std::int32_t>(lattice_level.size()); }
  double at(const Vec3& point) const;
  double lattice_cell_edge(const Vec3& point) const;
};

/// The first invariant that does not hold, or nullptr.
const char* validate(const SpacingOctree& octree);

struct LeafAt {
  std::int32_t leaf = 0;
  LatticeCell cell;
};
/// The leaf that holds the smallest cell at `p`. @pre each of `p` is in [0, octree_span).
LeafAt leaf_at(std::span<const std::int32_t> child_of, const GridPoint& p);

/// The lattice's cell that holds the smallest cell at `p`. @pre as leaf_at.
LatticeCell lattice_cell_at(const SpacingOctree& octree, const GridPoint& p);

/// A node belongs to several lattice cells; its owner is the smallest that has it as a corner, of
/// equals the one that counts it with the lowest corner number.
LatticeCell owner_of(const SpacingOctree& octree, const GridPoint& node);

/// Which of the lattice nodes are wanted.
struct LatticeFilter {
  const LatticePlane* plane = nullptr;  // only those in it, if given
  /// Cells of the octree and blocks of 64 of the lattice's are left out when it says so, if given.
  const BoxPredicate* is_needless = nullptr;
  /// What the walk comes to is added here, if given.
  LatticeVisits* visits = nullptr;
};

/// The lattice_nodes of a field, in the Morton order of the cells that own them.
std::vector<LatticeNode> lattice_nodes_in(const SpacingOctree& octree, const Box3& box,
                                          const LatticeFilter& filter = {});
/// Those that systematic_sample chooses among all of them.
LatticeSample sample_lattice_in(const SpacingOctree& octree, const Box3& box, std::size_t most);

}  // namespace tetfarm
