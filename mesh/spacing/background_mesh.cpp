#include "mesh/spacing/background_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/point_location.h"

namespace tetfarm {

BackgroundMesh::BackgroundMesh(const std::vector<SourceDemand>& sources, const Box3& box,
                               double background, double growth) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < 8; ++k) {
    const auto side = [&](int axis) { return (k >> axis & 1U) != 0 ? box.high : box.low; };
    points.push_back({side(0).x, side(1).y, side(2).z});
    spacing_.push_back(background);
  }
  for (const SourceDemand& demand : sources) {
    for (const SourceCorner& corner : demand.source.corners) {
      points.push_back(corner.at);
      spacing_.push_back(std::min(corner.spacing, background));
    }
  }
  std::vector<double> limited = spacing_;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < points.size(); ++b) {
      const double limit = spacing_[b] + growth * distance(points[a], points[b]);
      limited[a] = std::min(limited[a], limit);
    }
  }
  DelaunayTets tets = bowyer_watson(points);
  for (const auto& [dropped, kept] : tets.duplicates) {
    const auto to = static_cast<std::size_t>(kept);
    limited[to] = std::min(limited[to], limited[static_cast<std::size_t>(dropped)]);
  }
  spacing_ = std::move(limited);
  spacing_.resize(tets.complex.points.size(), background);
  complex_ = std::make_unique<TetComplex>(std::move(tets.complex));
  while (!complex_->is_live(last_tet_)) ++last_tet_;
}

double BackgroundMesh::at(const Vec3& point) const {
  const Location found = locate(*complex_, point, last_tet_);
  TF_CHECK(found.tet >= 0);
  last_tet_ = found.tet;
  if (found.node >= 0) return spacing_[static_cast<std::size_t>(found.node)];
  const Tet& tet = complex_->nodes[static_cast<std::size_t>(found.tet)];
  std::array<Vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = complex_->points[static_cast<std::size_t>(tet[k])];
  }
  double weights = 0;
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<Vec3, 4> part = corners;
    part[k] = point;
    const double weight = std::max(0.0, tet_volume(part[0], part[1], part[2], part[3]));
    weights += weight;
    sum += weight * spacing_[static_cast<std::size_t>(tet[k])];
  }
  // All four volumes may underflow in a tet that is flat to rounding.
  return weights > 0 ? sum / weights : spacing_[static_cast<std::size_t>(tet[0])];
}

}  // namespace tetfarm
