#include "mesh/assemble/shape_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/core/tet_quality.h"

namespace tetfarm {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// Of the angle between two faces, by their normals into the tet; 1, no angle, where one has no
/// area.
double cosine_between(const Vec3& n, const Vec3& m, double norms) {
  return norms > 0 ? std::clamp(-dot(n, m) / norms, -1.0, 1.0) : 1.0;
}

/// Cosines of 10, 20, … 170 degrees. Only reported: they may differ between machines in the last
/// digit.
std::array<double, 17> cosines_of_bins() {
  std::array<double, 17> cosines;
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    cosines[i] = std::cos(static_cast<double>(10 * (i + 1)) / degrees_per_radian);
  }
  return cosines;
}

/// The bins of a histogram of angles, found by cosine. Of the 64 steps from -1 to 1 each holds one
/// limit at most: a look-up and one comparison tell the bin.
class AngleBins {
 public:
  AngleBins() : limits_(cosines_of_bins()) {
    for (std::size_t step = 0; step < first_bin_.size(); ++step) {
      const double end = static_cast<double>(step + 1) / half_steps - 1;
      first_bin_[step] = static_cast<std::size_t>(std::count_if(
          limits_.begin(), limits_.end(), [end](double limit) { return end <= limit; }));
    }
  }

  /// How many of the limits the angle has reached. @pre from -1 to 1.
  std::uint8_t bin_of(double cosine) const {
    const auto step = static_cast<std::size_t>((cosine + 1) * half_steps);
    const std::size_t bin = first_bin_[std::min(step, first_bin_.size() - 1)];
    const bool is_in_next = bin < limits_.size() && cosine <= limits_[bin];
    return static_cast<std::uint8_t>(is_in_next ? bin + 1 : bin);
  }

 private:
  static constexpr double half_steps = 32;
  std::array<double, 17> limits_;
  std::array<std::size_t, 64> first_bin_{};
};

double degrees_of(double cosine) { return std::acos(cosine) * degrees_per_radian; }

}  // namespace

TetShape tet_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // Of the faces opposite a, b, c and d.
  const std::array<Vec3, 4> n = {cross(d - b, c - b), cross(c - a, d - a), cross(d - a, b - a),
                                 cross(b - a, c - a)};
  const std::array<double, 4> areas = {norm(n[0]), norm(n[1]), norm(n[2]), norm(n[3])};
  const auto cosine = [&](std::size_t i, std::size_t j) {
    return cosine_between(n[i], n[j], areas[i] * areas[j]);
  };
  const double largest = *std::max_element(areas.begin(), areas.end());
  TetShape shape;
  // At the edges ab, ac, ad, bc, bd, cd.
  shape.dihedral_cosines = {cosine(2, 3), cosine(1, 3), cosine(1, 2),
                            cosine(0, 3), cosine(0, 2), cosine(0, 1)};
  static const AngleBins bins;
  for (std::size_t i = 0; i < 6; ++i) {
    shape.dihedral_bins[i] = bins.bin_of(shape.dihedral_cosines[i]);
  }
  const auto [least, most] =
      std::minmax_element(shape.dihedral_cosines.begin(), shape.dihedral_cosines.end());
  shape.max_dihedral_deg = degrees_of(*least);
  shape.min_dihedral_deg = degrees_of(*most);
  shape.radius_ratio = radius_ratio(a, b, c, d);
  // Over the largest face stands the smallest height.
  shape.height = largest > 0 ? 6 * tet_volume(a, b, c, d) / largest : 0;
  shape.centroid = 0.25 * (a + b + c + d);
  return shape;
}

void ShapeStatistics::add(const TetShape& shape) {
  for (const std::uint8_t bin : shape.dihedral_bins) ++dihedral_histogram[bin];
  max_dihedral_deg = std::max(max_dihedral_deg, shape.max_dihedral_deg);
  if (shape.min_dihedral_deg < min_dihedral_deg) {
    min_dihedral_deg = shape.min_dihedral_deg;
    worst_centroid = shape.centroid;
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
