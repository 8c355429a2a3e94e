/// The order in which points are inserted: near points near each other, so that location is short
/// and caches are warm; in rounds of doubling size, so that no order of the input is a bad one.
///
/// Source: N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO" (2003); J. Skilling,
/// "Programming the Hilbert curve" (2004).
/// Cost: O(n log n).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Position along the Hilbert curve of 2^20 cells on each side of the box; the box is made a cube.
std::uint64_t hilbert_index(const Vec3& point, const Box3& box);

/// The numbers of `points` along the Hilbert curve of their bounding box; ties by number.
std::vector<std::int32_t> hilbert_order(std::span<const Vec3> points);
/// The same of points that are no list: `place` gives each of them, twice.
std::vector<std::int32_t> hilbert_order(std::size_t count,
                                        const std::function<Vec3(std::size_t)>& place);

/// The numbers of `points` in rounds (each about eight times the one before), every round along the
/// Hilbert curve. The round of a point depends on its number alone.
std::vector<std::int32_t> brio_order(std::span<const Vec3> points);

}  // namespace tetfarm
