/// The in-sphere test in plain doubles, for the inner loop of the Delaunay kernel: its sign, when a
/// bound from the lengths alone proves it.
///
/// Source: error of the determinant as in J. R. Shewchuk (1997), at most 16 eps times its
/// permanent. The bound on the permanent is ours: perm(p, q, r) <= sqrt(2) |p| |q| |r| for three
/// rows (Cauchy–Schwarz twice), and the four products of a squared length with such a permanent
/// sum up to at most sqrt(2) / 8 · M^(5/2), M the sum of the four squared lengths (greatest when
/// all are equal). No absolute values, no maxima, no root. The rows are worked on two by two
/// (SSE2), which changes no result that is certain. Cost: some 60 instructions.
#pragma once

#include <cstring>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// det has the sign of insphere(a, b, c, d, e) when is_certain.
struct FilteredSphere {
  double det;
  bool is_certain;
};

namespace sphere_filter {

/// Two doubles of one register: of the rows a and b, or of c and d.
using Pair [[gnu::vector_size(16)]] = double;

[[gnu::always_inline]] inline Pair pair_of(const double* first) {
  Pair pair;
  std::memcpy(&pair, first, sizeof(pair));
  return pair;
}
/// The second of p and the first of q: one step on in a, b, c, d, a…
[[gnu::always_inline]] inline Pair step(Pair p, Pair q) {
  return __builtin_shufflevector(p, q, 1, 2);
}

}  // namespace sphere_filter

[[gnu::always_inline]] inline FilteredSphere filtered_insphere(const Vec3& a, const Vec3& b,
                                                               const Vec3& c, const Vec3& d,
                                                               const Vec3& e) {
  using sphere_filter::Pair;
  using sphere_filter::pair_of;
  using sphere_filter::step;
  const Pair exy = pair_of(&e.x);
  const Pair axy = pair_of(&a.x) - exy;
  const Pair bxy = pair_of(&b.x) - exy;
  const Pair cxy = pair_of(&c.x) - exy;
  const Pair dxy = pair_of(&d.x) - exy;
  const Pair x_ab = __builtin_shufflevector(axy, bxy, 0, 2);
  const Pair x_cd = __builtin_shufflevector(cxy, dxy, 0, 2);
  const Pair y_ab = __builtin_shufflevector(axy, bxy, 1, 3);
  const Pair y_cd = __builtin_shufflevector(cxy, dxy, 1, 3);
  const Pair z_ab = Pair{a.z, b.z} - e.z;
  const Pair z_cd = Pair{c.z, d.z} - e.z;
  const Pair lift_ab = x_ab * x_ab + y_ab * y_ab + z_ab * z_ab;
  const Pair lift_cd = x_cd * x_cd + y_cd * y_cd + z_cd * z_cd;
  // Minors of x and y: of (ab, bc), of (cd, da), of (ac, bd).
  const Pair x_bc = step(x_ab, x_cd);
  const Pair y_bc = step(y_ab, y_cd);
  const Pair x_da = step(x_cd, x_ab);
  const Pair y_da = step(y_cd, y_ab);
  const Pair ab_bc = x_ab * y_bc - x_bc * y_ab;
  const Pair cd_da = x_cd * y_da - x_da * y_cd;
  const Pair ac_bd = x_ab * y_cd - x_cd * y_ab;
  // Minors of x, y and z: of (abc, bcd), of (cda, dab).
  const Pair z_bc = step(z_ab, z_cd);
  const Pair z_da = step(z_cd, z_ab);
  const Pair abc_bcd = z_ab * step(ab_bc, cd_da) - z_bc * ac_bd + z_cd * ab_bc;
  const Pair cda_dab = z_cd * step(cd_da, ab_bc) + z_da * ac_bd + z_ab * cd_da;
  const Pair sum = lift_ab * step(abc_bcd, cda_dab) + lift_cd * step(cda_dab, abc_bcd);
  const double det = sum[0] - sum[1];
  const Pair lifts = lift_ab + lift_cd;
  const double m = lifts[0] + lifts[1];
  // (16 eps sqrt(2) / 8)^2 and some for the rounding of the bound itself; the constant keeps
  // underflow from deciding anything.
  constexpr double share = 9.87e-32;
  return {det, det * det > share * (m * m * m * m * m) + 1e-280};
}

}  // namespace tetfarm
