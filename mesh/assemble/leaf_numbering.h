/// What one leaf needs of the numbers of the whole mesh: its own place in it, and the global
/// numbers of the nodes on its boundary, whoever made them.
///
/// It comes out of a whole Numbering, or out of the file of one at the cost of the leaf alone
/// (numbering_file.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/assemble/global_numbering.h"
#include "mesh/core/subdomain.h"

namespace tetfarm {

/// The sizes of the whole mesh.
struct MeshTotals {
  std::int64_t subdomains = 0;
  std::int64_t tets = 0;
  std::int64_t faces = 0;    ///< triangles of the surface, of both sides where both are meshed
  std::int32_t regions = 1;  ///< of the surface
  ElementCounts others{};    ///< of layer_types

  friend bool operator==(const MeshTotals&, const MeshTotals&) = default;
};

struct LeafNumbering {
  std::int32_t number = 0;      ///< of the leaf, from 0 in tree order
  std::int64_t first_node = 0;  ///< global number of its first interior node
  std::int64_t kept_nodes = 0;  ///< interior nodes that are in the mesh
  std::int64_t tets = 0;        ///< of the leaf
  std::int64_t first_tet = 0;   ///< tets of the leaves before
  ElementCounts others{};       ///< elements of layer_types of the leaf
  ElementCounts first_other{};  ///< and of the leaves before
  /// Triangles of the input surface in the leaves before; nothing where not all leaves' were
  /// counted.
  std::optional<std::int64_t> first_face;
  std::vector<std::int64_t> node_numbers;  ///< global, of the origins that were asked for
  /// Of the same, in the leaf's region: forced_nodes.h. Nodes on top of layers always are: how the
  /// layers end there is no merit and no fault of the mesh beyond.
  std::vector<bool> is_forced;
  MeshTotals whole;

  friend bool operator==(const LeafNumbering&, const LeafNumbering&) = default;
};

/// Who asks, and for which nodes.
struct LeafQuestion {
  TreePath leaf;
  std::int32_t region = 1;
  std::span<const Origin> nodes;
};

/// @throws Error when there is no such leaf or node. Cost: O(log n) for each node.
LeafNumbering leaf_numbering(const Numbering& numbering, const LeafQuestion& question);

[[noreturn]] void refuse_leaf(TreePath leaf);

}  // namespace tetfarm
