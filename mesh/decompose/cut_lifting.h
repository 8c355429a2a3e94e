/// Brings an inter-domain mesh from its plane to where it meets the surface well and nothing else.
///
/// Source: thesis 4.3.1.9 (mapping back, figures 63 to 65): the lift (lift_heights.h) and the
/// pushes off the surface (intersection_repair.h) in turn.
#pragma once

#include <vector>

#include "mesh/decompose/face_colouring.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/rim_angles.h"
#include "mesh/decompose/surface_contact.h"

namespace tetfarm {

/// Whether a cut has so many contacts that no push will clear it: more than 12 for each of its
/// triangles, and 200, as where it passes through fans of needles. Measured:
/// docs/decisions/0006-decompose-cut-recipe.md.
bool is_entangled(const InterdomainMesh& mesh, const std::vector<SurfaceContact>& contacts);

/// Sets the heights; the contacts with the surface that remain, or the first of them when the cut
/// is entangled. The nodes of the lattice in the inter-domain mesh stay in the plane, where nothing
/// but a contact moves them.
/// Cost: O((n + m) log n) for n surface and m cut triangles.
std::vector<SurfaceContact> lift_and_push(InterdomainMesh& mesh, const Subdomain& subdomain,
                                          const SurfaceTopology& topology,
                                          const FaceColours& colours,
                                          const std::vector<RimCorner>& corners);

}  // namespace tetfarm
