/// The point sets of the Delaunay trials: the same ones for this kernel and for others.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// `kind`: uniform in the unit cube; clustered (half of them in 20 balls of all sizes); lattice
/// (body-centred, with whole coordinates).
inline std::vector<Vec3> delaunay_points(const std::string& kind, std::size_t count) {
  std::uint64_t state = 20260722;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  const auto in_cube = [&next] {
    const double x = next();
    const double y = next();
    return Vec3{x, y, next()};
  };
  std::vector<Vec3> points;
  points.reserve(count);
  if (kind == "lattice") {
    const auto side = static_cast<int>(std::cbrt(static_cast<double>(count) / 2) + 0.5);
    for (int i = 0; i < 2 * side; ++i) {
      for (int j = i & 1; j < 2 * side; j += 2) {
        for (int k = i & 1; k < 2 * side; k += 2) {
          points.push_back(
              {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
        }
      }
    }
    return points;
  }
  std::vector<Vec3> centres(20);
  for (Vec3& c : centres) c = in_cube();
  while (points.size() < count) {
    if (kind == "uniform" || points.size() % 2 == 0) {
      points.push_back(in_cube());
      continue;
    }
    const std::size_t ball = points.size() / 2 % centres.size();
    const double radius = 0.1 / static_cast<double>(1 + ball * ball);
    points.push_back(centres[ball] + radius * (in_cube() - Vec3{0.5, 0.5, 0.5}));
  }
  return points;
}

}  // namespace tetfarm
