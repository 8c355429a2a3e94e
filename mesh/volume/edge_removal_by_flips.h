/// Removes an edge by flips, for boundary recovery: any valid tets will do, quality comes later.
///
/// An edge goes when the ring round it can be triangulated so that both ends see every triangle
/// (the n-to-m flip). When it cannot, edges between its ends and the ring are removed first, each
/// of which makes the ring shorter, to a given depth; what leads nowhere is taken back. Source: H.
/// Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator" (2015), section 3.3; the ring
/// as a whole: J. R. Shewchuk, "Two discrete optimization algorithms" (2002). Cost: O(n^3) signs
/// for a ring of n; exponential in the depth, bounded by a budget.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/volume/local_remeshing.h"
#include "mesh/volume/recovery_guard.h"
#include "mesh/volume/recovery_surface.h"

namespace tetfarm {

class EdgeRemoval {
 public:
  /// Keeps references. Edges of the surface and constrained faces are never removed.
  EdgeRemoval(LocalRemeshing& mesh, const RecoverySurface& surface)
      : mesh_(mesh), surface_(surface) {}

  /// Rings that may still be tried before remove gives up; counts down.
  void set_budget(std::int64_t rings) { budget_ = rings; }

  /// Removes the edge ab with nothing new that the guard forbids. False: nothing has changed.
  bool remove(std::int32_t a, std::int32_t b, const RecoveryGuard& guard, int depth);

  /// The 2-3 flip of a face; false when it is constrained, not convex with both apexes, or the
  /// guard forbids the new edge or faces.
  bool remove_face(FaceHandle face, const RecoveryGuard& guard);

 private:
  /// `ear`: when >= 0, this apex of the ring must end up in one triangle with its two neighbours.
  bool remove(std::int32_t a, std::int32_t b, std::int32_t ear, const RecoveryGuard& guard,
              int depth);
  bool flip_ring(const EdgeRing& ring, std::int32_t a, std::int32_t b, std::int32_t ear,
                 const RecoveryGuard& guard);
  bool has_constrained_face(const EdgeRing& ring, std::int32_t a, std::int32_t b) const;
  bool shorten_ring(const EdgeRing& ring, std::int32_t a, std::int32_t b,
                    const RecoveryGuard& guard, int depth);

  LocalRemeshing& mesh_;
  const RecoverySurface& surface_;
  std::int64_t budget_ = 0;
};

}  // namespace tetfarm
