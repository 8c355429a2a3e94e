#include "mesh/core/tet_quality.h"

#include <algorithm>
#include <numbers>

namespace tetfarm {

namespace {

/// Outward normals of the four faces, as long as twice the area of the face.
std::array<Vec3, 4> face_normals(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const Vec3 opposite_b = cross(ad, ac);
  const Vec3 opposite_c = cross(ab, ad);
  const Vec3 opposite_d = cross(ac, ab);
  // The normals of a closed surface add up to zero.
  return {-(opposite_b + opposite_c + opposite_d), opposite_b, opposite_c, opposite_d};
}

double degrees(double cosine) { return std::acos(cosine) * 180.0 / std::numbers::pi; }

}  // namespace

DihedralCosines dihedral_cosines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (!(tet_volume(a, b, c, d) > 0)) return {};
  const std::array<Vec3, 4> normals = face_normals(a, b, c, d);
  std::array<double, 4> lengths;
  for (std::size_t i = 0; i < 4; ++i) lengths[i] = norm(normals[i]);
  DihedralCosines cosines{-1, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double product = lengths[i] * lengths[j];
      if (!(product > 0)) return {};
      const double cosine = std::clamp(-dot(normals[i], normals[j]) / product, -1.0, 1.0);
      cosines.of_smallest = std::max(cosines.of_smallest, cosine);
      cosines.of_largest = std::min(cosines.of_largest, cosine);
    }
  }
  return cosines;
}

bool may_have_smaller_dihedral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                               double cosine) {
  if (!(cosine > 0) || !(tet_volume(a, b, c, d) > 0)) return true;
  const std::array<Vec3, 4> normals = face_normals(a, b, c, d);
  std::array<double, 4> lengths2;
  for (std::size_t i = 0; i < 4; ++i) lengths2[i] = norm2(normals[i]);
  constexpr double rounding = 1e-9;
  const double cosine2 = (1 - rounding) * cosine * cosine;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double product = -dot(normals[i], normals[j]);
      const double most2 = cosine2 * lengths2[i] * lengths2[j];
      if (product > 0 && !(product * product < most2)) return true;
      if (!(most2 > 0)) return true;
    }
  }
  return false;
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const DihedralCosines cosines = dihedral_cosines(a, b, c, d);
  return {degrees(cosines.of_smallest), degrees(cosines.of_largest)};
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d;
  const Vec3 v = b - d;
  const Vec3 w = c - d;
  const double volume6 = 6 * tet_volume(a, b, c, d);
  if (!(volume6 > 0)) return 0;
  double surface = 0;
  for (const Vec3& normal : face_normals(a, b, c, d)) surface += 0.5 * norm(normal);
  // inradius = 3 V / S and circumradius = |centre| / (12 V), with V the volume.
  const Vec3 centre = norm2(u) * cross(v, w) + norm2(v) * cross(w, u) + norm2(w) * cross(u, v);
  const double below = surface * norm(centre);
  return below > 0 ? std::min(1.0, 3 * volume6 * volume6 / below) : 0;
}

}  // namespace tetfarm
