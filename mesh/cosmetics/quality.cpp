#include "mesh/cosmetics/quality.h"

#include <algorithm>
#include <cmath>

#include "mesh/geometry/predicates.h"

namespace tetfarm::cosmetics {

namespace {

/// Two numbers, on which processors work at once; the same bits on every machine.
using Two = double __attribute__((vector_size(16)));

Two min(Two a, Two b) { return b < a ? b : a; }

struct TwoVectors {
  Two x;
  Two y;
  Two z;

  TwoVectors(Two x_, Two y_, Two z_) : x(x_), y(y_), z(z_) {}
  TwoVectors(const Vec3& a, const Vec3& b) : x{a.x, b.x}, y{a.y, b.y}, z{a.z, b.z} {}
  explicit TwoVectors(const Vec3& both) : TwoVectors(both, both) {}
};
TwoVectors operator-(const TwoVectors& a, const TwoVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TwoVectors operator+(const TwoVectors& a, const TwoVectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Two dot(const TwoVectors& a, const TwoVectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Two norm2(const TwoVectors& a) { return dot(a, a); }
TwoVectors cross(const TwoVectors& a, const TwoVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The steps of quality(), on two tets at a time; `turn`: -1, or 1 for one that is mirrored.
double smaller_quality(const TwoVectors& a, const TwoVectors& b, const TwoVectors& c,
                       const TwoVectors& d, Two turn) {
  const TwoVectors ab = b - a;
  const TwoVectors ac = c - a;
  const TwoVectors ad = d - a;
  const TwoVectors normal_b = cross(ad, ac);
  const TwoVectors normal_c = cross(ab, ad);
  const TwoVectors normal_d = cross(ac, ab);
  const Two volume6 = dot(normal_d, ad) * turn;
  const Two area_a = norm2(normal_b + normal_c + normal_d);
  const Two area_b = norm2(normal_b);
  const Two area_c = norm2(normal_c);
  const Two area_d = norm2(normal_d);
  const Two at_a = min(min(norm2(ab) * area_a * area_b, norm2(ac) * area_a * area_c),
                       norm2(ad) * area_a * area_d);
  const Two opposite = min(min(norm2(c - b) * area_b * area_c, norm2(d - b) * area_b * area_d),
                           norm2(d - c) * area_c * area_d);
  const Two least = min(at_a, opposite);
  const Two product = area_a * area_b * area_c * area_d;
  double worst = 1;
  for (int i = 0; i < 2; ++i) {
    const bool is_sound = product[i] > 0 && std::isfinite(product[i]);
    const double here = is_sound ? volume6[i] * std::fabs(volume6[i]) * least[i] / product[i] : 0;
    worst = std::min(worst, here);
  }
  return worst;
}

}  // namespace

double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
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

double quality_of_two(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& above,
                      const Vec3& below) {
  // The tet below is mirrored.
  return smaller_quality(TwoVectors(a), TwoVectors(b), TwoVectors(c), TwoVectors(above, below),
                         Two{-1, 1});
}

double quality_over_two(const std::array<Vec3, 3>& face, const std::array<Vec3, 3>& other,
                        const Vec3& d) {
  return smaller_quality(TwoVectors(face[0], other[0]), TwoVectors(face[1], other[1]),
                         TwoVectors(face[2], other[2]), TwoVectors(d), Two{-1, -1});
}

double quality(const TetComplex& complex, const Tet& tet) {
  const auto point = [&](std::size_t i) -> const Vec3& {
    return complex.points[static_cast<std::size_t>(tet[i])];
  };
  return quality(point(0), point(1), point(2), point(3));
}

double quality_of_angle(double degrees) {
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
