/// Lengths of edges in units of the spacing wanted there, and lists of edges by length.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Over the mean of the spacing at the two ends.
inline double edge_length(const RemeshingWork& work, std::int32_t a, std::int32_t b) {
  return 2 * distance(work.surface.at(a), work.surface.at(b)) /
         (work.surface.vertex(a).spacing + work.surface.vertex(b).spacing);
}

/// Over that, or over the spacing at the middle of the edge, where that is less: for edges longer
/// than the spacing, along which it varies.
double long_edge_length(const RemeshingWork& work, std::int32_t a, std::int32_t b);

struct MeasuredEdge {
  double length = 0;
  std::array<std::int32_t, 2> ends{};  ///< the lower number first
};

/// The edges longer than `limit` (at least 1) near which anything has changed since then (0: all),
/// the longest first; equals by the numbers of their ends. Cost: O(n log n).
std::vector<MeasuredEdge> edges_longer_than(const RemeshingWork& work, double limit,
                                            std::uint64_t then);
/// The edges shorter than `limit`, the shortest first.
std::vector<MeasuredEdge> edges_shorter_than(const RemeshingWork& work, double limit);

}  // namespace tetfarm
