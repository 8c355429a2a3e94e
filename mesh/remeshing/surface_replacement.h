/// One change of a surface that is remeshed: triangles that go, those that come in their place, and
/// whether the change may be made.
///
/// A change may be made when what comes has no crossing with anything (exact), lies within the
/// tolerance of the input, and looks the way the input looks there. As the input itself has no
/// crossings, no surface in between has any.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/remeshing/changing_surface.h"
#include "mesh/remeshing/input_shape.h"
#include "mesh/remeshing/remeshing_spacing.h"

namespace tetfarm {

struct SurfaceReplacement {
  std::vector<std::int32_t> removed;
  std::vector<FaceTriangle> made;
  /// What is made has the same edges round it as what goes, and all of it is of one face.
  bool fills_hole = false;

  void clear() {
    removed.clear();
    made.clear();
    fills_hole = false;
  }
};

/// What is remeshed, and what it has to obey.
struct RemeshingWork {
  ChangingSurface& surface;
  const InputShape& shape;
  const RemeshingSpacing& spacing;
  double tolerance = 0;
  /// Whether each change is tested against all that is near it, also where that is hardly needed.
  bool is_strict = false;
  /// When all edges had last been looked at, by ChangingSurface::now(); 0: never.
  std::uint64_t flipped = 0;  ///< for a better shape
  std::uint64_t split = 0;
  /// Kept to save allocating.
  SurfaceReplacement replacement = {};
  std::vector<std::int32_t> near = {};
};

/// The tolerance where a vertex that is no corner lies.
double tolerance_at(const RemeshingWork& work, const SurfaceVertex& vertex);

/// 4 sqrt(3) area / (sum of squared edges): 1 of an equilateral triangle, 0 of one without area.
double triangle_shape(const TrianglePoints& t);
/// The least of the triangles; 1 of none.
double worst_shape(const ChangingSurface& surface, std::span<const std::int32_t> triangles);
double worst_shape(const ChangingSurface& surface, const std::vector<FaceTriangle>& triangles);

/// Sum of the normals of the vertex's triangles in the face, each as long as twice its area.
Vec3 normal_at(const ChangingSurface& surface, std::int32_t v, std::int32_t face);

/// Whether the triangles made look the way that the input looks there, and lie within the tolerance
/// of it with their middles and with the middles of their edges from `hub`.
bool lies_on_input(const RemeshingWork& work, std::int32_t hub);

/// Whether no triangle made is degenerate or meets another, made or not removed, beyond the corners
/// and edges that both have. Unless the work is strict, two things are taken for granted: that in a
/// plane what fills a hole and is nowhere turned over meets nothing, and that neighbours whose
/// normals differ by less than 25 degrees from those made do not fold over them; and a third, that
/// nothing else is where the input looks one way.
/// @pre lies_on_input.
bool meets_nothing(RemeshingWork& work);

/// Makes the change. @pre it may be made.
void replace(RemeshingWork& work);

}  // namespace tetfarm
