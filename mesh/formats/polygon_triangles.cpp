#include "mesh/formats/polygon_triangles.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_corners_looked_at = std::size_t{1} << 26;

struct PolygonCorner {
  std::int32_t vertex = 0;
  Vec2 p;
};

/// Twice the area as a vector. Taken from the first corner, so that far-off coordinates cancel.
Vec3 area_of_polygon(const SurfaceMesh& surface, std::span<const std::int32_t> corners) {
  const auto place = [&](std::size_t i) { return surface.vertices[at(corners[i])]; };
  Vec3 area;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area = area + cross(place(i - 1) - place(0), place(i) - place(0));
  }
  return area;
}

/// The corners in the plane, anticlockwise; empty where there is no area.
std::vector<PolygonCorner> seen_along_axis(const SurfaceMesh& surface,
                                           std::span<const std::int32_t> corners) {
  const Vec3 area = area_of_polygon(surface, corners);
  int axis = 0;
  for (const int other : {1, 2}) {
    if (std::abs(area[other]) > std::abs(area[axis])) axis = other;
  }
  std::vector<PolygonCorner> seen;
  if (area[axis] == 0 || !std::isfinite(area[axis])) return seen;
  for (const std::int32_t v : corners) {
    const Vec3& p = surface.vertices[at(v)];
    Vec2 q{p[(axis + 1) % 3], p[(axis + 2) % 3]};
    if (area[axis] < 0) std::swap(q.x, q.y);
    seen.push_back({v, q});
  }
  return seen;
}

bool is_fan(const std::vector<PolygonCorner>& seen) {
  for (std::size_t i = 2; i < seen.size(); ++i) {
    if (orient2d(seen[0].p, seen[i - 1].p, seen[i].p) <= 0) return false;
  }
  return !seen.empty();
}

class EarClipping {
 public:
  EarClipping(SurfaceMesh& surface, std::vector<PolygonCorner> left)
      : surface_(surface), left_(std::move(left)) {}

  /// What is left has at least 3 corners, and no ears or just 3.
  std::vector<PolygonCorner> clip() {
    std::size_t at_corner = 0;
    std::size_t without_ear = 0;
    while (left_.size() > 3 && without_ear < left_.size() && looked_at_ < most_corners_looked_at) {
      at_corner %= left_.size();
      if (!is_ear(at_corner)) {
        ++without_ear;
        ++at_corner;
        continue;
      }
      const std::size_t n = left_.size();
      surface_.triangles.push_back({left_[(at_corner + n - 1) % n].vertex, left_[at_corner].vertex,
                                    left_[(at_corner + 1) % n].vertex});
      // The next corner is passed over, so that ears do not all meet in one corner.
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at_corner));
      ++at_corner;
      without_ear = 0;
    }
    return std::move(left_);
  }

 private:
  bool is_ear(std::size_t i) {
    const std::size_t n = left_.size();
    const Vec2& a = left_[(i + n - 1) % n].p;
    const Vec2& b = left_[i].p;
    const Vec2& c = left_[(i + 1) % n].p;
    ++looked_at_;
    if (orient2d(a, b, c) <= 0) return false;
    for (const PolygonCorner& other : left_) {
      ++looked_at_;
      const Vec2& p = other.p;
      if (p == a || p == b || p == c) continue;
      if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return false;
    }
    return true;
  }

  SurfaceMesh& surface_;
  std::vector<PolygonCorner> left_;
  std::size_t looked_at_ = 0;
};

}  // namespace

std::size_t add_polygon(SurfaceMesh& surface, std::span<const std::int32_t> corners) {
  TF_CHECK(corners.size() >= 3);
  const std::size_t before = surface.triangles.size();
  std::vector<std::int32_t> rest(corners.begin(), corners.end());
  if (corners.size() > 3) {
    const std::vector<PolygonCorner> seen = seen_along_axis(surface, corners);
    if (!seen.empty() && !is_fan(seen)) {
      rest.clear();
      for (const PolygonCorner& corner : EarClipping(surface, seen).clip()) {
        rest.push_back(corner.vertex);
      }
    }
  }
  for (std::size_t i = 2; i < rest.size(); ++i) {
    surface.triangles.push_back({rest[0], rest[i - 1], rest[i]});
  }
  TF_CHECK(surface.triangles.size() == before + corners.size() - 2);
  return corners.size() - 2;
}

}  // namespace tetfarm
