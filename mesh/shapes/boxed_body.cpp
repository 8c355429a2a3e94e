#include "mesh/shapes/boxed_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/shapes/box_and_sphere.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

constexpr const char* box_patch = "outer";

void check_box(const SurfaceMesh& body, const FittingBox& box) {
  if (body.triangles.empty()) throw UsageError("there is no body to put a box round", "--box");
  if (!(box.margin > 0) || !std::isfinite(box.margin)) {
    throw UsageError("the margin must be positive; it is " + text_of(box.margin), "--box");
  }
  if (std::ranges::count(body.patch_names, box_patch) > 0) {
    throw UsageError("the surface has a patch \"outer\" already, and needs no box", "--box");
  }
}

}  // namespace

SurfaceMesh boxed_body(const SurfaceMesh& body, const FittingBox& box) {
  check_box(body, box);
  const Box3 inner = bounding_box(body.vertices);
  const Vec3 margin{box.margin, box.margin, box.margin};
  const Box3 outer{inner.low - margin, inner.high + margin};
  std::array<int, 3> parts{};
  for (int axis = 0; axis < 3; ++axis) {
    parts[static_cast<std::size_t>(axis)] =
        parts_of_length(outer.size()[axis], box.spacing, 2, "--box-size");
  }
  const SurfaceMesh boundary = box_surface(outer, parts);

  SurfaceMesh result{
      body.vertices, body.triangles, body.patch_of_triangle, body.patch_names, {}, {}};
  for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
  if (result.patch_of_triangle.empty()) {
    result.patch_of_triangle.assign(result.triangles.size(), 0);
    result.patch_names = {"surface"};
  }
  const auto first = static_cast<std::int32_t>(result.vertices.size());
  result.vertices.insert(result.vertices.end(), boundary.vertices.begin(), boundary.vertices.end());
  for (const auto& [a, b, c] : boundary.triangles) {
    result.triangles.push_back({first + a, first + b, first + c});
  }
  result.patch_of_triangle.resize(result.triangles.size(),
                                  static_cast<std::int32_t>(result.patch_names.size()));
  result.patch_names.emplace_back(box_patch);
  return result;
}

}  // namespace tetfarm
