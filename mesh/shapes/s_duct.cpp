#include "mesh/shapes/s_duct.h"

#include <vector>

#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/patched_surface.h"
#include "mesh/shapes/round_duct.h"

namespace tetfarm {
namespace {

constexpr double tube_radius = 0.225;
constexpr double centre_line = 6.2;
constexpr double bend_radius = 2.4;
constexpr int arcs_of_circle = 12;
constexpr double full_turn = 0x1.921fb54442d18p+2;
constexpr double arc = bend_radius * full_turn / arcs_of_circle;
constexpr double straight_end = 0.5 * centre_line - arc;

/// From the inlet to the middle of the S.
std::vector<DuctStation> first_half(double spacing) {
  const int along = parts_of_length(straight_end, spacing * equilateral_height, 2);
  const int bend = parts_of_length(arc, spacing * equilateral_height, 3);
  std::vector<DuctStation> stations;
  for (int i = 0; i < along; ++i) stations.push_back({{straight_end * i / along, 0, 0}, {0, 1, 0}});
  for (int i = 0; i <= bend; ++i) {
    const auto [c, s] = circle_point(i, arcs_of_circle * bend);
    stations.push_back({{straight_end + bend_radius * s, bend_radius * (1 - c), 0}, {0 - s, c, 0}});
  }
  return stations;
}

}  // namespace

SurfaceMesh s_duct(double spacing) {
  std::vector<DuctStation> stations = first_half(spacing);
  // The S is its own image in its middle.
  const Vec3 middle = stations.back().centre;
  for (std::size_t i = stations.size() - 1; i-- > 0;) {
    stations.push_back({2 * middle - stations[i].centre, stations[i].across});
  }
  return round_duct(stations, tube_radius, spacing);
}

}  // namespace tetfarm
