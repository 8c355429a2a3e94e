/// What layers grow where: decided from the surface alone, before there is any layer. Every point
/// of a layer is then a closed formula of its line, so layers can be made chunk by chunk, in any
/// order, by anybody.
///
/// Source: thesis 4.4 (extraction lines, figs. 89 to 97). It decides while it advances, layer by
/// layer, against the whole front; here everything that needs a view of the whole comes first. The
/// rule of nodes is the thesis's: above a triangle of which three nodes have grown there is a
/// prism, of two a pyramid, of one a tet, so that no quad is ever on the front. Validity: every tet
/// into which the cells can be divided is positive, and the top with the rest of the surface is an
/// embedded closed surface, by exact tests: then the cells tile what lies between, as none covers a
/// place twice that the two surfaces go round once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/layers/fan_piece.h"
#include "mesh/layers/height_law.h"
#include "mesh/layers/layer_request.h"
#include "mesh/layers/wall_graph.h"

namespace tetfarm {

/// Why a line has no more layers than it has.
enum class StopReason : std::uint8_t {
  complete,  ///< it has all
  border,    ///< its foot is on a patch without layers
  ridge,     ///< no single direction sees all faces at its foot
  no_room,   ///< another part of the surface is opposite
  fold,      ///< cells would turn over
  crossing,  ///< the top would cross something
};
inline constexpr std::array all_stop_reasons = {StopReason::complete, StopReason::border,
                                                StopReason::ridge,    StopReason::no_room,
                                                StopReason::fold,     StopReason::crossing};
const char* name_of(StopReason reason);

/// Where a line ends that meets others: one of absorbing layers in blocks (pml_blocks.h).
struct LineEnd {
  std::int32_t line = -1;    ///< whose point its last one is; -1: of none
  int level = 0;             ///< of that point there
  std::int32_t vertex = -1;  ///< of a line all of whose points are vertices of the surface the last
  int depth = 0;             ///< how many layers it is away from the inner side; 0: it is there
  // Where it is not there, of the nearest node that is:
  std::int32_t inner_line = -1;    ///< whose top that is; -1: of none
  std::int32_t inner_vertex = -1;  ///< or which vertex of the surface; -1: none

  friend bool operator==(const LineEnd&, const LineEnd&) = default;
};

/// On which the layers of one node of the wall end. Its point at a height s, one of
/// levels_of(law, stop), is at + s * d. There d is `along` for s up to `bends_from`, `later` from
/// `bends_to` on, and between the two it turns from one to the other as 3 w^2 - 2 w^3 does. Where
/// `bends_to` is no more than `bends_from`, the line turns there, and goes on by `later`.
struct LayerLine {
  std::int32_t foot = 0;  ///< vertex of the surface
  Vec3 at;
  Vec3 along;  ///< so long that of a step of 1 the mean of a face's corners is 1 away from it
  Vec3 later;  ///< so long that a step of 1 is at least 1 away from every face at the foot
  double bends_from = 0;
  double bends_to = 0;
  HeightLaw law;
  int stop = 0;             ///< layers that it has
  int wanted = 0;           ///< layers that were asked for
  double first_wanted = 0;  ///< the first height that was asked for
  StopReason reason = StopReason::complete;
  /// The vertex at which that is so: its own foot, or that of a line further on, which it may not
  /// rise above by more than a layer from line to line.
  std::int32_t because_of = -1;
  bool of_pml = false;   ///< its layers absorb, and lie outside of what the domain was
  bool in_tets = false;  ///< cells whose lines are all like this are divided into tets
  /// So many of its last points are vertices of the surface, `first_vertex` and those that follow:
  /// of a line that runs in a plane its top, and the points below that triangles there have, all
  /// where these are in the place of quads.
  int vertices = 0;
  std::int32_t first_vertex = -1;
  /// The vertex of the surface that its point of level 1 is, as at the end of a fan in a plane,
  /// where that is none of the last ones; -1: none.
  std::int32_t low_vertex = -1;
  /// In each layer it goes on before its neighbours that are not early: the end of a fan.
  bool early = false;
  LineEnd end = {};

  friend bool operator==(const LayerLine&, const LayerLine&) = default;
};

/// An edge of the wall from which layers grow along a plane: their sides there are boundary quads,
/// as many as the lower of the two lines has layers, or pairs of triangles where they have those
/// (is_divided).
struct LayerSide {
  std::int32_t triangle = 0;  ///< of the wall
  int corner = 0;             ///< the edge runs from there to the next corner of the triangle
  std::int32_t patch = 0;     ///< of the plane
  /// The first of its triangles of the surface, which follow each other as triangles_of has them:
  /// where one of the lines has layers more, as many above the quads, with the lower line's top and
  /// two points of the other as corners. -1: none.
  std::int32_t last = -1;

  friend bool operator==(const LayerSide&, const LayerSide&) = default;
};

struct LayerPlan {
  std::vector<LayerLine> lines;           ///< by their feet, ascending
  std::vector<std::int32_t> vertex2line;  ///< the first there; -1: no layers are asked for
  std::vector<std::int32_t> wall;         ///< triangles of the patches with layers, ascending
  std::vector<LayerSide> sides;           ///< by triangle and corner, ascending
  std::vector<FanPiece> fans;             ///< edge by edge, corner by corner
  std::vector<FanCorner> fan_corners;     ///< ascending
};

/// The point of the line at a level. Cost: O(level).
Vec3 point_of(const LayerLine& line, int level);

/// All points of the line, from its foot to its top. Cost: O(line.stop).
std::vector<Vec3> points_of(const LayerLine& line);

/// The vertex of the surface that the point of the line at that level is; -1 where it is none.
/// @pre 0 <= level <= line.stop.
inline std::int32_t vertex_at(const LayerLine& line, int level) {
  if (level == 0) return line.foot;
  if (level == line.stop && line.end.vertex >= 0) return line.end.vertex;
  if (level == 1 && line.low_vertex >= 0) return line.low_vertex;
  const int below_surface = line.stop - line.vertices;  // the levels that are no vertices
  return level > below_surface ? line.first_vertex + level - below_surface - 1 : -1;
}

/// Whether its last point is a node of the top that no line before it has.
inline bool has_top(const LayerLine& line) {
  return line.stop > 0 && line.vertices == 0 && line.end.line < 0;
}

/// The lines of a wall triangle, in its order.
std::array<std::int32_t, 3> lines_of(const LayerPlan& plan, const SurfaceMesh& surface,
                                     std::int32_t triangle);

/// The wall of the plan with its lines. Cost: O(n log n).
WallGraph graph_of(const LayerPlan& plan, const SurfaceMesh& surface);

/// @pre the surface has one region, it is behind every triangle, and check_surface found no
/// defects; no patch is in two requests; patches with ways are whole shells. @throws UsageError
/// where lines with ways given could not have all layers. Cost: O(n log n) for n triangles, and
/// O(cells) to prove.
LayerPlan plan_layers(const SurfaceMesh& surface, std::span<const LayerRequest> requests);

}  // namespace tetfarm
