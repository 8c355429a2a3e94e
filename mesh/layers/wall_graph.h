/// The wall that layers grow from: its lines, their faces and neighbours, and quantities that may
/// only rise slowly from line to line.
///
/// Source: none in the thesis. A limit that one line has is passed on to its neighbours, and lower
/// values win: the result is the largest field below the given one that rises no faster than asked.
/// It is the same whatever the order, as that of a shortest path is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"
#include "mesh/layers/fan_piece.h"

namespace tetfarm {

/// Rows of numbers, one after the other.
struct NumberRows {
  std::vector<std::int32_t> starts;  ///< one more than there are rows
  std::vector<std::int32_t> numbers;

  std::span<const std::int32_t> of(std::int32_t row) const;
};

struct WallGraph {
  std::vector<std::int32_t> feet;         ///< of the lines: vertices of the surface, ascending
  std::vector<std::int32_t> vertex2line;  ///< the first there; -1: none
  std::vector<std::int32_t> wall;         ///< triangles, ascending
  std::vector<Triangle> wall_lines;       ///< of each its lines
  NumberRows faces;                       ///< of a line: numbers in `wall`
  NumberRows neighbours;                  ///< of a line: other lines, ascending
  std::vector<bool> at_border;            ///< of a line: its foot is on another triangle, too

  /// Whether the line is one of several at its foot.
  bool is_of_fan(std::size_t line) const {
    return (line > 0 && feet[line - 1] == feet[line]) ||
           (line + 1 < feet.size() && feet[line + 1] == feet[line]);
  }
};

/// @pre `wall` are triangles of the surface, ascending. Cost: O(n log n) for n triangles.
WallGraph wall_graph(const SurfaceMesh& surface, std::vector<std::int32_t> wall);

/// The same with several lines at some feet. @param feet of the lines, ascending: the feet of
/// `graph`, some of them more than once. @param corners, pieces by these lines.
/// Cost: O(n log n).
WallGraph with_fans(const WallGraph& graph, std::vector<std::int32_t> feet,
                    std::span<const FanCorner> corners, std::span<const FanPiece> pieces);

/// Lowers values until none is more than `slope` times the distance above that of a neighbour. Of
/// each line the one whose value decided: itself, where its own did; of equals the lowest.
/// @pre `places` and `values` have one for each line. Cost: O(n log n).
std::vector<std::int32_t> limit_slopes(const WallGraph& graph, std::span<const Vec3> places,
                                       double slope, std::vector<double>& values);

/// Lowers stops until none is higher above that of a neighbour than the smaller of their `most`,
/// and lines of one foot have equal ones; returns the same of each line. @pre `most` are positive.
/// Cost: O(n log n).
std::vector<std::int32_t> limit_steps(const WallGraph& graph, std::span<const int> most,
                                      std::vector<int>& stops);

}  // namespace tetfarm
