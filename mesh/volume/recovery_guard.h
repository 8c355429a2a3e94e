/// What a search for flips may not put back in the way: faces and edges that cross the missing
/// edge, or edges that cross the missing face.
///
/// Source: H. Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator" (2015), section 3:
/// each flip kept must leave fewer crossings. Cost: a few exact signs a question.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

class RecoveryGuard {
 public:
  static RecoveryGuard of_edge(std::span<const Vec3> points, std::int32_t a, std::int32_t b);
  static RecoveryGuard of_face(std::span<const Vec3> points, const Triangle& face);

  /// Whether a new edge uv would cross what is to be recovered.
  bool forbids_edge(std::int32_t u, std::int32_t v) const;
  /// Whether a new face uvw would.
  bool forbids_face(std::int32_t u, std::int32_t v, std::int32_t w) const;

 private:
  explicit RecoveryGuard(std::span<const Vec3> points) : points_(points) {}
  const Vec3& at(std::int32_t v) const { return points_[static_cast<std::size_t>(v)]; }

  std::span<const Vec3> points_;
  std::optional<std::array<std::int32_t, 2>> edge_;
  std::optional<Triangle> face_;
};

/// Whether the segments ab and cd lie in one plane and cross between their ends. Exact.
bool segments_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace tetfarm
