/// How many elements a sub-domain will get, and where they lie.
///
/// Source: thesis 4.3.1 and 4.3.2 balance by the number of boundary faces; a departure: the nodes
/// of the job's lattice are known before there is a mesh, so those are counted that the volume
/// mesher will take (inside, and clear of the boundary: mesh/filling/point_insertion.h). A mesh has
/// close to 6 tets for each of them and 1.3 for each boundary triangle (measured:
/// docs/decisions/0006-decompose-cut-recipe.md).
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct WorkSample {
  Vec3 at;
  double work = 0;     // elements
  double spacing = 0;  // length
  double width = 0;    // of the cube that it stands for
};

struct WorkSamples {
  std::vector<WorkSample> samples;
  double total = 0;
};

/// Enough for a plane: shares of the work are then within about a percent.
inline constexpr std::size_t samples_for_placing = 4000;

/// Every n-th lattice node, at most `most` of them, and every m-th boundary triangle, a quarter as
/// many.
/// @pre the surface is closed and oriented outward. Cost: O((s + t) log s) for s samples,
/// t triangles, and O(lattice cells).
WorkSamples sample_work(const Subdomain& subdomain, const SpacingField& spacing,
                        std::size_t most = samples_for_placing);

}  // namespace tetfarm
