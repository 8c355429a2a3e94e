/// Pushes nodes of the cut off surface that the cut has no loop on.
///
/// Source: thesis 4.3.1.9, figures 63 to 65, which splits edges of the inter-domain mesh to lift it
/// away; a departure: the nodes that are there move, to the side that the colour of the surface
/// demands, and the lift is solved again. Fewer planes are refused for it (measured).
#pragma once

#include <optional>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/face_colouring.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/surface_contact.h"

namespace tetfarm {

struct PushOptions {
  /// Nearer than this (in units of SurfaceContact::distance) is pushed.
  double too_near = 0.4;
  /// To this distance, in spacings.
  double to = 0.6;
  /// The height of the cut over or under a corner of the surface, in SurfaceContact::unit.
  double corners_to = 0.5;
  /// A node moves no farther at once than this, in spacings.
  double farthest = 1.5;
};

/// Sets or moves `pushed` heights of the nodes of each contact that is too near; how many moved. 0:
/// either nothing is too near, or nothing can be done about it.
int push_nodes(const InterdomainMesh& mesh, const Subdomain& subdomain, const FaceColours& colours,
               const std::vector<SurfaceContact>& contacts,
               std::vector<std::optional<double>>& pushed, const PushOptions& options = {});

}  // namespace tetfarm
