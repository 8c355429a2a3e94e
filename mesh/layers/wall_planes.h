/// The flat pieces of the surface that lines of layers may run in: planes of symmetry, flat inlets
/// and outlets, the sides of a box.
///
/// Source: none in the thesis, where the whole boundary of the viscous region grows layers. A piece
/// is flat when its points are as near to a plane as six digits let them be, and where it ends
/// within its patch there is a ridge: so a piece of a curved patch is none.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"
#include "mesh/geometry/predicates.h"
#include "mesh/layers/wall_graph.h"

namespace tetfarm {

/// An edge of a plane to what is no part of it, as its own triangle has it.
struct PlaneBorder {
  std::array<std::int32_t, 2> edge{};
  std::int32_t across = -1;  ///< the triangle on the other side
};

struct WallPlane {
  std::int32_t patch = 0;
  std::vector<std::int32_t> triangles;  ///< of the surface, ascending
  std::vector<PlaneBorder> border;
  Vec3 normal;    ///< of length 1, out of the domain
  Vec3 at;        ///< a point of it
  int axis = -1;  ///< 0, 1, 2: the coordinate that all its points have in common, exactly

  /// The part of a direction that lies in the plane; exactly, where it has an axis.
  Vec3 along(const Vec3& direction) const;
  /// Turned so that what is to the left of an edge of the boundary is to the left of it there.
  Vec2 project(const Vec3& point) const;
  Vec3 lift(const Vec2& point) const;
};

/// The planes that a line has to stay in; -1: no more.
using PlanesOfLine = std::array<std::int32_t, 2>;
inline constexpr PlanesOfLine no_planes = {-1, -1};

struct WallPlanes {
  std::vector<WallPlane> planes;
  std::vector<std::int32_t> plane_of_triangle;  ///< -1: none
  /// Of lines at the border of the wall whose other triangles all lie in these; of all others, and
  /// of those for which there is no way along two planes, no_planes.
  std::vector<PlanesOfLine> of_line;

  bool holds(std::size_t line) const { return of_line[line][0] >= 0; }
  /// Whether the line stays in that plane. @pre plane >= 0.
  bool hold_in(std::size_t line, std::int32_t plane) const {
    return of_line[line][0] == plane || of_line[line][1] == plane;
  }
  /// The direction of length 1 next to this one that stays in the planes of the line, or the
  /// direction itself. Zero where there is none.
  Vec3 held(std::size_t line, const Vec3& direction) const;
};

/// @pre `graph` is of the surface. Cost: O(n log n) for n triangles.
WallPlanes wall_planes(const SurfaceMesh& surface, const WallGraph& graph);

/// The normals with their mirror images on the planes: the direction that sees the worst of them
/// best stays in the planes.
std::vector<Vec3> with_images(std::vector<Vec3> normals, const WallPlanes& planes,
                              std::size_t line);

}  // namespace tetfarm
