#include "mesh/core/signed_volume.h"

#include <array>

namespace tetfarm {
namespace {

/// More digits than long double has on some machines: differences of doubles are exact, and a
/// flat tet's volume is told from zero where long double cannot.
__extension__ typedef __float128 Quad;

template <typename Real>
std::array<Real, 3> edge(const Vec3& from, const Vec3& to) {
  return {static_cast<Real>(to.x) - static_cast<Real>(from.x),
          static_cast<Real>(to.y) - static_cast<Real>(from.y),
          static_cast<Real>(to.z) - static_cast<Real>(from.z)};
}

template <typename Real>
Real volume_of(const Vec3& from, const Vec3& p, const Vec3& q, const Vec3& r) {
  const auto a = edge<Real>(from, p);
  const auto b = edge<Real>(from, q);
  const auto c = edge<Real>(from, r);
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

}  // namespace

long double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return volume_of<long double>(a, b, c, d);
}

bool has_positive_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return volume_of<long double>(a, b, c, d) > 0 || volume_of<Quad>(a, b, c, d) > 0;
}

}  // namespace tetfarm
