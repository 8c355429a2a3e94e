/// The Delaunay tetrahedra of a set of points.
///
/// Source: thesis 3.2 and 4.3.1.9 (Bowyer–Watson); exact predicates, cospherical points perturbed
/// by number, so that lattices and planar cuts are no special case. Cost: O(n log n) in practice.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/work_progress.h"
#include "mesh/core/tet_complex.h"

namespace tetfarm {

/// `complex.points` are the given points, then four far ones that enclose them all: every given
/// point is inside the complex. `duplicates` are pairs (point not inserted, point with the same
/// coordinates).
struct DelaunayTets {
  TetComplex complex;
  std::vector<std::array<std::int32_t, 2>> duplicates;
};

/// Counts the points on `progress`, in the stage that it is in. @pre coordinates are finite.
DelaunayTets bowyer_watson(std::span<const Vec3> points, const WorkProgress& progress = {});

}  // namespace tetfarm
