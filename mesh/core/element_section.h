/// Elements on their way between sub-domains: what parallel cosmetics reads, improves and writes.
///
/// Source: thesis 4.3.4.1.2 (elements passed between neighbours). The elements near a cut are kept
/// apart by the set of sub-domains that meet there, their *sharers*: a *section*. Whoever improves
/// the mesh round a sub-domain needs the sections that it shares, and no others. What is far from
/// all cuts is a section with one sharer, the *core* of its sub-domain, which never changes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// Sub-domains by heap number, ascending.
using Sharers = std::vector<std::uint64_t>;

/// At most this many sub-domains share a section: an owner is one byte.
inline constexpr std::size_t most_sharers = 255;

/// Nodes are known by origin. That of an interior node is the heap number of the leaf whose mesh
/// (or whose cosmetics) made it and its number among the leaf's own, so no two nodes have the same.
///
/// Invariants (validate): 1. parallel arrays have equal lengths; 2. sharers ascend, owners are
/// places among them; 3. node origins ascend, and every node is one of a tet.
struct ElementSection {
  Sharers sharers;
  std::vector<Vec3> nodes;
  std::vector<Origin> node_origin;
  std::vector<Tet> tets;
  std::vector<std::uint8_t> tet_owner;        ///< whose the tet is: a place in `sharers`
  std::vector<Triangle> triangles;            ///< of the input surface; each a face of a tet
  std::vector<std::uint32_t> triangle_index;  ///< its number in the input surface
  std::vector<std::uint8_t> triangle_owner;   ///< that of its tet
};

/// The core of a leaf's mesh, told by what is not in it.
struct CoreElements {
  std::uint64_t tets = 0;
  /// The numbers of the tets in sections, in the mesh, and of the triangles there, in the input
  /// surface; ascending.
  std::vector<std::uint32_t> taken_tets;
  std::vector<std::uint32_t> taken_triangles;
  std::uint64_t triangles = 0;  ///< of the input surface that are in the core
};

/// Tets of each sharer, in the order of the sharers.
std::vector<std::uint64_t> tets_by_sharer(const ElementSection& section);
/// Triangles of the input surface, the same way.
std::vector<std::uint64_t> triangles_by_sharer(const ElementSection& section);

/// What breaks the invariants, a line each; empty when all hold.
std::vector<std::string> validate(const ElementSection& section);

/// The nodes of a leaf that other leaves have too, with the set of all that do.
///
/// Invariants: origins ascend; `set` is an index into `sets`, each of which holds the leaf.
struct SharedNodes {
  struct Node {
    Origin origin;
    std::uint32_t set = 0;
  };
  TreePath path;
  std::vector<Sharers> sets;
  std::vector<Node> nodes;
};

}  // namespace tetfarm
