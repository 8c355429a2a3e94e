/// The order in which the sub-domains have their turn in parallel cosmetics: who shares nodes with
/// whom, and colours such that neighbours never have the same.
///
/// Source: thesis 4.3.4.1 and figures 81 to 83: neighbours are those by face, edge and node, and
/// sub-domains without common elements may be worked on at once. The thesis searches for such sets
/// in a loop of rounds; here each sub-domain has a colour, and waits for its neighbours of lower
/// colour only.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/element_section.h"

namespace tetfarm {

/// A leaf and the nodes of its cuts, by origin, ascending.
struct InterfaceNodes {
  TreePath path;
  std::vector<Origin> nodes;
};

/// The nodes of the triangles that cuts have made.
InterfaceNodes interface_nodes(const Subdomain& leaf);

struct ColouredLeaf {
  TreePath path;
  std::int32_t colour = 0;
  std::vector<TreePath> neighbours;  ///< by face, edge or node; ascending
};

struct CosmeticOrder {
  std::vector<ColouredLeaf> leaves;  ///< by rising heap number
  std::vector<SharedNodes> shared;   ///< of each leaf, in the same order
};

/// Leaves are coloured greedily by rising heap number: each gets the smallest colour that no
/// neighbour before it has. At most 1 + the most neighbours of a leaf colours.
/// @pre the leaves' paths are all different, no node is shared by more than most_sharers leaves.
/// Cost: O(n log n) for n interface nodes in all. Memory: 36 bytes for each of these.
CosmeticOrder colour_subdomains(std::vector<InterfaceNodes> leaves);

}  // namespace tetfarm
