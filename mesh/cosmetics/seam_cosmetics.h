/// Cosmetics of a sub-domain together with the elements of its neighbours near their cuts: the
/// nodes of the cuts move, those of the surface do not.
///
/// Source: thesis 4.3.4.1 and figure 79 (elements that only get better when the nodes of the cut
/// move), figure 85 (two layers of a neighbour before its own turn, four after it). What is worked
/// on ends at faces that stay as they are, so the sections together are a valid mesh before and
/// after each turn, and a turn may be taken, lost and taken again at any time.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/element_section.h"
#include "mesh/cosmetics/improve_mesh.h"

namespace tetfarm {

/// More is asked for near cuts than elsewhere: there are few elements, and heights count.
inline CosmeticOptions cosmetics_near_cuts() {
  CosmeticOptions options;
  options.rebuilds_to_wanted = true;
  options.jointly_split_dihedral_deg = 12;
  options.height_in_spacings = 0.35;
  options.most_joint_failures = 2;
  return options;
}

struct SeamOptions {
  /// Layers of a neighbour's elements that are worked on when it had no turn yet, and when it had.
  int first_layers = 2;
  int later_layers = 4;
  CosmeticOptions cosmetics = cosmetics_near_cuts();
};

/// A sub-domain whose turn it is.
struct SeamTurn {
  std::uint64_t self = 0;
  std::vector<std::uint64_t> had_turn;  ///< neighbours whose turn was before, ascending
  std::uint32_t next_node = 0;          ///< the number of the first new node that `self` makes
};

struct SeamResult {
  std::vector<ElementSection> sections;  ///< with the sharers of the given ones, in their order
  std::vector<Origin> gone;              ///< nodes that are in no tet any more, ascending
  std::uint32_t next_node = 0;
  std::int64_t tets = 0;  ///< that were worked on
  CosmeticReport report;
};

/// Improves the elements of `self` near its cuts and those of its neighbours. New nodes have
/// origins of `self`. A new tet belongs where its centroid lay. Deterministic.
/// @pre the sections are all those with the sharer `self` but its core, as the turns before left
/// them.
/// @throws Error when what comes out is not a valid mesh with the same outer faces.
/// Cost: that of improve_mesh, and O(n log n) for n tets.
SeamResult improve_seams(std::vector<ElementSection> sections, const SeamTurn& turn,
                         const SeamOptions& options = {});

}  // namespace tetfarm
