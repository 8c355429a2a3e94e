#include "mesh/remeshing/input_shape.h"

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/remeshing/nearest_point.h"

namespace tetfarm {
namespace {

/// A triangle lower than this share of its longest edge has no sure normal.
constexpr double least_height_share = 1e-5;
/// Off a plane by less than this share of the size of the whole is rounding, also of files with
/// single precision.
constexpr double plane_share = 1e-7;

using Corners = std::array<Vec3, 3>;

Corners corners_of(const SurfaceMesh& surface, std::int32_t triangle) {
  const Triangle& t = surface.triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&surface](std::int32_t v) {
    return surface.vertices[static_cast<std::size_t>(v)];
  };
  return {at(t[0]), at(t[1]), at(t[2])};
}

Vec3 sure_normal(const Corners& c) {
  const Vec3 doubled = cross(c[1] - c[0], c[2] - c[0]);
  const double longest2 = std::max({norm2(c[1] - c[0]), norm2(c[2] - c[1]), norm2(c[0] - c[2])});
  if (norm2(doubled) < least_height_share * least_height_share * longest2 * longest2) return {};
  return normalized(doubled);
}

/// The normal of each face's largest triangle where all of it lies in that triangle's plane.
std::vector<std::optional<Vec3>> planes_of(const SurfaceMesh& surface,
                                           const SurfaceFeatures& features, double tolerance) {
  struct Largest {
    double area2 = 0;
    Vec3 normal;
    Vec3 at;
  };
  std::vector<Largest> largest(static_cast<std::size_t>(features.face_count));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Corners c = corners_of(surface, static_cast<std::int32_t>(t));
    const Vec3 doubled = cross(c[1] - c[0], c[2] - c[0]);
    Largest& of = largest[static_cast<std::size_t>(features.face[t])];
    if (norm2(doubled) > of.area2) of = {norm2(doubled), normalized(doubled), c[0]};
  }
  std::vector<char> is_plane(largest.size(), 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto face = static_cast<std::size_t>(features.face[t]);
    const Largest& of = largest[face];
    for (const Vec3& p : corners_of(surface, static_cast<std::int32_t>(t))) {
      if (std::abs(dot(p - of.at, of.normal)) > tolerance) is_plane[face] = 0;
    }
  }
  std::vector<std::optional<Vec3>> planes(largest.size());
  for (std::size_t f = 0; f < largest.size(); ++f) {
    if (is_plane[f] != 0) planes[f] = largest[f].normal;
  }
  return planes;
}

std::vector<Box3> edge_boxes(const SurfaceMesh& surface, const SurfaceFeatures& features) {
  std::vector<Box3> boxes;
  boxes.reserve(features.edges.size());
  for (const std::array<std::int32_t, 2>& edge : features.edges) {
    Box3 box;
    for (const std::int32_t v : edge) box.add(surface.vertices[static_cast<std::size_t>(v)]);
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

InputShape::InputShape(const SurfaceMesh& surface, const SurfaceFeatures& features)
    : surface_(surface), features_(features), curves_(feature_curves(features)) {
  normals_.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    normals_.push_back(sure_normal(corners_of(surface, static_cast<std::int32_t>(t))));
  }
  const double size = norm(bounding_box(surface.vertices).size());
  planes_ = planes_of(surface, features, plane_share * size);
  triangles_ = BoxForest(triangle_boxes(surface.vertices, surface.triangles), features.face,
                         features.face_count);
  const std::vector<Box3> boxes = edge_boxes(surface, features);
  edges_ = BoxForest(boxes, curves_.curve_of_edge, curves_.count);
  all_edges_ = BoxForest(boxes, std::vector<std::int32_t>(boxes.size(), 0), 1);
}

std::optional<InputFoot> InputShape::on_face(std::int32_t face, const Vec3& p, const Vec3& normal,
                                             double limit, std::int32_t guess) const {
  const auto distance2 = [&](std::int32_t t) {
    if (dot(normals_[static_cast<std::size_t>(t)], normal) < 0) {
      return std::numeric_limits<double>::infinity();
    }
    const Corners c = corners_of(surface_, t);
    return distance2_to_triangle(p, c[0], c[1], c[2]);
  };
  BoxForest::Nearest first{-1, limit * limit};
  if (guess >= 0 && features_.face[static_cast<std::size_t>(guess)] == face) {
    const double d2 = distance2(guess);
    if (d2 < first.distance2) first = {guess, d2};
  }
  BoxForest::Nearest found = triangles_.nearest(face, p, first.distance2, distance2);
  if (found.item < 0) found = first;
  if (found.item < 0) return std::nullopt;
  const Corners c = corners_of(surface_, found.item);
  return InputFoot{nearest_on_triangle(p, c[0], c[1], c[2]), found.item, found.distance2};
}

std::optional<InputFoot> InputShape::on_curve(std::int32_t curve, const Vec3& p, double limit,
                                              std::int32_t guess) const {
  const auto foot = [&](std::int32_t e) {
    const std::array<std::int32_t, 2>& edge = features_.edges[static_cast<std::size_t>(e)];
    return nearest_on_segment(p, surface_.vertices[static_cast<std::size_t>(edge[0])],
                              surface_.vertices[static_cast<std::size_t>(edge[1])]);
  };
  const auto distance2 = [&](std::int32_t e) { return norm2(foot(e) - p); };
  BoxForest::Nearest first{-1, limit * limit};
  if (guess >= 0 && curves_.curve_of_edge[static_cast<std::size_t>(guess)] == curve) {
    const double d2 = distance2(guess);
    if (d2 < first.distance2) first = {guess, d2};
  }
  BoxForest::Nearest found = edges_.nearest(curve, p, first.distance2, distance2);
  if (found.item < 0) found = first;
  if (found.item < 0) return std::nullopt;
  return InputFoot{foot(found.item), found.item, found.distance2};
}

std::optional<InputFoot> InputShape::on_any_curve(const Vec3& p, double limit) const {
  const auto foot = [&](std::int32_t e) {
    const std::array<std::int32_t, 2>& edge = features_.edges[static_cast<std::size_t>(e)];
    return nearest_on_segment(p, surface_.vertices[static_cast<std::size_t>(edge[0])],
                              surface_.vertices[static_cast<std::size_t>(edge[1])]);
  };
  const BoxForest::Nearest found =
      all_edges_.nearest(0, p, limit * limit, [&](std::int32_t e) { return norm2(foot(e) - p); });
  if (found.item < 0) return std::nullopt;
  return InputFoot{foot(found.item), found.item, found.distance2};
}

}  // namespace tetfarm
