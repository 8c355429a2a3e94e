/// Where feet get several lines: at convex edges that are sharper than an angle, and the corners
/// where these meet.
///
/// Source: thesis 4.4 leaves sharp trailing edges to one line, which leans along them; several
/// directions at such nodes are AFLR's and Pointwise's. The faces round a foot are divided into
/// groups at its sharp edges. Each group has a line of its own, in the direction that sees the
/// worst of its faces best; between the lines of two groups there are as many more as leave no gap
/// above the angle, found by halving so that all machines have the same. A foot whose cells would
/// not be positive keeps one line. At the border of the wall feet have several only where all that
/// is beside the wall there is one plane, and then all their lines run in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"
#include "mesh/layers/fan_piece.h"
#include "mesh/layers/height_law.h"
#include "mesh/layers/wall_graph.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {

/// What a foot may have of fans, and what their cells are tried with.
struct FanWish {
  double cosine =
      -1;  ///< of the angle between faces above which there are several lines; -1: never
  HeightLaw law;
  int count = 0;  ///< layers
};

/// Lines by their feet, ascending; of one foot first those of its groups, then those between them.
struct LineFans {
  std::vector<std::int32_t> feet;
  std::vector<Vec3> along;         ///< LayerLine::along of the lines of fans; zero of others
  std::vector<bool> early;         ///< LayerLine::early
  std::vector<FanCorner> corners;  ///< ascending; none where the line is the first of its foot
  std::vector<FanPiece> pieces;
};

/// @param graph with a line a foot, and without fans; planes are of it. @param normals of its wall,
/// of length 1, into the domain. @param along LayerLine::along of its lines where there is no fan,
/// zero where there are no layers then. @param wishes of each line. No pieces: there is no fan, and
/// the rest is as in the graph. Cost: O(n log n) for n triangles, a few times where cells are not
/// positive.
LineFans line_fans(const SurfaceMesh& surface, const WallGraph& graph, const WallPlanes& planes,
                   std::span<const Vec3> normals, std::span<const Vec3> along,
                   std::span<const FanWish> wishes);

}  // namespace tetfarm
