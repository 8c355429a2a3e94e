#include "mesh/shapes/round_duct.h"

#include <utility>

#include "base/check.h"
#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

/// The circles lie as hexagons in each other: the j-th of m has 6 j points. Those of every second
/// station are turned by half a step of the outermost.
class DuctBuilder {
 public:
  DuctBuilder(double radius, int m) : radius_(radius), m_(m) {}

  VertexRow circle(const DuctStation& station, int j, bool turned) {
    if (j == 0) return {surface.add_vertex(station.centre)};
    VertexRow row;
    const double r = radius_ * j / m_;
    for (int k = 0; k < 6 * j; ++k) {
      const auto [c, s] = circle_point(2 * m_ * k + (turned ? j : 0), 12 * m_ * j);
      row.push_back(
          surface.add_vertex(station.centre + r * c * Vec3{0, 0, 1} + r * s * station.across));
    }
    return row;
  }

  void close_end(const DuctStation& station, const VertexRow& rim, bool turned, bool is_inlet) {
    VertexRow inner = circle(station, 0, turned);
    for (int j = 1; j <= m_; ++j) {
      VertexRow outer = j == m_ ? rim : circle(station, j, turned);
      if (is_inlet) {
        surface.zip_rings(inner, outer);
      } else {
        surface.zip_rings(outer, inner);
      }
      inner = std::move(outer);
    }
  }

  PatchedSurface surface;

 private:
  double radius_;
  int m_;
};

}  // namespace

SurfaceMesh round_duct(const std::vector<DuctStation>& stations, double radius, double spacing) {
  TF_CHECK(stations.size() > 1 && radius > 0);
  // Between the steps along the radius and round the rim, which is 2 pi / 6 of it.
  const int m = parts_of_length(1.02 * radius, spacing, 2);
  DuctBuilder duct(radius, m);
  duct.surface.begin_patch("inlet");
  VertexRow row = duct.circle(stations.front(), m, false);
  duct.close_end(stations.front(), row, false, true);
  duct.surface.begin_patch("wall");
  bool turned = false;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    turned = !turned;
    VertexRow next = duct.circle(stations[i], m, turned);
    duct.surface.zip_rings(row, next);
    row = std::move(next);
  }
  duct.surface.begin_patch("outlet");
  duct.close_end(stations.back(), row, turned, false);
  return duct.surface.take();
}

}  // namespace tetfarm
