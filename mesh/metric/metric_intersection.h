/// Metric intersection: of two metrics the largest ellipse that lies in both, as simultaneous
/// reduction gives it.
///
/// Source: thesis 3.2.3; P. Frey and P.-L. George, "Mesh Generation" (2000), 10.3. Departs: in the
/// symmetric form L⁻¹ B L⁻ᵀ with A = L Lᵀ, in double-doubles, where the usual A⁻¹ B loses ten
/// digits at an aspect of 1e5. Commutative bit by bit; of equal metrics it is the metric itself.
/// Not associative (nor is any form of it): more than two are intersected in the order given.
/// Cost: some 500 flops.
#pragma once

#include <span>

#include "mesh/metric/metric2.h"

namespace tetfarm {

/// At least as dense as both in every direction. @pre is_metric of both
Metric2 intersection(const Metric2& a, const Metric2& b);
/// From the first to the last. @pre not empty
Metric2 intersection(std::span<const Metric2> metrics);

}  // namespace tetfarm
