/// Removes an edge by flips, for boundary recovery: any valid tets will do, quality comes later.
///
/// An edge goes when the ring round it can be triangulated so that both ends see every triangle
/// (the n-to-m flip). When it cannot, the ring is made shorter, apex by apex: by a 2-3 flip of the
/// face between the edge and the apex, or, where an end does not see the apex's neighbours, by
/// removing the edge between that end and the apex, in the same way, to a given depth. Only what
/// is hidden is gone into, so that the search is narrow and may be deep: fans of hundreds of
/// needles want chains of twenty. Source: H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh
/// generator" (2015), section 3.3; the ring as a whole: J. R. Shewchuk, "Two discrete optimization
/// algorithms" (2002). Flips are weighed by the crossings that they leave, not forbidden by those
/// that they make. Cost: O(ring) flips and signs a ring; rings are counted, by a budget.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/recovery/local_remeshing.h"
#include "mesh/recovery/recovery_guard.h"
#include "mesh/recovery/recovery_surface.h"

namespace tetfarm {

class EdgeRemoval {
 public:
  /// Keeps references. Edges of the surface and constrained faces are never removed.
  EdgeRemoval(LocalRemeshing& mesh, const RecoverySurface& surface)
      : mesh_(mesh), surface_(surface) {}

  /// Rings that may still be tried before remove gives up; counts down.
  void set_budget(std::int64_t rings) { budget_ = rings; }

  /// Removes the edge ab so that fewer edges and faces are in the way of what the guard is of.
  /// False: the edge is there, and no more is in the way; its ring may be shorter, which stays (of
  /// a guard of nothing, all is as it was). `tet` holds the edge.
  bool remove(std::int32_t tet, std::int32_t a, std::int32_t b, const RecoveryGuard& guard,
              int depth);
  /// The same for an edge that is looked for. Cost: also O(star of a).
  bool remove(std::int32_t a, std::int32_t b, const RecoveryGuard& guard, int depth);

  /// The 2-3 flip of a face; false when it is constrained, not convex with both apexes, or the
  /// new edge or faces would be in the way.
  bool remove_face(FaceHandle face, const RecoveryGuard& guard);

 private:
  struct Target {
    std::int32_t a, b;
    std::int32_t ear;  ///< >= 0: this apex must end up in one triangle with its two neighbours
  };
  bool remove_from_within(std::int32_t tet, const Target& target, const RecoveryGuard& guard,
                          int depth);
  bool is_free(const EdgeRing& ring, const Target& target) const;
  bool work_off(EdgeRing& ring, const Target& target, const RecoveryGuard& guard, int depth);
  bool flip_ring(const EdgeRing& ring, const Target& target, const RecoveryGuard& guard);
  bool clip_apexes(EdgeRing& ring, const Target& target, const RecoveryGuard& guard);
  bool clip_apex(EdgeRing& ring, std::size_t i, const Target& target, const RecoveryGuard& guard);
  bool detach_an_apex(EdgeRing& ring, const Target& target, const RecoveryGuard& guard, int depth);
  bool detach_apex(EdgeRing& ring, std::size_t i, const Target& target, const RecoveryGuard& guard,
                   int depth);
  void drop_apex(EdgeRing& ring, std::size_t i, const Target& target);
  void hold(std::int32_t tet, int by);
  bool is_held(std::int32_t tet) const;

  LocalRemeshing& mesh_;
  const RecoverySurface& surface_;
  std::int64_t budget_ = 0;
  int change_ = 0;                       // in what is in the way, since the outermost ring
  std::vector<std::int32_t> last_tets_;  // that the last flip made
  std::vector<std::int32_t> held_;       // of a tet: the rings being worked off that it is in
};

}  // namespace tetfarm
