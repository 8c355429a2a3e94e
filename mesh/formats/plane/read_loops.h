/// Closed loops of points as text: a line "x y" for each point, an empty line or a comment between
/// two loops, `#` before comments; what airfoils are handed round as.
///
/// A first line that is no point is a title. The last point may repeat the first. Airfoils in
/// Lednicer's form are read too: the numbers of points of both sides, an empty line, the upper side
/// from the leading edge to the trailing one, an empty line, the lower side in the same direction.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

struct PlaneLoop {
  std::vector<Vec2> points;  ///< three or more; the first follows the last
  std::string where;         ///< "FILE:LINE" of its first point
};

/// @throws InvalidInput with the file and the line: a line that is no point, a point that repeats
/// the one before, a loop of fewer than three points, sides with other numbers of points than the
/// file says; IoError.
std::vector<PlaneLoop> read_loops(const std::filesystem::path& path);

}  // namespace tetfarm
