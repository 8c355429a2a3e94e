/// Where on the lines of layers nodes are: on which node of the wall a node's line stands, and how
/// many layers lie between the two. For who reads the mesh: a solver that goes along lines, or the
/// profile of an absorbing layer.
///
/// Source: none in the thesis. A mesh without layers has none of them.
#pragma once

#include <cstdint>
#include <vector>

namespace tetfarm {

/// Of a node that is of no layer, in both arrays.
inline constexpr std::int32_t no_foot = -1;

/// As files have them.
inline constexpr const char* foot_array = "foot";
inline constexpr const char* depth_array = "depth";

/// Of each node of a part; none: no_foot of all. Absorbing layers are counted from the inside, as
/// their cells are (CellMark::pml_depth): the foot is the node of the inner side, of depth 0.
/// Invariant: both are of equal length.
struct NodeFeet {
  std::vector<std::int64_t> foot;   ///< of a foot itself its own number
  std::vector<std::int32_t> depth;  ///< 0: a foot

  bool empty() const { return foot.empty(); }
  void add(std::int64_t foot_of_node, std::int32_t depth_of_node) {
    foot.push_back(foot_of_node);
    depth.push_back(depth_of_node);
  }

  friend bool operator==(const NodeFeet&, const NodeFeet&) = default;
};

}  // namespace tetfarm
