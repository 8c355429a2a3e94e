#include "mesh/remeshing/normal_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/check.h"
#include "mesh/geometry/box_measures.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/median_split.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

constexpr std::int32_t most_in_leaf = 4;

/// Whether the triangle may come into the box: by its own box and its plane.
bool may_come_into(const Box3& box, const TrianglePoints& c, const Vec3& normal) {
  Box3 own;
  for (const Vec3& p : c) own.add(p);
  if (!own.overlaps(box)) return false;
  const Vec3 half = 0.5 * box.size();
  const double reach =
      half.x * std::fabs(normal.x) + half.y * std::fabs(normal.y) + half.z * std::fabs(normal.z);
  // The normal is rounded: what is all but touching counts as coming in.
  const double slack = 1e-9 * (norm(own.size()) + norm(half));
  return std::fabs(dot(normal, box.centre() - c[0])) <= reach + slack;
}

}  // namespace

NormalCones::NormalCones(const SurfaceMesh& surface, std::span<const Vec3> normals) {
  TF_CHECK(normals.size() == surface.triangles.size());
  const std::vector<Box3> boxes = triangle_boxes(surface.vertices, surface.triangles);
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  nodes_.reserve(boxes.size());
  if (!boxes.empty()) build(boxes, normals, 0, static_cast<std::int32_t>(boxes.size()));
  nodes_.shrink_to_fit();
}

void NormalCones::set_cone(Node& node, std::span<const Vec3> normals, std::int32_t first,
                           std::int32_t last) const {
  const auto normal_of = [&](std::int32_t k) -> const Vec3& {
    return normals[static_cast<std::size_t>(items_[static_cast<std::size_t>(k)])];
  };
  Vec3 sum;
  for (std::int32_t k = first; k < last; ++k) sum += normal_of(k);
  const Vec3 axis = normalized(sum);
  double cosine = 1;
  for (std::int32_t k = first; k < last; ++k) {
    if (norm2(normal_of(k)) > 0) cosine = std::min(cosine, dot(axis, normal_of(k)));
  }
  if (cosine <= 0) return;
  node.axis = axis;
  node.cosine = cosine;
  node.sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

void NormalCones::build(std::span<const Box3> boxes, std::span<const Vec3> normals,
                        std::int32_t first, std::int32_t last) {
  const auto box_of = [boxes](std::int32_t item) -> const Box3& {
    return boxes[static_cast<std::size_t>(item)];
  };
  const auto here = nodes_.size();
  Node node;
  for (std::int32_t k = first; k < last; ++k)
    node.box.add(box_of(items_[static_cast<std::size_t>(k)]));
  set_cone(node, normals, first, last);
  const bool is_leaf = last - first <= most_in_leaf;
  if (is_leaf) {
    node.first = first;
    node.count = last - first;
  }
  nodes_.push_back(node);
  if (is_leaf) return;
  const std::span items{items_.begin() + first, items_.begin() + last};
  const std::size_t half = split_at_median(items, boxes, longest_axis(node.box));
  const std::int32_t middle = first + static_cast<std::int32_t>(half);
  build(boxes, normals, first, middle);
  nodes_[here].right = static_cast<std::int32_t>(nodes_.size());
  build(boxes, normals, middle, last);
}

/// The angle to the farthest side of the cone is the sum of that to its axis and its own.
bool NormalCones::cone_looks(const Node& node, const Vec3& way, double least_cosine) {
  const double to_axis = dot(node.axis, way);
  if (to_axis <= 0) return false;
  const double sine = std::sqrt(std::max(0.0, 1 - to_axis * to_axis));
  return to_axis * node.cosine - sine * node.sine > least_cosine;
}

bool NormalCones::all_look(const SurfaceMesh& surface, std::span<const Vec3> normals,
                           const Box3& box, const Vec3& way, double least_cosine) const {
  const auto looks = [&](std::int32_t item) {
    const auto t = static_cast<std::size_t>(item);
    const Vec3& normal = normals[t];
    if (norm2(normal) == 0 || dot(normal, way) > least_cosine) return true;
    return !may_come_into(box, triangle_points(surface.vertices, surface.triangles[t]), normal);
  };
  if (nodes_.empty()) return true;
  std::array<std::int32_t, most_depth> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::int32_t at = stack[--top];
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    if (!node.box.overlaps(box) || cone_looks(node, way, least_cosine)) continue;
    if (node.count == 0) {
      stack[top++] = node.right;
      stack[top++] = at + 1;
      continue;
    }
    const auto first = items_.begin() + node.first;
    if (!std::all_of(first, first + node.count, looks)) return false;
  }
  return true;
}

}  // namespace tetfarm
