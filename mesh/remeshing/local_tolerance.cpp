#include "mesh/remeshing/local_tolerance.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr double share_of_face = 2e-3;

}  // namespace

std::vector<double> face_shares(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                double tolerance) {
  TF_CHECK(features.face.size() == surface.triangles.size());
  std::vector<Box3> boxes(static_cast<std::size_t>(features.face_count));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Box3& box = boxes[static_cast<std::size_t>(features.face[t])];
    for (const std::int32_t v : surface.triangles[t]) {
      box.add(surface.vertices[static_cast<std::size_t>(v)]);
    }
  }
  std::vector<double> shares;
  shares.reserve(surface.triangles.size());
  for (const std::int32_t face : features.face) {
    const double size = norm(boxes[static_cast<std::size_t>(face)].size());
    shares.push_back(std::min(1.0, share_of_face * size / tolerance));
  }
  return shares;
}

std::vector<double> shares_of_tolerance(const SurfaceMesh& surface, const SurfaceFeatures& features,
                                        const RemeshOptions& options) {
  if (options.has_local_tolerance) return face_shares(surface, features, options.tolerance);
  return std::vector<double>(surface.triangles.size(), 1);
}

}  // namespace tetfarm
