/// Shape measures of one tetrahedron (thesis 4.3.4.1: what cosmetics improves and reports give).
#pragma once

#include <array>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// The smallest and largest of the six dihedral angles, degrees. A flat or inverted tet gives 0 and
/// 180.
struct DihedralRange {
  double min_deg = 0;
  double max_deg = 180;
};
DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Cosine of the smallest dihedral angle (cheaper than the angle; larger is worse), and of the
/// largest.
struct DihedralCosines {
  double of_smallest = 1;
  double of_largest = -1;
};
DihedralCosines dihedral_cosines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// False only when dihedral_cosines(a, b, c, d).of_smallest is no more than that: without a root,
/// for the smallest angle of many.
bool may_have_smaller_dihedral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                               double cosine);

/// 3 · inradius / circumradius: 1 for the regular tet, 0 for a flat one.
double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace tetfarm
