/// How lines lean away from the wall: above the first layer they turn towards their neighbours, so
/// that in concave corners they do not meet.
///
/// Source: none in the thesis, whose lines are straight. Directions are averaged in Jacobi rounds;
/// a line keeps a share of what it sees of its worst face. No one way is the best everywhere: nodes
/// that are nearer to each other than layers are high have to go the same way, whatever those
/// further on do, and elsewhere each neighbour tells as much of the shape as the next. Where nodes
/// are nearer to each other than the first few layers are high, they go the same way from the wall.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/layers/wall_graph.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {

enum class Lean : std::uint8_t {
  as_neighbours,  ///< towards their mean
  as_nearest,     ///< towards a mean in which each counts by the reciprocal of its distance
  straight,       ///< as at the wall
  from_wall,      ///< straight, and at the wall towards a mean of reciprocal squared distances
  as_slivers,     ///< straight, but at the middle of slivers as a sliver has it (Sliver)
};
inline constexpr std::array all_leans = {Lean::as_neighbours, Lean::as_nearest, Lean::straight,
                                         Lean::from_wall, Lean::as_slivers};

/// What lines are decided from.
struct LineGround {
  const WallGraph& graph;
  const WallPlanes& planes;
  std::span<const Vec3> normals;  ///< of the faces of the graph, of length 1, into the domain
  std::span<const Vec3> places;   ///< of the feet
};

/// A face that is almost its longest edge: cells on it fold unless the line in the middle goes
/// between those at the ends of the edge.
struct Sliver {
  std::int32_t middle = 0;
  std::array<std::int32_t, 2> ends{};
  double share = 0;  ///< of the last end
};

/// Faces less high than a fiftieth of their longest edge, the lowest first. Cost: O(n log n).
std::vector<Sliver> slivers_of(const LineGround& ground);

/// The normals of the faces at a line.
std::vector<Vec3> normals_at(const LineGround& ground, std::size_t line);

/// The directions that the lines turn to, as long as LayerLine::later is. `along` are those at the
/// wall; where it is zero the line does not move, and has no say; lines of fans
/// are straight. Cost: O(n).
std::vector<Vec3> leaning(const LineGround& ground, std::span<const Vec3> along, Lean lean);

}  // namespace tetfarm
