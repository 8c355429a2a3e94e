/// Divides a sub-domain that holds several regions, before any plane cuts it.
///
/// Source: a departure from the thesis, which meshes one material: the regions' interfaces are
/// boundaries that are there already, so they need no inter-domain mesh.
#pragma once

#include <cstdint>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct RegionSplit {
  Subdomain left;
  Subdomain right;
  std::int64_t left_parts = 0;
  std::int64_t right_parts = 0;
};

/// The lower half of the regions goes left, the upper half right. Each region gets its share of
/// `parts` by estimated elements, and at least one.
/// @pre the sub-domain holds several regions; parts is not less than their number.
/// Cost: that of estimated_elements.
RegionSplit split_regions(const Subdomain& subdomain, const SpacingField& spacing,
                          std::int64_t parts);

}  // namespace tetfarm
