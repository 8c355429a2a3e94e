/// Pairs of unrelated meshes of one domain, and fields on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/adaptation/mesh_location.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm::plane_test {

/// The unit square, n by n cells, nodes moved by a share of a cell: those of the sides along them.
inline PlaneMesh shaken_square(int n, std::uint64_t seed, double share = 0.3) {
  PlaneMesh mesh = square(n);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-share / n, share / n);
  for (Vec2& p : mesh.points) {
    const bool is_on_x_side = p.x < 1e-9 || p.x > 1 - 1e-9;
    const bool is_on_y_side = p.y < 1e-9 || p.y > 1 - 1e-9;
    const double dx = move(random);
    const double dy = move(random);
    if (!is_on_x_side) p.x += dx;
    if (!is_on_y_side) p.y += dy;
    if (is_on_x_side) p.x = std::round(p.x);
    if (is_on_y_side) p.y = std::round(p.y);
  }
  return mesh;
}

/// The unit square, n by n cells, thin about x = place: `thinness` of the width they would have.
inline PlaneMesh thin_square(int n, std::uint64_t seed, double place, double thinness) {
  PlaneMesh mesh = square(n);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> move(-0.3 / n, 0.3 / n);
  for (Vec2& p : mesh.points) {
    const double dy = move(random);
    if (p.y > 1e-9 && p.y < 1 - 1e-9) p.y += dy;
    if (p.x < 1e-9 || p.x > 1 - 1e-9) continue;
    const double side = p.x < place ? place : 1 - place;
    const double way = (p.x - place) / side;
    p.x = place + side * way * (thinness + (1 - thinness) * way * way);
  }
  return mesh;
}

template <class FieldAt>
std::vector<double> field_of_points(const PlaneMesh& mesh, const FieldAt& field_at) {
  std::vector<double> values;
  for (const Vec2& p : mesh.points) values.push_back(field_at(p));
  return values;
}

inline std::vector<double> random_field(const PlaneMesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> value(-1, 3);
  return field_of_points(mesh, [&](const Vec2&) { return value(random); });
}

/// From -1 to 1 within 0.04, across a curve.
inline double curved_shock(const Vec2& p) {
  return std::tanh(50 * (p.x - 0.5 - 0.1 * std::sin(2 * std::numbers::pi * p.y)));
}

inline double greatest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}
inline double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

template <class FieldAt>
double greatest_error(const PlaneMesh& mesh, const std::vector<double>& values,
                      const FieldAt& field_at) {
  double error = 0;
  for (std::size_t v = 0; v < values.size(); ++v) {
    error = std::max(error, std::abs(values[v] - field_at(mesh.points[v])));
  }
  return error;
}

}  // namespace tetfarm::plane_test
