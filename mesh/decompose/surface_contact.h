/// Where a cut meets, or comes close to, the surface of its sub-domain.
///
/// Source: thesis 4.3.1.9, figures 63 to 65 (checking the inter-domain mesh in the original
/// sub-domain). Meeting is exact (mesh/geometry/triangle_intersection.h); distances are for judging
/// only.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/surface_topology.h"
#include "mesh/geometry/box_tree.h"

namespace tetfarm {

struct SurfaceContact {
  std::int32_t cut_triangle = 0;
  std::int32_t surface_triangle = 0;
  /// They share a point that is no shared node and on no shared edge.
  bool meets = false;
  /// The surface triangle has a node on the rim.
  bool is_at_rim = false;
  /// From the new nodes of the cut triangle to the surface triangle, and (away from the rim) back
  /// from its nodes, in `unit`. Large when they share a node.
  double distance = 0;
  /// The smaller of spacing and surface triangle size.
  double unit = 0;
};

struct Closest {
  Vec3 point;
  double distance2 = 0;
};
Closest closest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The part of the surface that a cut can come near to, for many questions while the cut moves a
/// little.
struct NearbySurface {
  std::vector<std::int32_t> triangles;  // ascending
  std::vector<Box3> boxes;              // of these
  BoxTree tree;                         // of the boxes
};

/// The triangles whose boxes, grown by `margin` of their own sizes, overlap the box of a cut
/// triangle. Cost: O((n + m) log m) for n surface and m cut triangles.
NearbySurface find_nearby_surface(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                  const SurfaceTopology& topology, double margin);

/// All pairs that meet or are nearer than `reach` (in units of SurfaceContact::unit), by cut
/// triangle; once there are more than `most`, those found so far.
/// @pre `nearby` was found for a position of the cut not too far away.
/// Cost: O(m log n) for m cut triangles.
std::vector<SurfaceContact> find_contacts(
    const InterdomainMesh& mesh, const Subdomain& subdomain, const SurfaceTopology& topology,
    const NearbySurface& nearby, double reach,
    std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace tetfarm
