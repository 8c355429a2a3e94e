#include "mesh/shapes/bent_duct.h"

#include <utility>
#include <vector>

#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

constexpr double radius = 0.5;
constexpr double straight = 1;
constexpr double quarter_turn = 0x1.921fb54442d18p+0;  // of a bend of radius 1
constexpr double row_height = 0x1.bb67ae8584caap-1;    // of equilateral triangles

/// A circle of the duct: z and `across` span its plane.
struct Station {
  Vec3 centre;
  Vec3 across;
};

std::vector<Station> stations_of(double spacing) {
  const int along = parts_of_length(straight, spacing * row_height, 2);
  const int bend = parts_of_length(quarter_turn, spacing * row_height, 3);
  std::vector<Station> stations;
  for (int i = 0; i < along; ++i) stations.push_back({{straight * i / along, 0, 0}, {0, 1, 0}});
  for (int i = 0; i <= bend; ++i) {
    const auto [c, s] = circle_point(i, 4 * bend);
    stations.push_back({{straight + s, 1 - c, 0}, {0 - s, c, 0}});
  }
  for (int i = 1; i <= along; ++i) {
    stations.push_back({{straight + 1, 1 + straight * i / along, 0}, {-1, 0, 0}});
  }
  return stations;
}

/// The circles lie as hexagons in each other: the j-th of m has 6 j points. Those of every second
/// station are turned by half a step of the outermost.
class DuctBuilder {
 public:
  explicit DuctBuilder(int m) : m_(m) {}

  VertexRow circle(const Station& station, int j, bool turned) {
    if (j == 0) return {surface.add_vertex(station.centre)};
    VertexRow row;
    const double r = radius * j / m_;
    for (int k = 0; k < 6 * j; ++k) {
      const auto [c, s] = circle_point(2 * m_ * k + (turned ? j : 0), 12 * m_ * j);
      row.push_back(
          surface.add_vertex(station.centre + r * c * Vec3{0, 0, 1} + r * s * station.across));
    }
    return row;
  }

  void close_end(const Station& station, const VertexRow& rim, bool turned, bool is_inlet) {
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
  int m_;
};

}  // namespace

SurfaceMesh bent_duct(double spacing) {
  // Between the steps along the radius and round the rim, which is 2 pi / 6 of it.
  const int m = parts_of_length(1.02 * radius, spacing, 2);
  const std::vector<Station> stations = stations_of(spacing);
  DuctBuilder duct(m);
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
