#include "mesh/render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Half the angle of view at which `focus` is seen when nothing else keeps the eye away.
constexpr double tangent_of_view = 0.25;
/// Of the picture, on each side.
constexpr double margin = 0.04;

std::array<Vec3, 8> corners_of(const Box3& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                  (i & 4) != 0 ? box.high.z : box.low.z};
  }
  return corners;
}

}  // namespace

ViewAxes view_axes(const CameraOptions& options) {
  const Vec3 ahead = -normalized(options.from);
  Vec3 across = cross(ahead, options.up);
  if (!(norm2(across) > 1e-12 * norm2(options.up))) across = cross(ahead, Vec3{0, 1, 0});
  if (!(norm2(across) > 1e-12)) across = cross(ahead, Vec3{1, 0, 0});
  const Vec3 right = normalized(across);
  return {ahead, right, cross(right, ahead)};
}

Camera::Camera(const Box3& all, std::span<const Vec3> focus, const CameraOptions& options,
               int width, int height)
    : axes_(view_axes(options)) {
  TF_CHECK(!focus.empty() && width > 0 && height > 0);
  Box3 box;
  for (const Vec3& p : focus) box.add(p);
  const Vec3 centre = box.centre();
  TF_CHECK(options.zoom > 0 && options.across.value_or(1) > 0);
  const double radius = std::max(0.5 * norm(box.size()), 1e-12 * norm(all.size()));
  double back = radius / tangent_of_view;
  for (const Vec3& corner : corners_of(all)) {
    back = std::max(back, 0.1 * radius + 1.1 * dot(centre - corner, axes_.ahead));
  }
  eye_ = centre - back * axes_.ahead;
  // As seen with one pixel per slope and the middle at 0.
  double low_x = HUGE_VAL;
  double high_x = -HUGE_VAL;
  double low_y = HUGE_VAL;
  double high_y = -HUGE_VAL;
  for (const Vec3& p : focus) {
    const Seen seen = project(p);
    low_x = std::min(low_x, seen.x);
    high_x = std::max(high_x, seen.x);
    low_y = std::min(low_y, seen.y);
    high_y = std::max(high_y, seen.y);
  }
  constexpr double room = 1 - 2 * margin;
  pixels_per_slope_ = options.zoom * std::min(room * width / std::max(high_x - low_x, 1e-12),
                                              room * height / std::max(high_y - low_y, 1e-12));
  if (options.across) {
    const double depth = dot(options.centre.value_or(centre) - eye_, axes_.ahead);
    pixels_per_slope_ = width * depth / *options.across;
  }
  middle_x_ = 0.5 * width - 0.5 * (low_x + high_x) * pixels_per_slope_;
  middle_y_ = 0.5 * height - 0.5 * (low_y + high_y) * pixels_per_slope_;
  if (!options.centre) return;
  const Seen off = project(*options.centre);
  middle_x_ += 0.5 * width - off.x;
  middle_y_ += 0.5 * height - off.y;
}

}  // namespace tetfarm
