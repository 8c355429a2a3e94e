/// Faces of many small triangles in one plane become single polygons with holes, triangulated anew
/// without the nodes within them: what CAD programs write of the results of their booleans.
#pragma once

#include "mesh/core/surface_mesh.h"
#include "tests/support/ear_clipping.h"

namespace tetfarm::shapes {

struct MergeOptions {
  EarOrder order = EarOrder::lowest;
  /// Of 16 nodes in the middle of straight edges so many are kept, by chance.
  int kept_in_16 = 0;
  /// Of 16 faces so many keep their triangles, by chance; so do those whose outline touches itself.
  int unmerged_in_16 = 0;
};

/// The same solid, exactly. @pre a closed oriented surface each of whose edges has two triangles;
/// coordinates are whole numbers up to 2^20. Cost: O(n log n), and that of clip_ears.
SurfaceMesh with_merged_faces(const SurfaceMesh& fine, const MergeOptions& options, Chance& chance);

}  // namespace tetfarm::shapes
