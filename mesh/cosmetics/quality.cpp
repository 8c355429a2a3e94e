#include "mesh/cosmetics/quality.h"

#include <algorithm>
#include <cmath>

#include "mesh/geometry/predicates.h"

namespace tetfarm::cosmetics {

double goodness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const Vec3 normal_b = cross(ad, ac);
  const Vec3 normal_c = cross(ab, ad);
  const Vec3 normal_d = cross(ac, ab);
  const double volume6 = -dot(normal_d, ad);
  const double area_a = norm2(normal_b + normal_c + normal_d);
  const double area_b = norm2(normal_b);
  const double area_c = norm2(normal_c);
  const double area_d = norm2(normal_d);
  // The angle at edge kl lies between faces i and j, and sin = 6 V |kl| / (|normal i| |normal j|).
  // All six over the product of the four, so that one division will do.
  const double at_a = std::min(std::min(norm2(ab) * area_a * area_b, norm2(ac) * area_a * area_c),
                               norm2(ad) * area_a * area_d);
  const double opposite =
      std::min(std::min(norm2(c - b) * area_b * area_c, norm2(d - b) * area_b * area_d),
               norm2(d - c) * area_c * area_d);
  const double least = std::min(at_a, opposite);
  const double product = area_a * area_b * area_c * area_d;
  if (!(product > 0) || !std::isfinite(product)) return 0;
  return volume6 * std::fabs(volume6) * least / product;
}

double goodness(const TetComplex& complex, const Tet& tet) {
  const auto point = [&](std::size_t i) -> const Vec3& {
    return complex.points[static_cast<std::size_t>(tet[i])];
  };
  return goodness(point(0), point(1), point(2), point(3));
}

double goodness_of_angle(double degrees) {
  const double x = std::clamp(degrees, 0.0, 90.0) * (3.14159265358979323846 / 180.0);
  double term = x;
  double sine = x;
  for (int n = 2; n < 24; n += 2) {
    term *= -x * x / (n * (n + 1));
    sine += term;
  }
  return sine * sine;
}

bool is_positive(const TetComplex& complex, const Tet& tet) {
  const auto point = [&](std::size_t i) -> const Vec3& {
    return complex.points[static_cast<std::size_t>(tet[i])];
  };
  return orient3d(point(0), point(1), point(2), point(3)) > 0;
}

}  // namespace tetfarm::cosmetics
