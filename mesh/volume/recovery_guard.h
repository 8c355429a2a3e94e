/// What a search for flips may not put back in the way: faces and edges that cross the missing
/// edge, or edges that cross the missing face.
///
/// Source: H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator" (2015), section 3:
/// each flip kept must leave fewer crossings. Cost: a few exact signs a question.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mesh/core/surface_mesh.h"
#include "mesh/volume/local_remeshing.h"

namespace tetfarm {

class RecoveryGuard {
 public:
  /// Keep a reference.
  static RecoveryGuard of_edge(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b);
  static RecoveryGuard of_face(const LocalRemeshing& mesh, const Triangle& face);
  /// Forbids nothing.
  static RecoveryGuard of_nothing(const LocalRemeshing& mesh) { return RecoveryGuard(mesh); }

  /// Whether a new edge uv would cross what is to be recovered.
  bool forbids_edge(std::int32_t u, std::int32_t v) const;
  /// Whether a new face uvw would.
  bool forbids_face(std::int32_t u, std::int32_t v, std::int32_t w) const;

 private:
  explicit RecoveryGuard(const LocalRemeshing& mesh) : mesh_(mesh) {}

  const LocalRemeshing& mesh_;
  std::optional<std::array<std::int32_t, 2>> edge_;
  std::optional<Triangle> face_;
};

/// Whether the segments ab and cd lie in one plane and cross between their ends. Exact.
bool segments_cross(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b, std::int32_t c,
                    std::int32_t d);

/// Whether pq, strictly between p and q, goes through the triangle's plane at a point inside the
/// triangle or inside one of its edges. Exact.
bool segment_crosses_triangle(const LocalRemeshing& mesh, std::int32_t p, std::int32_t q,
                              const Triangle& triangle);

}  // namespace tetfarm
