#include "mesh/remeshing/input_shape.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/nearest_point.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// A triangle lower than this share of its longest edge has no sure normal.
constexpr double least_height_share = 1e-5;
/// Off a plane by less than this share of the size of the whole is rounding, also of files with
/// single precision.
constexpr double plane_share = 1e-7;
/// Rounding does not make a distance so many times as large.
constexpr double sure_factor = 1 + 1e-6;

TrianglePoints corners_of(const SurfaceMesh& surface, std::size_t triangle) {
  return triangle_points(surface.vertices, surface.triangles[triangle]);
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
    const TrianglePoints c = corners_of(surface, t);
    const Vec3 doubled = doubled_area(c);
    Largest& of = largest[static_cast<std::size_t>(features.face[t])];
    if (norm2(doubled) > of.area2) of = {norm2(doubled), normalized(doubled), c[0]};
  }
  std::vector<char> is_plane(largest.size(), 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto face = static_cast<std::size_t>(features.face[t]);
    const Largest& of = largest[face];
    for (const Vec3& p : corners_of(surface, t)) {
      if (std::abs(dot(p - of.at, of.normal)) > tolerance) is_plane[face] = 0;
    }
  }
  std::vector<std::optional<Vec3>> planes(largest.size());
  for (std::size_t f = 0; f < largest.size(); ++f) {
    if (is_plane[f] != 0) planes[f] = largest[f].normal;
  }
  return planes;
}

std::vector<double> shares_of_edges(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                    const std::vector<double>& shares) {
  std::vector<double> of_edges(features.edges.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& nodes = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = nodes[k];
      const std::int32_t b = nodes[(k + 1) % 3];
      const std::array<std::int32_t, 2> edge{std::min(a, b), std::max(a, b)};
      const auto found = std::ranges::lower_bound(features.edges, edge);
      if (found == features.edges.end() || *found != edge) continue;
      double& share = of_edges[static_cast<std::size_t>(found - features.edges.begin())];
      share = std::max(share, shares[t]);
    }
  }
  return of_edges;
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

/// The nearest item of the group, unless that is the guess, which is looked at first; -1: none.
template <typename Distance2>
BoxForest::Nearest nearest_after(std::int32_t guess, const BoxForest& forest, std::int32_t group,
                                 const Vec3& p, double limit, const Distance2& distance2) {
  BoxForest::Nearest first{-1, limit * limit};
  if (guess >= 0) {
    const double d2 = distance2(guess);
    if (d2 < first.distance2) first = {guess, d2};
  }
  const BoxForest::Nearest found = forest.nearest(group, p, first.distance2, distance2);
  return found.item < 0 ? first : found;
}

}  // namespace

InputShape::InputShape(const SurfaceMesh& surface, const SurfaceFeatures& features,
                       std::vector<double> shares)
    : surface_(surface),
      features_(features),
      curves_(feature_curves(features)),
      shares_(std::move(shares)),
      edge_shares_(shares_of_edges(surface, features, shares_)) {
  normals_.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    normals_.push_back(sure_normal(corners_of(surface, t), least_height_share));
  }
  cones_ = NormalCones(surface, normals_);
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
    const auto triangle = static_cast<std::size_t>(t);
    if (dot(normals_[triangle], normal) < 0) return std::numeric_limits<double>::infinity();
    const TrianglePoints c = corners_of(surface_, triangle);
    return distance2_to_triangle(p, c[0], c[1], c[2]);
  };
  const bool is_of_face = guess >= 0 && features_.face[static_cast<std::size_t>(guess)] == face;
  const BoxForest::Nearest found =
      nearest_after(is_of_face ? guess : -1, triangles_, face, p, limit, distance2);
  if (found.item < 0) return std::nullopt;
  const TrianglePoints c = corners_of(surface_, static_cast<std::size_t>(found.item));
  return InputFoot{nearest_on_triangle(p, c[0], c[1], c[2]), found.item, found.distance2};
}

std::int32_t InputShape::near_on_face(std::int32_t face, const Vec3& p, const Vec3& normal,
                                      double least_cosine, double limit,
                                      std::span<const std::int32_t> guesses) const {
  const auto distance2 = [&](std::int32_t t) {
    const Vec3& of = normals_[static_cast<std::size_t>(t)];
    if (dot(of, normal) < least_cosine && norm2(of) > 0) {
      return std::numeric_limits<double>::infinity();
    }
    const TrianglePoints c = corners_of(surface_, static_cast<std::size_t>(t));
    const double own_limit = share_at(t) * limit;
    // Most that are too far away are told by their plane.
    if (std::abs(dot(of, p - c[0])) > sure_factor * own_limit) {
      return std::numeric_limits<double>::infinity();
    }
    const double d2 = distance2_to_triangle(p, c[0], c[1], c[2]);
    return d2 < own_limit * own_limit ? d2 : std::numeric_limits<double>::infinity();
  };
  const double limit2 = limit * limit;
  for (const std::int32_t guess : guesses) {
    const bool is_of_face = guess >= 0 && features_.face[static_cast<std::size_t>(guess)] == face;
    if (is_of_face && distance2(guess) < limit2) return guess;
  }
  return triangles_.near(face, p, limit2, distance2).item;
}

std::optional<InputFoot> InputShape::on_curve(std::int32_t curve, const Vec3& p, double limit,
                                              std::int32_t guess) const {
  const bool is_of_curve = guess >= 0 && curve_of(guess) == curve;
  return on_edges(edges_, curve, p, limit, is_of_curve ? guess : -1);
}

std::optional<InputFoot> InputShape::on_any_curve(const Vec3& p, double limit) const {
  return on_edges(all_edges_, 0, p, limit, -1);
}

std::optional<InputFoot> InputShape::on_edges(const BoxForest& forest, std::int32_t group,
                                              const Vec3& p, double limit,
                                              std::int32_t guess) const {
  const auto foot = [&](std::int32_t e) {
    const std::array<std::int32_t, 2>& edge = features_.edges[static_cast<std::size_t>(e)];
    return nearest_on_segment(p, surface_.vertices[static_cast<std::size_t>(edge[0])],
                              surface_.vertices[static_cast<std::size_t>(edge[1])]);
  };
  const auto distance2 = [&](std::int32_t e) { return norm2(foot(e) - p); };
  const BoxForest::Nearest found = nearest_after(guess, forest, group, p, limit, distance2);
  if (found.item < 0) return std::nullopt;
  return InputFoot{foot(found.item), found.item, found.distance2};
}

}  // namespace tetfarm
