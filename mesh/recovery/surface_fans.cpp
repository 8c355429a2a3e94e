#include "mesh/recovery/surface_fans.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// Looks at a boundary triangle's plane from where the triangle turns anticlockwise.
class PlaneView {
 public:
  PlaneView(const LocalRemeshing& mesh, const Triangle& whole) : mesh_(mesh) {
    const FinePoint a = mesh.fine_point(whole[0]), b = mesh.fine_point(whole[1]),
                    c = mesh.fine_point(whole[2]);
    const Vec3 normal = cross(difference(a, b), difference(a, c)).rounded();
    for (int axis = 1; axis < 3; ++axis) {
      if (std::abs(normal[axis]) > std::abs(normal[axis_])) axis_ = axis;
    }
    is_turned_ = orient2d_along(axis_, a, b, c) < 0;
  }

  /// Positive when a, b, c turn anticlockwise; 0 on one line.
  double turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
    if (mesh_.are_in_line(a, b, c)) return 0;
    const double t =
        orient2d_along(axis_, mesh_.fine_point(a), mesh_.fine_point(b), mesh_.fine_point(c));
    return is_turned_ ? -t : t;
  }

 private:
  const LocalRemeshing& mesh_;
  int axis_ = 0;
  bool is_turned_ = false;
};

/// The fan's corners in turn; from one end to the other when the node lies on an edge.
std::vector<std::int32_t> polygon_of(const SurfaceFan& fan) {
  TF_CHECK(!fan.edges.empty());
  const auto starts_an_edge = [&fan](std::int32_t v) {
    return std::find_if(fan.edges.begin(), fan.edges.end(),
                        [v](const auto& edge) { return edge.first == v; });
  };
  const auto ends_an_edge = [&fan](std::int32_t v) {
    return std::any_of(fan.edges.begin(), fan.edges.end(),
                       [v](const auto& edge) { return edge.second == v; });
  };
  std::int32_t first = fan.edges.front().first;
  for (const auto& [from, to] : fan.edges) {
    if (!ends_an_edge(from)) first = from;
  }
  std::vector<std::int32_t> corners = {first};
  for (auto edge = starts_an_edge(first); edge != fan.edges.end();
       edge = starts_an_edge(edge->second)) {
    if (edge->second == first || corners.size() > fan.edges.size()) break;
    corners.push_back(edge->second);
  }
  return corners;
}

bool is_ear(const PlaneView& view, const std::vector<std::int32_t>& corners, std::size_t i) {
  const std::size_t n = corners.size();
  const std::int32_t a = corners[(i + n - 1) % n], b = corners[i], c = corners[(i + 1) % n];
  if (!(view.turn(a, b, c) > 0)) return false;
  return std::none_of(corners.begin(), corners.end(), [&](std::int32_t v) {
    return v != a && v != b && v != c && view.turn(a, b, v) >= 0 && view.turn(b, c, v) >= 0 &&
           view.turn(c, a, v) >= 0;
  });
}

std::optional<std::vector<Triangle>> cut_ears(const PlaneView& view,
                                              std::vector<std::int32_t> corners) {
  std::vector<Triangle> triangles;
  while (corners.size() > 2) {
    const std::size_t n = corners.size();
    std::size_t i = 0;
    while (i < n && !is_ear(view, corners, i)) ++i;
    if (i == n) return std::nullopt;
    triangles.push_back({corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

}  // namespace

std::optional<std::vector<SurfaceFan>> surface_fans(const LocalRemeshing& mesh,
                                                    const SplitSurface& surface,
                                                    const std::vector<Triangle>& triangles,
                                                    std::int32_t node) {
  std::vector<SurfaceFan> fans;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] != node) continue;
      auto fan = std::find_if(fans.begin(), fans.end(),
                              [&](const SurfaceFan& f) { return f.source == surface.source[i]; });
      if (fan == fans.end()) fan = fans.insert(fan, {surface.source[i], {}, {}});
      fan->edges.emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
  }
  for (SurfaceFan& fan : fans) {
    const PlaneView view(mesh, triangles[at(fan.source)]);
    auto without = cut_ears(view, polygon_of(fan));
    if (!without || without->empty()) return std::nullopt;
    fan.without = std::move(*without);
  }
  return fans;
}

}  // namespace tetfarm
