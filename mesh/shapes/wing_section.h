/// The NACA 0012 section with a closed trailing edge, and the rings round it.
///
/// Source: the four-digit thickness law with the last coefficient -0.1036, which closes the
/// trailing edge. Departs from usual point laws: points are even in arc length. Chord 1 from (0, 0)
/// to (1, 0); x along the chord, z up.
#pragma once

#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// A point of the upper half with its outward normal, both with y = 0.
struct SectionPoint {
  Vec3 at;
  Vec3 normal;
};

/// The upper half from the trailing to the leading edge, finely. At the trailing edge the normal
/// first turns from the direction of the chord to that of the upper side.
std::vector<SectionPoint> upper_half();

/// A ring round the section: what all points that `reach` can be moved to in any direction from
/// the section, made smaller by `shrink` about the middle of the chord, enclose.
struct Ring {
  double shrink = 1;
  double reach = 0;
};

/// The ring about the origin as the middle of a chord of length 1, from behind the trailing edge to
/// before the leading edge over the upper side, as a fine line.
std::vector<Vec3> upper_line(const std::vector<SectionPoint>& half, const Ring& ring);

double length_of(const std::vector<Vec3>& line);

/// `parts` + 1 points on the line, even in its length; first and last are those of the line.
std::vector<Vec3> even_points(const std::vector<Vec3>& line, int parts);

}  // namespace tetfarm
