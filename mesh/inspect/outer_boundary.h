/// An outer boundary round a body, so that the space between the two can be meshed.
///
/// Source: thesis 4.3.1.9 and chapter 5: bodies in the far field of a flow or a wave.
#pragma once

#include <string>

#include "mesh/core/axis_plane.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct OuterBoundary {
  enum class Kind { none, box, sphere } kind = Kind::none;
  /// Box: its half extent along each axis is `factor` times the body's largest half extent, about
  /// the centre of the body's bounding box. Sphere: its radius is `factor` times half the diagonal
  /// of that box.
  double factor = 0;
  /// Edge length of its triangles; 0: from the body's longest edges and growth over the distance.
  double spacing = 0;
  /// The edge length that the job asks for everywhere (spacing.default), 0: none. Without a
  /// `spacing` of its own the boundary has no longer edges than that.
  double default_spacing = 0;
  /// Instead of more triangles than few_triangles, coarser ones: enough to tell how many elements
  /// there would be.
  bool is_sketch = false;
};

/// A boundary is no finer by itself, whatever the body's edges.
inline constexpr double few_triangles = 200'000;
/// The most that a spacing may ask for.
inline constexpr double most_triangles = 10'000'000;

/// The body turned into a hole in a new outer boundary: body triangles reversed, then the
/// boundary's, with a new patch "outer_box" or "outer_sphere". Kind none: the body as it is. A body
/// with sides (checked with is_outside_meshed) keeps its triangles; its region 1 gets the boundary.
/// The spacing is at most a sixth of the box's side. Where it follows from the body's edges, it is
/// coarser than they ask for rather than making more than few_triangles.
/// @pre the body is closed and oriented outward.
/// @throws UsageError when the boundary would touch the body, a number makes no sense, or a spacing
/// asks for more than most_triangles.
SurfaceMesh add_outer_boundary(const SurfaceMesh& body, const OuterBoundary& outer, double growth);

struct HalfOuterBoundary {
  SurfaceMesh surface;  ///< of one patch without a name; open on the plane, to the last bit
  std::string name;     ///< "outer_box" or "outer_sphere"
};

/// Half of the boundary round a body and its mirror image behind the plane: on the side of it that
/// the body is on, 1 or -1. @pre kind is not none; the body lies on that side. @throws as
/// add_outer_boundary.
HalfOuterBoundary half_outer_boundary(const SurfaceMesh& body, const OuterBoundary& outer,
                                      double growth, const AxisPlane& plane, int side);

}  // namespace tetfarm
