#include "mesh/assemble/shape_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/core/tet_quality.h"

namespace tetfarm {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// The angle at edge pq between the faces to r and to s. Only reported: acos may differ between
/// machines in the last digit.
double dihedral_deg(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 edge = normalized(q - p);
  const Vec3 to_r = (r - p) - dot(r - p, edge) * edge;
  const Vec3 to_s = (s - p) - dot(s - p, edge) * edge;
  const double length = norm(to_r) * norm(to_s);
  if (!(length > 0)) return 0;
  return std::acos(std::clamp(dot(to_r, to_s) / length, -1.0, 1.0)) * degrees_per_radian;
}

}  // namespace

void ShapeStatistics::add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<double, 6> angles = {dihedral_deg(a, b, c, d), dihedral_deg(a, c, b, d),
                                        dihedral_deg(a, d, b, c), dihedral_deg(b, c, a, d),
                                        dihedral_deg(b, d, a, c), dihedral_deg(c, d, a, b)};
  for (const double angle : angles) {
    const auto bin = static_cast<std::size_t>(angle / 10);
    ++dihedral_histogram[std::min(bin, dihedral_histogram.size() - 1)];
    max_dihedral_deg = std::max(max_dihedral_deg, angle);
    if (angle < min_dihedral_deg) {
      min_dihedral_deg = angle;
      worst_centroid = 0.25 * (a + b + c + d);
    }
  }
  const double ratio = radius_ratio(a, b, c, d);
  min_radius_ratio = std::min(min_radius_ratio, ratio);
  sum_radius_ratio += ratio;
  ++tets;
}

}  // namespace tetfarm
