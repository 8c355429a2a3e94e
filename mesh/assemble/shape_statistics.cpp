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

/// Of the largest face stands the smallest height: three volumes over its area.
double smallest_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double largest2 = std::max({norm2(cross(b - a, c - a)), norm2(cross(b - a, d - a)),
                                    norm2(cross(c - a, d - a)), norm2(cross(c - b, d - b))});
  return largest2 > 0 ? 6 * tet_volume(a, b, c, d) / std::sqrt(largest2) : 0;
}

}  // namespace

TetShape tet_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {{dihedral_deg(a, b, c, d), dihedral_deg(a, c, b, d), dihedral_deg(a, d, b, c),
           dihedral_deg(b, c, a, d), dihedral_deg(b, d, a, c), dihedral_deg(c, d, a, b)},
          radius_ratio(a, b, c, d),
          smallest_height(a, b, c, d),
          0.25 * (a + b + c + d)};
}

void ShapeStatistics::add(const TetShape& shape) {
  for (const double angle : shape.dihedral_deg) {
    const auto bin = static_cast<std::size_t>(angle / 10);
    ++dihedral_histogram[std::min(bin, dihedral_histogram.size() - 1)];
    max_dihedral_deg = std::max(max_dihedral_deg, angle);
    if (angle < min_dihedral_deg) {
      min_dihedral_deg = angle;
      worst_centroid = shape.centroid;
    }
  }
  min_radius_ratio = std::min(min_radius_ratio, shape.radius_ratio);
  sum_radius_ratio += shape.radius_ratio;
  smallest_height = tets == 0 ? shape.height : std::min(smallest_height, shape.height);
  ++tets;
}

void ShapeStatistics::add(const ShapeStatistics& later) {
  if (later.tets == 0) return;
  for (std::size_t bin = 0; bin < dihedral_histogram.size(); ++bin) {
    dihedral_histogram[bin] += later.dihedral_histogram[bin];
  }
  max_dihedral_deg = std::max(max_dihedral_deg, later.max_dihedral_deg);
  if (later.min_dihedral_deg < min_dihedral_deg) {
    min_dihedral_deg = later.min_dihedral_deg;
    worst_centroid = later.worst_centroid;
  }
  min_radius_ratio = std::min(min_radius_ratio, later.min_radius_ratio);
  sum_radius_ratio += later.sum_radius_ratio;
  smallest_height =
      tets == 0 ? later.smallest_height : std::min(smallest_height, later.smallest_height);
  tets += later.tets;
}

}  // namespace tetfarm
