/// Divides segments of one plane where they meet.
///
/// Source: all pairs whose boxes overlap, swept along one coordinate; exact.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/arrangement/exact_points.h"

namespace tetfarm {

/// Numbers of points; twice the same is a point alone.
using Segment = std::array<std::int32_t, 2>;

/// The pieces, the smaller number first, sorted, each once; they have no point in common but their
/// ends. Points alone divide what they lie on, and are not among the pieces. New points are added.
/// `pairs_left` goes down by the pairs that are looked at; nothing where it is used up.
/// @pre all lie in one plane, which is not seen edge-on along `axis`. Cost: O(n log n + pairs).
std::optional<std::vector<Segment>> divide_segments(ExactPoints& points,
                                                    const std::vector<Segment>& segments, int axis,
                                                    std::int64_t& pairs_left);

}  // namespace tetfarm
