#include "mesh/shapes/bent_duct.h"

#include <vector>

#include "mesh/shapes/circle_point.h"
#include "mesh/shapes/patched_surface.h"
#include "mesh/shapes/round_duct.h"

namespace tetfarm {
namespace {

constexpr double straight = 1;
constexpr double quarter_arc = 0x1.921fb54442d18p+0;  // of a bend of radius 1

std::vector<DuctStation> stations_of(double spacing) {
  const int along = parts_of_length(straight, spacing * equilateral_height, 2);
  const int bend = parts_of_length(quarter_arc, spacing * equilateral_height, 3);
  std::vector<DuctStation> stations;
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

}  // namespace

SurfaceMesh bent_duct(double spacing) {
  constexpr double radius = 0.5;
  return round_duct(stations_of(spacing), radius, spacing);
}

}  // namespace tetfarm
