/// What is in the way of a missing edge or face: faces and edges that cross the edge, or edges that
/// cross the face. Flips are weighed by it.
///
/// Source: H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator" (2015), section 3,
/// which forbids every flip that makes a crossing; here it may, as long as more of them go. Cost: a
/// few exact signs a question.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mesh/core/surface_mesh.h"
#include "mesh/recovery/local_remeshing.h"

namespace tetfarm {

class RecoveryGuard {
 public:
  /// Keep a reference.
  static RecoveryGuard of_edge(const LocalRemeshing& mesh, std::int32_t a, std::int32_t b);
  static RecoveryGuard of_face(const LocalRemeshing& mesh, const Triangle& face);
  /// Nothing is in the way of nothing.
  static RecoveryGuard of_nothing(const LocalRemeshing& mesh) { return RecoveryGuard(mesh); }

  bool is_of_something() const { return edge_.has_value() || face_.has_value(); }
  /// 1 when the edge uv crosses what is to be recovered, else 0.
  int crossings(std::int32_t u, std::int32_t v) const { return crosses_edge(u, v) ? 1 : 0; }
  /// 1 when the face uvw does, else 0.
  int crossings(std::int32_t u, std::int32_t v, std::int32_t w) const {
    return crosses_face(u, v, w) ? 1 : 0;
  }

 private:
  explicit RecoveryGuard(const LocalRemeshing& mesh) : mesh_(mesh) {}
  bool crosses_edge(std::int32_t u, std::int32_t v) const;
  bool crosses_face(std::int32_t u, std::int32_t v, std::int32_t w) const;

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
