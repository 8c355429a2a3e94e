/// The shapes of a mesh's tets side by side: near the cuts and away from them, and of each region.
///
/// Source: thesis 4.3.4.1 judges a decomposition by the elements near its interfaces. Near a cut
/// means within three layers of tets of a node that two sub-domains of one region share; tets are
/// one layer farther when they share a node with the layer before. The interfaces between regions
/// are part of the input, and no cuts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/assemble/shape_statistics.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

inline constexpr int layers_near_cuts = 3;

struct RegionShapes {
  double volume = 0;
  ShapeStatistics shapes;
};

struct MeshShapes {
  ShapeStatistics all;
  ShapeStatistics near_cuts;
  ShapeStatistics away_from_cuts;
  std::vector<RegionShapes> regions;  ///< of region 1, 2, …
};

/// Of each tet of a sub-domain whether it is near a cut; `is_on_cut` tells it of each node.
std::vector<bool> tets_near_cuts(std::span<const Tet> tets, const std::vector<bool>& is_on_cut);

/// Adds the tets of one sub-domain. `is_on_cut` tells it of each node; layers grow within the
/// sub-domain. Cost: O(tets) and of the nodes' number.
void add_shapes(std::span<const Vec3> nodes, std::span<const Tet> tets, std::int32_t region,
                const std::vector<bool>& is_on_cut, MeshShapes& shapes);

/// Adds the figures of one sub-domain to those of the ones before it. Sums are sums of the
/// sub-domains' sums, so that they do not depend on who worked them out.
void add_shapes(const MeshShapes& subdomain, MeshShapes& all);

}  // namespace tetfarm
