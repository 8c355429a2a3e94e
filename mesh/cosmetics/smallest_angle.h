/// The smallest dihedral angle of many tets whose quality is known, for a report.
#pragma once

#include <cmath>
#include <numbers>

#include "mesh/core/tet_complex.h"
#include "mesh/core/tet_quality.h"

namespace tetfarm::cosmetics {

/// The smallest dihedral angle of the tets that are added. Most cost a comparison only.
class SmallestAngle {
 public:
  void add(const TetComplex& complex, const Tet& tet, double its_quality) {
    // A tet with a smaller angle than the smallest so far cannot have a larger quality.
    if (its_quality > quality_) return;
    const auto point = [&](std::size_t i) {
      return complex.points[static_cast<std::size_t>(tet[i])];
    };
    const double cosine = dihedral_cosines(point(0), point(1), point(2), point(3)).of_smallest;
    if (cosine <= cosine_) return;
    cosine_ = cosine;
    quality_ = (1 - cosine) * (1 + cosine) * (1 + 1e-6) + 1e-12;
  }
  double degrees() const { return std::acos(cosine_) * 180 / std::numbers::pi; }

 private:
  double cosine_ = -1;
  double quality_ = HUGE_VAL;
};

}  // namespace tetfarm::cosmetics
