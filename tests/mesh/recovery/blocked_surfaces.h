/// Small surfaces whose Delaunay tets do not have all of their edges and faces, the same bits
/// everywhere: by + - * / and sqrt only.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/mesh/volume/volume_checks.h"
#include "tests/support/generated_skins.h"

namespace tetfarm::shapes {

struct NamedSurface {
  std::string name;
  SurfaceMesh surface;
};

/// A prism of six sides whose top is turned by 22.6 degrees, or by 36.9; the sides bend inward.
inline SurfaceMesh twisted_hexagon(double height, bool far) {
  const double c = 0.86602540378443864676;
  const std::vector<Vec3> corners = {{1, 0, 0},  {0.5, c, 0},   {-0.5, c, 0},
                                     {-1, 0, 0}, {-0.5, -c, 0}, {0.5, -c, 0}};
  const double cosine = far ? 4.0 / 5 : 12.0 / 13;
  const double sine = far ? 3.0 / 5 : 5.0 / 13;
  SurfaceMesh mesh;
  mesh.vertices = corners;
  for (const Vec3& p : corners) {
    mesh.vertices.push_back({cosine * p.x - sine * p.y, sine * p.x + cosine * p.y, height});
  }
  for (std::int32_t i = 0; i < 6; ++i) {
    const std::int32_t next = (i + 1) % 6;
    mesh.triangles.push_back({i, next, 6 + next});
    mesh.triangles.push_back({i, 6 + next, 6 + i});
    if (i == 0 || next == 0) continue;
    mesh.triangles.push_back({0, next, i});
    mesh.triangles.push_back({6, 6 + i, 6 + next});
  }
  return mesh;
}

/// The parts of z = xy over so many slits, which cut into a block from below, and the same from
/// above, a gap apart: many points are needed between them (B. Chazelle, 1984).
inline SurfaceMesh slits(int count, double gap) {
  const int lines = 2 * count + 1;
  const double depth = count;
  const double top = depth + count * count;
  SurfaceMesh mesh;
  const auto point = [&](double x, double y, double z) {
    mesh.vertices.push_back({x, y, z});
    return static_cast<std::int32_t>(mesh.vertices.size() - 1);
  };
  std::vector<std::vector<std::int32_t>> low(static_cast<std::size_t>(lines));
  std::vector<std::vector<std::int32_t>> high = low;
  for (int k = 0; k < lines; ++k) {
    const double s = 0.5 * k;
    const bool is_slit = k % 2 == 1;
    const bool is_side = k == 0 || k == lines - 1;
    for (int j = 0; j < lines; j += is_side ? 1 : lines - 1) {
      const double r = 0.5 * j;
      low[static_cast<std::size_t>(k)].push_back(point(r, s, is_slit ? r * s : -depth));
      high[static_cast<std::size_t>(k)].push_back(point(s, r, is_slit ? r * s + gap : top));
    }
  }
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c, bool turned) {
    mesh.triangles.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  const auto add_strip = [&](const auto& a, const auto& b, bool turned) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) add(a[i], b[0], a[i + 1], turned);
    for (std::size_t i = 0; i + 1 < b.size(); ++i) add(a.back(), b[i], b[i + 1], turned);
  };
  for (std::size_t k = 0; k + 1 < low.size(); ++k) {
    add_strip(low[k], low[k + 1], false);
    add_strip(high[k], high[k + 1], true);
  }
  const auto add_side = [&](const auto& carrier, const auto& others, bool is_last, bool is_low) {
    for (std::size_t k = 0; k + 1 < others.size(); ++k) {
      const auto end = [&](std::size_t i) {
        return is_last ? others[i].back() : others[i].front();
      };
      const bool turned = is_last == is_low;
      add(carrier[k], carrier[k + 1], end(k + 1), turned);
      add(carrier[k], end(k + 1), end(k), turned);
    }
  };
  add_side(low.front(), high, false, true);
  add_side(low.back(), high, true, true);
  add_side(high.front(), low, false, false);
  add_side(high.back(), low, true, false);
  return mesh;
}

/// To nine digits, so that the last ones of a library's functions do not matter.
inline SurfaceMesh rounded(SurfaceMesh mesh) {
  for (Vec3& p : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::nearbyint(p[axis] * 0x1p30) * 0x1p-30;
  }
  return mesh;
}

inline std::vector<NamedSurface> blocked_surfaces() {
  std::vector<NamedSurface> all = {{"schoenhardt", schoenhardt()},
                                   {"hexagon_near", twisted_hexagon(1, false)},
                                   {"hexagon_far", twisted_hexagon(0.5, true)},
                                   {"hexagon_flat", twisted_hexagon(0.05, true)},
                                   {"slits_1", slits(1, 0.02)},
                                   {"slits_2", slits(2, 0.01)}};
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::string number = std::to_string(seed);
    all.push_back({"star_" + number, random_star(1, 0.02, 1.5, seed)});
    all.push_back({"voxels_" + number, voxels(seed, 2)});
    all.push_back({"grid_" + number, grid(seed, 1)});
  }
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    all.push_back({"spikes_" + std::to_string(seed), random_star(2, 0.05, 1.5, seed)});
  }
  return all;
}

}  // namespace tetfarm::shapes
