/// The checks that a cut must pass before it is accepted.
///
/// Source: thesis 4.3.1.9 checks for intersections only; the rest was measured to be needed: angles
/// to the surface and clearance from it, shapes of the cut's own triangles, shells on their own
/// sides.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/face_colouring.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/rim_angles.h"
#include "mesh/decompose/surface_contact.h"

namespace tetfarm {

/// Of each rim edge, the cosine of the smaller angle between the cut and the surface there.
std::vector<double> cosines_at_rim(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                   const std::vector<RimCorner>& corners);

/// The cosine of the smallest angle of the cut's triangles in space.
double cosine_of_smallest_triangle_angle(const InterdomainMesh& mesh, const Subdomain& subdomain);

/// Whether every shell that the cut does not touch lies on the side that its colour says, and every
/// cavity among them beside the body round it. Shells are told by `shell_of_triangle`.
/// Cost: O(shells * (cut triangles + shells)) + O(n).
bool shells_are_on_their_sides(const InterdomainMesh& mesh, const Subdomain& subdomain,
                               const FaceColours& colours,
                               const std::vector<std::int32_t>& shell_of_triangle);

/// What is wrong with these contacts, or nothing: "intersection" or "clearance".
std::string judge_contacts(const std::vector<SurfaceContact>& contacts);

/// Whether this contact alone is a reason to refuse the cut.
bool is_too_near(const SurfaceContact& contact);

}  // namespace tetfarm
