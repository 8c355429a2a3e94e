/// The regions of a sub-domain that holds several, and the parts of it that hold fewer.
///
/// A triangle between two regions is in the part of each, with the same origin and the same nodes,
/// turned to point out of it: so their meshes conform without more being done.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/subdomain.h"

namespace tetfarm {

/// Sorted; one for a sub-domain of one region.
std::vector<std::int32_t> regions_of(const Subdomain& subdomain);

/// The triangles that bound the region, turned to point out of it.
std::vector<Triangle> triangles_out_of(const Subdomain& subdomain, std::int32_t region);

/// The lower and the upper half of several regions: how the tree is divided until each sub-domain
/// holds one.
struct RegionHalves {
  std::vector<std::int32_t> left;
  std::vector<std::int32_t> right;
};
RegionHalves halves_of(const std::vector<std::int32_t>& regions);

/// The region of a leaf of the tree, by its path alone. @pre the root has the regions from 1 to
/// `regions`, each a leaf at least.
std::int32_t region_of_leaf(TreePath path, std::int32_t regions);

/// What of `whole` bounds one of `regions`, in its order, as the sub-domain `path`. Unused vertices
/// are dropped. A single region's triangles are turned to point out of it; of several, what is on
/// the other side of their triangles becomes 0.
/// @pre whole.region is 0; `regions` is sorted. Cost: O(n).
Subdomain part_of_regions(const Subdomain& whole, const std::vector<std::int32_t>& regions,
                          TreePath path);

}  // namespace tetfarm
