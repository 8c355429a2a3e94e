/// Global numbers of nodes and tets, from counts alone: no mesh is read for them.
///
/// Source: thesis 4.3.4.1.1. First the nodes of the input surface in its order (unused vertices are
/// passed over), then the nodes of the inter-domain meshes, cut by cut, then the interior nodes,
/// leaf by leaf. Cuts and leaves come in *tree order*: depth first, a node before its children,
/// left before right. So a number depends on the place in the tree only, never on who meshed when,
/// and regions of space have consecutive numbers. Cells of each type are counted by themselves.
/// What is on top of layers (top_of_layers) is the inter-domain mesh of the root.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/assemble/forced_nodes.h"
#include "mesh/core/element_block.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// What any count of a cut or leaf is at most.
inline constexpr std::int64_t most_in_numbering = std::int64_t{1} << 60;

/// Consecutive nodes that are in no tet of the final mesh: cosmetics removed them, or they were on
/// a cut both sides of which were joined (thesis 4.3.2.2).
struct DroppedRange {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int64_t before = 0;  ///< dropped nodes of the same owner before these
};

/// The nodes that one cut or one leaf made.
struct OwnedNodes {
  std::int64_t made = 0;
  std::int64_t first_node = 0;        ///< the global number of the first that was kept
  std::vector<DroppedRange> dropped;  ///< ascending

  std::int64_t kept() const {
    return dropped.empty() ? made : made - dropped.back().before - dropped.back().count;
  }
};

/// The nodes of one inter-domain mesh.
struct CutNumbers {
  TreePath path;  ///< the sub-domain that was cut
  OwnedNodes nodes;
};

/// The types in a numbering besides tets and triangles: those of layers. The last is of their sides
/// in planes, which few meshes have.
inline constexpr std::array layer_types = {ElementType::pyramid, ElementType::prism,
                                           ElementType::quad};
inline constexpr std::size_t layer_types_without_sides = layer_types.size() - 1;

/// How many of the types a file of such counts has to tell of; 0: none.
std::size_t told_layer_types(const ElementCounts& counts);

/// One sub-domain that was meshed, or a chunk of the layers. Its interior nodes are those that its
/// mesh and its turn in cosmetics made.
struct LeafNumbers {
  TreePath path;
  OwnedNodes nodes;
  std::int64_t tets = 0;
  std::int64_t first_tet = 0;
  ElementCounts others{};       ///< of layer_types
  ElementCounts first_other{};  ///< of the same, in all leaves before
  /// Triangles of the input surface in it, and in all leaves before; nothing where not all were
  /// counted.
  std::optional<std::int64_t> faces;
  std::optional<std::int64_t> first_face;
};

/// A leaf of the tree that is part of the mesh of another.
struct JoinedLeaf {
  TreePath path;
  TreePath into;
};

/// All numbers count from 0. Cuts and leaves are in tree order.
struct Numbering {
  std::int64_t surface_nodes = 0;
  std::vector<std::int32_t> unused_vertices;  ///< of the input surface, ascending
  std::vector<CutNumbers> cuts;
  std::vector<LeafNumbers> leaves;
  std::vector<JoinedLeaf> joined;  ///< in tree order
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  ElementCounts others{};  ///< of layer_types
  // Of the surface, for those who see no more of it than their leaf:
  std::int64_t faces = 0;          ///< sides of its triangles that are meshed
  std::int32_t regions = 1;        ///< that it bounds
  std::vector<ForcedNode> forced;  ///< ascending
};

/// Whether a comes before b in tree order.
bool comes_before(TreePath a, TreePath b);

/// The table that the coordinator makes from the answers of the tasks, in any order, a line each:
/// "cut HEAP INTERDOMAIN_NODES", "leaf HEAP INTERIOR_NODES TETS [TRIANGLES [PYRAMIDS PRISMS
/// [QUADS]]]", "joined HEAP INTO" (a leaf that was joined with the leaf INTO), or "dropped HEAP
/// FIRST COUNT" (nodes of that cut or leaf, ascending). Where the triangles of all leaves but one
/// are told, those of that one follow.
/// @throws Error when a line is not such a one, or the lines are not one whole binary tree.
/// Cost: O(n log n) for n lines, and for the surface.
Numbering number_globally(const SurfaceMesh& surface, std::string_view table);

/// The figures of the surface, which the text of a numbering does not have. Cost: as forced_nodes.
void add_surface_figures(const SurfaceMesh& surface, Numbering& numbering);

/// The heap number by which the numbering knows the owner of a node.
inline std::uint64_t owner_in_tree(const Origin& origin) {
  return origin.owner == top_of_layers ? TreePath{}.heap : origin.owner;
}

/// Whether the triangles of the input surface were counted in every leaf.
bool counts_faces(const Numbering& numbering);

/// The global number of a node by its origin. @throws Error when there is no such node.
/// Cost: O(log n).
std::int64_t global_number(const Numbering& numbering, const Origin& origin);
[[noreturn]] void refuse_node(const Origin& origin);

/// Text, a line for each count, without the figures of the surface: see store/formats.md.
std::string numbering_to_text(const Numbering& numbering);
/// @throws CorruptFile naming `name`.
Numbering numbering_from_text(std::string_view text, const std::string& name);

}  // namespace tetfarm
