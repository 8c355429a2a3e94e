/// A round tube along any centre line with flat ends, in triangles that are nearly equilateral:
/// what the ducts are made of.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// How high a row of equilateral triangles is over its edge: stations lie as far apart.
constexpr double equilateral_height = 0x1.bb67ae8584caap-1;

/// A circle of the tube: z and `across`, of unit length and orthogonal to z, span its plane; its
/// normal `across` x z points along the tube.
struct DuctStation {
  Vec3 centre;
  Vec3 across;
};

/// The tube through circles of one radius round the stations, closed at the first and the last.
/// Points of every second circle are turned by half a step. Patches: "inlet", "wall", "outlet".
/// Normals point out of the tube.
/// @pre at least two stations, whose circles do not meet.
/// @throws UsageError when the spacing is not positive or far too small. Cost: O(n), 16 MB for each
/// 300 000 triangles.
SurfaceMesh round_duct(const std::vector<DuctStation>& stations, double radius, double spacing);

}  // namespace tetfarm
