/// Triangulates the ring of an edge so that both ends of the edge see every triangle.
///
/// Source: G. T. Klincsek, "Minimal triangulations of polygonal domains" (1980), for feasibility.
/// Cost: O(n^3) signs for n apexes, each sign once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_guard.h"

namespace tetfarm {

/// Longest ring that is tried.
inline constexpr std::size_t longest_ring = 32;

struct RingTriangulation {
  /// Positions (i, j, k) in ring.apexes, i < j < k but for an ear's.
  std::vector<std::array<std::size_t, 3>> triangles;
  int crossings = 0;  ///< of the new edges and faces with what is to be recovered
};

/// The tets between the triangles and the ends of the edge ab.
std::vector<Tet> tets_of(const RingTriangulation& triangulation, const EdgeRing& ring,
                         std::int32_t a, std::int32_t b);

/// The one with the fewest crossings; nothing when there is none with all tets exactly positive.
/// `ear` >= 0: that apex (a node) must lie in one triangle only.
std::optional<RingTriangulation> ring_triangulation(const LocalRemeshing& mesh,
                                                    const EdgeRing& ring, std::int32_t a,
                                                    std::int32_t b, std::int32_t ear,
                                                    const RecoveryGuard& guard);

}  // namespace tetfarm
