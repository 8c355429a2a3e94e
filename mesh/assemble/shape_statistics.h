/// How well shaped the tets of a mesh are: the figures that `run` and `quality` report.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// The figures of one tet.
struct TetShape {
  std::array<double, 6> dihedral_cosines{};
  std::array<std::uint8_t, 6> dihedral_bins{};  ///< of 10 degrees
  double min_dihedral_deg = 0;
  double max_dihedral_deg = 0;
  double radius_ratio = 0;  ///< 3 inradius / circumradius
  double height = 0;        ///< the smallest of a node over the face opposite
  Vec3 centroid;
};

TetShape tet_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sums are taken in the order of the calls: the same mesh gives the same figures.
struct ShapeStatistics {
  std::int64_t tets = 0;
  double min_dihedral_deg = 180;
  double max_dihedral_deg = 0;
  /// Of all six dihedral angles of each tet, in bins of 10 degrees.
  std::array<std::int64_t, 18> dihedral_histogram{};
  double min_radius_ratio = 1;
  double sum_radius_ratio = 0;
  double smallest_height = 0;  ///< 0 without tets
  /// Of the first tet with the smallest angle.
  Vec3 worst_centroid;

  double mean_radius_ratio() const {
    return tets > 0 ? sum_radius_ratio / static_cast<double>(tets) : 0;
  }
  void add(const TetShape& shape);
  /// Adds tets that come after those that are here.
  void add(const ShapeStatistics& later);
  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    add(tet_shape(a, b, c, d));
  }
};

}  // namespace tetfarm
