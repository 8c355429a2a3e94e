/// The spacing at the octree's corners, each corner once, and who owns it as a lattice node.
///
/// A corner *hangs* where a coarser leaf touches it without having it as a corner; it takes the
/// value that this leaf interpolates, which makes the field continuous.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/spacing/spacing_octree.h"

namespace tetfarm {

class CornerSpacing {
 public:
  CornerSpacing();

  /// The numbers of a cell's corners, as far as they are known.
  using Numbers = std::array<std::uint32_t, 8>;
  static constexpr std::uint32_t unknown = ~std::uint32_t{0};

  /// The next leaf in Morton order; `spacing` is asked at corners not met before. A block owns
  /// nothing. Looks up, and fills in, those of the numbers that are unknown.
  void add_leaf(const LatticeCell& leaf, bool is_block, Numbers& numbers,
                const std::function<double(const GridPoint&)>& spacing);

  /// Lowers values until, inside each leaf, no two corners differ by more than growth times their
  /// distance. Cost: a few passes over the leaves.
  void limit_growth(double growth, double unit);

  /// Gives hanging corners their interpolated values.
  /// @pre child_of is the tree of the leaves added.
  void make_continuous(std::span<const std::int32_t> child_of);

  std::vector<std::array<float, 8>> leaf_values() const;

  /// A mask for each leaf, none for blocks; their lattices count.
  /// @pre the octree, but for the masks, is that of the leaves added.
  std::vector<std::uint8_t> owned_corners(const SpacingOctree& octree);

 private:
  struct Corner {
    GridPoint at{};
    double spacing = 0;
    std::uint8_t touching_leaves = 0;
    std::int8_t owner_level = -1;
    std::uint8_t owner_corner = 8;
    bool touches_block = false;
  };
  struct Hanging {
    std::size_t corner = 0;
    std::int32_t leaf = 0;
  };
  static std::uint64_t key_of(const GridPoint& p);
  std::uint32_t find_or_add(const GridPoint& p,
                            const std::function<double(const GridPoint&)>& spacing);
  void grow_table();
  void settle_owners(const SpacingOctree& octree);
  double interpolated(std::int32_t leaf, const GridPoint& p) const;

  bool has_blocks_ = false;
  std::vector<Corner> corners_;
  std::vector<LatticeCell> leaves_;
  std::vector<Numbers> corners_of_leaf_;
  /// Open addressing: number of the corner + 1, 0 when free. Its order never matters.
  std::vector<std::uint32_t> table_;
};

}  // namespace tetfarm
