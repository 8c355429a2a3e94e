/// The inertia of a sub-domain's work, and the directions in which the sub-domain is long.
///
/// Source: thesis 4.3.1.4, eq. 17; C. Farhat and M. Lesoinne (1993). Here each point counts by its
/// work. The thesis writes the products of inertia with a plus; eq. 17 needs a minus, and has it
/// here.
#pragma once

#include <array>

#include "mesh/core/vec3.h"
#include "mesh/decompose/work_estimate.h"

namespace tetfarm {

/// Symmetric: row i is rows[i].
struct InertiaMatrix {
  std::array<Vec3, 3> rows;
};

InertiaMatrix inertia_matrix(const WorkSamples& work);

/// The unit eigenvectors, the direction of the smallest moment (in which the sub-domain is longest)
/// first; the largest component of each is positive. Jacobi rotations: + - * / sqrt only.
std::array<Vec3, 3> principal_axes(const InertiaMatrix& inertia);

}  // namespace tetfarm
