/// A sub-domain: a closed oriented surface with its provenance; a node of the decomposition tree,
/// or several leaves of it joined, under the place of the first.
///
/// Source: thesis 4.3.1. Provenance makes two sub-domains agree on what they share without ever
/// comparing coordinates, and gives the global numbers of 4.3.4.1.1 by position in the tree.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// Position in the decomposition tree, numbered as a heap: the root is 1, the children of p are 2p
/// (left) and 2p + 1 (right). At most 62 levels.
struct TreePath {
  std::uint64_t heap = 1;

  TreePath left() const { return {2 * heap}; }
  TreePath right() const { return {2 * heap + 1}; }
  int depth() const;
  /// "root", "L", "LR"…: the way from the root.
  std::string text() const;
  friend auto operator<=>(const TreePath&, const TreePath&) = default;
};

/// Where a node or triangle of a sub-domain's boundary came from. `owner` 0: the input surface, and
/// `index` is its vertex or triangle number there. top_of_layers: the top of the layers. Otherwise
/// the inter-domain mesh that cut the sub-domain with heap number `owner`, and `index` is the
/// number in that mesh.
struct Origin {
  std::uint64_t owner = 0;
  std::uint32_t index = 0;

  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// The owner of what lies on top of the layers that grow from the input surface (mesh/layers). It
/// bounds the rest of the domain as the input surface would: nothing but layers is behind it, so
/// nobody moves its nodes. No sub-domain has that heap number.
inline constexpr std::uint64_t top_of_layers = std::uint64_t{1} << 63U;

/// Whether an inter-domain mesh made it: there is, or was, a sub-domain on its other side.
inline bool is_of_cut(const Origin& origin) {
  return origin.owner != 0 && origin.owner != top_of_layers;
}

/// Invariants (validate): 1. vertices/node_origin and triangles/triangle_origin have equal lengths;
/// 2. the surface is closed, every edge used once in each direction (an edge may be shared by more
/// than one pair where shells touch: then equally often in each); 3. node origins are all
/// different, so are triangle origins; 4. every vertex is used. A sub-domain that holds several
/// regions (the root, and what region_split makes of it) has region 0 and the sides of each
/// triangle; then 2 holds of the triangles of each region, turned to point out of it.
struct Subdomain {
  TreePath path;
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Origin> node_origin;
  std::vector<Origin> triangle_origin;
  std::int32_t region = 1;   ///< 0: several, and `sides` tells which is where
  std::vector<Sides> sides;  ///< of each triangle; empty when region > 0
};

/// The root of the tree: the whole input surface. Unused vertices, and triangles between what is
/// not meshed, are dropped.
Subdomain root_subdomain(const SurfaceMesh& surface);

/// What breaks the invariants above, a line each; empty when all hold.
std::vector<std::string> validate(const Subdomain& subdomain);

}  // namespace tetfarm
