/// The quality of a tet, the one number that all cosmetics improve.
///
/// Source: the thesis (4.3.4.1) names no measure. This is the smallest sine of the six dihedral
/// angles, squared: small and large angles count alike, the gradient is smooth, and + − × ÷
/// suffice. J. R. Shewchuk, "What is a good linear finite element?" (2002) compares such measures.
/// Units: none; 8/9 for the regular tet, 0 for a flat one, negative for an inverted one.
/// Edges must be between 1e-18 and 1e18 long, or the quality comes out as 0.
#pragma once

#include <algorithm>
#include <array>

#include "mesh/core/tet_complex.h"

namespace tetfarm::cosmetics {

/// Cost: about 110 flops.
double quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
double quality(const TetComplex& complex, const Tet& tet);

/// The smaller quality of the two tets over a triangle, (a, b, c, above) and (a, c, b, below),
/// but for rounding. Cost: little more than one of them.
double quality_of_two(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& above,
                      const Vec3& below);

/// The smaller quality of the tets from two triangles to one node, to the last bit that of
/// quality(). Cost: as quality_of_two.
double quality_over_two(const std::array<Vec3, 3>& face, const std::array<Vec3, 3>& other,
                        const Vec3& d);

/// Quality of a tet whose worst angle is `degrees` (0 to 90), without libm.
double quality_of_angle(double degrees);

/// A worst of `before` is worth replacing by one above this only. The gain makes every sequence of
/// accepted changes end.
inline constexpr double usual_gain = 1.03;
inline double least_worth(double before, double gain = usual_gain) {
  return std::max(0.0, gain * before + 1e-9);
}
inline bool is_worth(double before, double after, double gain = usual_gain) {
  return after > least_worth(before, gain);
}

/// True when the volume of the tet is exactly positive.
bool is_positive(const TetComplex& complex, const Tet& tet);

}  // namespace tetfarm::cosmetics
