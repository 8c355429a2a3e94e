/// Makes the two halves of a sub-domain from the colours of its triangles and an inter-domain mesh.
///
/// Source: thesis 4.3.1 (fig. 47) and 4.3.1.8. Orientation: the inter-domain triangles are oriented
/// out of the left half as they stand; the right half gets them reversed.
#pragma once

#include "mesh/core/subdomain.h"
#include "mesh/decompose/face_colouring.h"
#include "mesh/decompose/interdomain_mesh.h"

namespace tetfarm {

/// Vertices and triangles keep their order and origins. New nodes and inter-domain triangles
/// follow, with origins {subdomain.path.heap, number}, both numbered from 0. Cost: O(n).
Subdomain half_of(const Subdomain& subdomain, const FaceColours& colours,
                  const InterdomainMesh& mesh, Side side);

}  // namespace tetfarm
