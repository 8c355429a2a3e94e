// Bodies that go through each other at random, many of them flush or nearly so, and what they
// enclose by other means than the winding numbers of regions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/geometry/triangle_distance.h"
#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm::test {

/// How often a surface winds round a point, by the solid angles of its triangles.
inline double winding(const SurfaceMesh& surface, const Vec3& p) {
  double sum = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePoints c = points_of(surface, t);
    const Vec3 x = c[0] - p;
    const Vec3 y = c[1] - p;
    const Vec3 z = c[2] - p;
    const double lengths = norm(x) * norm(y) * norm(z);
    sum += 2 * std::atan2(dot(x, cross(y, z)), lengths + dot(x, y) * norm(z) + dot(y, z) * norm(x) +
                                                   dot(z, x) * norm(y));
  }
  return sum / (4 * std::numbers::pi);
}

inline double distance_to(const SurfaceMesh& surface, const Vec3& p) {
  double least2 = HUGE_VAL;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePoints c = points_of(surface, t);
    least2 = std::min(least2, distance2_to_triangle(p, c[0], c[1], c[2]));
  }
  return std::sqrt(least2);
}

/// Turned from a grid on which their faces and edges lay on each other.
inline bool is_nearly_flush(std::uint64_t seed) { return seed % 4 == 3; }

/// Six boxes and balls: of every four seeds, two on a coarse grid, so that faces and edges lie on
/// each other, and two turned, so that they nearly do.
class RandomBodies {
 public:
  explicit RandomBodies(std::uint64_t seed) : seed_(seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    const auto coordinate = [&] {
      return seed % 2 == 0 ? any(random) : std::round(any(random) * 4) / 4;
    };
    for (int i = 0; i < 6; ++i) {
      const Vec3 low{coordinate(), coordinate(), coordinate()};
      const Vec3 size{0.25 + coordinate(), 0.25 + coordinate(), 0.25 + coordinate()};
      bodies_.push_back(i % 3 == 2 ? shapes::sphere(low, 0.3 * size.x, 1)
                                   : shapes::box(low, low + size, 1 + i % 2));
    }
    const double turn = seed % 4 < 2 ? 0 : any(random);
    for (SurfaceMesh& body : bodies_) {
      for (Vec3& p : body.vertices) {
        p = {p.x * std::cos(turn) - p.y * std::sin(turn),
             p.x * std::sin(turn) + p.y * std::cos(turn), p.z};
      }
      body.patch_of_triangle.clear();
      body.patch_names.clear();
      all_ = with_body(all_, body);
    }
  }

  const SurfaceMesh& all() const { return all_; }

  /// Of so many random points that are not just at the bodies.
  std::vector<Vec3> points_told_wrongly_by(const SurfaceMesh& united, int points) const {
    std::mt19937_64 random(seed_ + 1);
    std::uniform_real_distribution<double> any(-1, 2);
    std::vector<Vec3> wrong;
    for (int i = 0; i < points; ++i) {
      const Vec3 p{any(random), any(random), any(random)};
      if (distance_to(all_, p) < 1e-4) continue;
      const bool is_inside = std::ranges::any_of(
          bodies_, [&](const SurfaceMesh& body) { return winding(body, p) > 0.5; });
      if ((winding(united, p) > 0.5) != is_inside) wrong.push_back(p);
    }
    return wrong;
  }

 private:
  std::uint64_t seed_;
  std::vector<SurfaceMesh> bodies_;
  SurfaceMesh all_;
};

}  // namespace tetfarm::test
