/// From where a mesh is looked at, and where its points come to lie in the picture.
#pragma once

#include <optional>
#include <span>

#include "mesh/core/vec3.h"

namespace tetfarm {

struct CameraOptions {
  Vec3 from{-1, -2, 1};  ///< the direction from what is seen to the eye
  Vec3 up{0, 0, 1};
  double zoom = 1;
  std::optional<double> across;  ///< instead of zoom: what the picture is wide at the centre
  std::optional<Vec3> centre;    ///< of the picture; nothing: that of what is seen
};

/// The directions of the picture in space, each of length 1.
struct ViewAxes {
  Vec3 ahead;
  Vec3 right;
  Vec3 up;
};

ViewAxes view_axes(const CameraOptions& options);

/// A point of the picture: pixels from the left and from the top, and the distance from the eye
/// along the line of sight.
struct Seen {
  double x = 0;
  double y = 0;
  double depth = 0;
};

/// A perspective that stays outside of what there is: nothing lies behind the eye.
class Camera {
 public:
  /// `all` has to lie before the eye; the points of `focus` fill a picture of width x height pixels
  /// at zoom 1. @pre neither is empty.
  Camera(const Box3& all, std::span<const Vec3> focus, const CameraOptions& options, int width,
         int height);

  Seen project(const Vec3& p) const {
    const Vec3 q = p - eye_;
    const double depth = dot(q, axes_.ahead);
    const double scale = pixels_per_slope_ / depth;
    return {middle_x_ + scale * dot(q, axes_.right), middle_y_ - scale * dot(q, axes_.up), depth};
  }
  const Vec3& eye() const { return eye_; }
  const ViewAxes& axes() const { return axes_; }

 private:
  ViewAxes axes_;
  Vec3 eye_;
  double pixels_per_slope_ = 1;
  double middle_x_ = 0;
  double middle_y_ = 0;
};

}  // namespace tetfarm
