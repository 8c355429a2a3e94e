/// Makes the domain of half a body that ends on a plane of symmetry: half an outer boundary, and
/// the plane between the two, meshed.
///
/// Source: none in the thesis, whose half bodies come closed. The plane is filled by the planar
/// kernel (mesh/planar), as cuts are. Lengths in the unit of the input.
#pragma once

#include <functional>

#include "mesh/core/surface_mesh.h"
#include "mesh/half_body/plane_loops.h"
#include "mesh/inspect/outer_boundary.h"

namespace tetfarm {

/// Target edge length at a point.
using HalfBodySpacing = std::function<double(const Vec3&)>;

/// Makes a spacing from triangles whose edges it is to take on; they are an open surface.
using MakeHalfBodySpacing = std::function<HalfBodySpacing(const SurfaceMesh&)>;

struct ClosedHalfBody {
  /// The body's triangles first, by their numbers and with their patches; then the outer boundary's
  /// with its patch, if there is one, and those of the plane, patch "symmetry". Triangles need not
  /// agree on a side.
  SurfaceMesh surface;
  PlaneLoops ends;
  std::int64_t plane_triangles = 0;
};

/// The patch of the plane; where the body has one that is called so, "symmetry_2", and so on.
inline constexpr const char* symmetry_patch = "symmetry";

/// Without an outer boundary the domain is inside the surface, as of half a duct. The box is half
/// of the one round the body and its mirror image, and so is the sphere.
/// @throws InvalidInput as find_plane_loops, and when loops cross or touch each other; UsageError
/// as add_outer_boundary. Cost: O(n log n), and O(loops · n) where many loops lie in each other.
ClosedHalfBody close_half_body(SurfaceMesh body, const AxisPlane& plane, const OuterBoundary& outer,
                               double growth, const MakeHalfBodySpacing& make_spacing);

}  // namespace tetfarm
