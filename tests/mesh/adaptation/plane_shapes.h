/// Small meshes of the plane with patches and regions, and what is measured of a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/metric_mesh.h"
#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm::plane_test {

/// Every border edge as an edge of the mesh, with the patch at its middle.
template <class PatchAt>
void add_border(PlaneMesh& mesh, const PatchAt& patch_at) {
  const TriangleComplex complex = make_triangle_complex(mesh.points, mesh.triangles);
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) != no_edge) continue;
      const std::int32_t a = complex.node(t, next(i));
      const std::int32_t b = complex.node(t, previous(i));
      const Vec2& p = complex.point(a);
      const Vec2& q = complex.point(b);
      mesh.edges.push_back({a, b});
      mesh.patches.push_back(patch_at(Vec2{(p.x + q.x) / 2, (p.y + q.y) / 2}));
    }
  }
}

/// Cells of size h from (0, 0), nx by ny of them, two triangles each; `region_at` gives the region
/// of a cell by its middle, and -1 where there is none.
template <class RegionAt>
PlaneMesh grid(int nx, int ny, double h, const RegionAt& region_at) {
  PlaneMesh mesh;
  std::map<std::pair<int, int>, std::int32_t> numbers;
  const auto number = [&](int i, int j) {
    const auto [place, is_new] =
        numbers.try_emplace({i, j}, static_cast<std::int32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back({h * i, h * j});
    return place->second;
  };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const std::int32_t region = region_at(Vec2{h * (i + 0.5), h * (j + 0.5)});
      if (region < 0) continue;
      const std::int32_t a = number(i, j);
      const std::int32_t b = number(i + 1, j);
      const std::int32_t c = number(i + 1, j + 1);
      const std::int32_t d = number(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
      mesh.regions.insert(mesh.regions.end(), 2, region);
    }
  }
  return mesh;
}

/// Of the unit square: 1 below, 2 right, 3 above, 4 left.
inline std::int32_t side_of_square(const Vec2& p) {
  if (p.y < 1e-9) return 1;
  if (p.x > 1 - 1e-9) return 2;
  return p.y > 1 - 1e-9 ? 3 : 4;
}

/// The unit square, n by n cells, with patches 1 to 4.
inline PlaneMesh square(int n) {
  PlaneMesh mesh = grid(n, n, 1.0 / n, [](const Vec2&) { return 0; });
  add_border(mesh, side_of_square);
  return mesh;
}

/// The square of side 2 without its upper right quarter; all of its border is patch 1.
inline PlaneMesh ell(int n) {
  PlaneMesh mesh =
      grid(2 * n, 2 * n, 1.0 / n, [](const Vec2& p) { return p.x > 1 && p.y > 1 ? -1 : 0; });
  add_border(mesh, [](const Vec2&) { return 1; });
  return mesh;
}

/// Two unit squares side by side: region 1 left of x = 1 and 2 right of it; patch 7 all round, and
/// no edges given between the regions.
inline PlaneMesh two_regions(int n) {
  PlaneMesh mesh = grid(2 * n, n, 1.0 / n, [](const Vec2& p) { return p.x < 1 ? 1 : 2; });
  add_border(mesh, [](const Vec2&) { return 7; });
  return mesh;
}

/// The unit disc in n rings; its border, 6 n edges, is patch 5.
inline PlaneMesh disc(int n) {
  PlaneMesh mesh;
  mesh.points.push_back({0, 0});
  const auto node = [](int ring, int k) {
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring);
  };
  for (int ring = 1; ring <= n; ++ring) {
    for (int k = 0; k < 6 * ring; ++k) {
      const double angle = std::numbers::pi * k / (3 * ring);
      const double radius = static_cast<double>(ring) / n;
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    for (int sector = 0; sector < 6; ++sector) {
      for (int k = 0; k < ring; ++k) {
        const std::int32_t outer = node(ring, sector * ring + k);
        const std::int32_t after = node(ring, sector * ring + k + 1);
        const std::int32_t inner = node(ring - 1, sector * (ring - 1) + k);
        mesh.triangles.push_back({inner, outer, after});
        if (k + 1 == ring) continue;
        mesh.triangles.push_back({inner, after, node(ring - 1, sector * (ring - 1) + k + 1)});
      }
    }
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  add_border(mesh, [](const Vec2&) { return 5; });
  return mesh;
}

/// A square of side 2 about a hole of the given radius, in rings of 4 n nodes: patch 1 outside,
/// patch 2 round the hole.
inline PlaneMesh square_with_hole(double radius, int n, int rings) {
  PlaneMesh mesh;
  const int around = 4 * n;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * n) / around;
      const double side = static_cast<double>(k % n) / n * 2 - 1;
      const Vec2 outer = k < n       ? Vec2{-side, 1}
                         : k < 2 * n ? Vec2{-1, -side}
                         : k < 3 * n ? Vec2{side, -1}
                                     : Vec2{1, side};
      const double share = static_cast<double>(ring) / rings;
      mesh.points.push_back({(1 - share) * radius * std::cos(angle) + share * outer.x,
                             (1 - share) * radius * std::sin(angle) + share * outer.y});
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const std::int32_t a = ring * around + k;
      const std::int32_t b = ring * around + (k + 1) % around;
      mesh.triangles.push_back({a, a + around, b + around});
      mesh.triangles.push_back({a, b + around, b});
    }
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  add_border(mesh,
             [](const Vec2& p) { return std::max(std::abs(p.x), std::abs(p.y)) > 0.999 ? 1 : 2; });
  return mesh;
}

template <class MetricAt>
std::vector<Metric2> metrics_of(const PlaneMesh& mesh, const MetricAt& metric_at) {
  std::vector<Metric2> metrics;
  for (const Vec2& p : mesh.points) metrics.push_back(metric_at(p));
  return metrics;
}

inline std::vector<Metric2> constant_metrics(const PlaneMesh& mesh, const Metric2& metric) {
  return std::vector<Metric2>(mesh.points.size(), metric);
}

/// The metric of the size h in all directions.
inline Metric2 round_metric(double h) { return {1 / (h * h), 0, 1 / (h * h)}; }

/// The matrix of a figure of the thesis, times what makes its unit the size h.
inline Metric2 scaled(const Metric2& m, double h) {
  return {m.xx / (h * h), m.xy / (h * h), m.yy / (h * h)};
}

inline MetricMesh metric_mesh(const PlaneMesh& mesh, const std::vector<Metric2>& metrics) {
  return make_metric_mesh(mesh, checked_complex(mesh), metrics, 30);
}

inline MetricField field_of(const PlaneMesh& mesh, const std::vector<Metric2>& metrics) {
  return MetricField(checked_complex(mesh), metrics);
}

inline double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline double area(const TriangleComplex& complex) {
  double twice = 0;
  for (const auto& [a, b, c] : complex.triangles) {
    if (a < 0) continue;
    twice += turn(complex.point(a), complex.point(b), complex.point(c));
  }
  return twice / 2;
}

inline double area(const PlaneMesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice += turn(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]);
  }
  return twice / 2;
}

/// How many pairs of border edges cross; a mesh whose triangles lie over others has some.
inline int border_crossings(const PlaneMesh& mesh) {
  const TriangleComplex complex = make_triangle_complex(mesh.points, mesh.triangles);
  std::vector<std::pair<std::int32_t, std::int32_t>> border;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) != no_edge) continue;
      border.emplace_back(complex.node(t, next(i)), complex.node(t, previous(i)));
    }
  }
  const auto separates = [&](const auto& edge, const auto& other) {
    const Vec2& a = complex.point(edge.first);
    const Vec2& b = complex.point(edge.second);
    return orient2d(a, b, complex.point(other.first)) *
               orient2d(a, b, complex.point(other.second)) <
           0;
  };
  int crossings = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    for (std::size_t k = i + 1; k < border.size(); ++k) {
      crossings += separates(border[i], border[k]) && separates(border[k], border[i]) ? 1 : 0;
    }
  }
  return crossings;
}

/// How far the nodes of curves are from where they belong, at most.
inline double distance_from_curves(const MetricMesh& mesh) {
  double distance = 0;
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    const std::int32_t curve = mesh.curve_of_node[at(v)];
    if (curve < 0 || mesh.complex.node2triangle[at(v)] < 0) continue;
    const Vec2 there = mesh.curves[at(curve)].shape.at(mesh.parameters[at(v)]);
    const Vec2& here = mesh.complex.point(v);
    distance = std::max(distance, std::hypot(there.x - here.x, there.y - here.y));
  }
  return distance;
}

/// The length of the edges of each patch.
inline std::map<std::int32_t, double> patch_lengths(const PlaneMesh& mesh) {
  std::map<std::int32_t, double> lengths;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const Vec2& p = mesh.points[at(mesh.edges[k][0])];
    const Vec2& q = mesh.points[at(mesh.edges[k][1])];
    lengths[mesh.patches[k]] += std::hypot(q.x - p.x, q.y - p.y);
  }
  return lengths;
}

/// The area of each region.
inline std::map<std::int32_t, double> region_areas(const PlaneMesh& mesh) {
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    areas[mesh.regions[t]] += turn(mesh.points[at(a)], mesh.points[at(b)], mesh.points[at(c)]) / 2;
  }
  return areas;
}

/// The edges of the triangles, each once, from the smaller number.
inline std::vector<std::pair<std::int32_t, std::int32_t>> edges_of(const PlaneMesh& mesh) {
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  for (const auto& nodes : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = nodes[i];
      const std::int32_t b = nodes[(i + 1) % 3];
      edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Which share of the edges has a metric length in [1/sqrt 2, sqrt 2].
template <class MetricAt>
double share_of_unit_edges(const PlaneMesh& mesh, const MetricAt& metric_at) {
  const auto edges = edges_of(mesh);
  std::size_t unit = 0;
  for (const auto& [a, b] : edges) {
    const Vec2& p = mesh.points[at(a)];
    const Vec2& q = mesh.points[at(b)];
    const Vec2 edge{q.x - p.x, q.y - p.y};
    const double length = length_between(std::sqrt(squared_length(metric_at(p), edge)),
                                         std::sqrt(squared_length(metric_at(q), edge)));
    if (length >= std::sqrt(0.5) && length <= std::sqrt(2.0)) ++unit;
  }
  return static_cast<double>(unit) / static_cast<double>(edges.size());
}

/// What is wrong with a mesh on its own: triangles that do not turn anticlockwise, neighbours that
/// do not fit, edges of the border that are not among its edges, nodes that nothing uses.
inline std::vector<std::string> whats_wrong(const PlaneMesh& mesh) {
  TriangleComplex complex = make_triangle_complex(mesh.points, mesh.triangles);
  std::vector<std::string> wrong = tetfarm::validate(complex);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (complex.node2triangle[v] < 0) wrong.push_back("node " + std::to_string(v) + " is unused");
  }
  if (mesh.regions.size() != mesh.triangles.size()) wrong.push_back("regions");
  if (mesh.patches.size() != mesh.edges.size()) wrong.push_back("patches");
  std::map<std::uint64_t, int> named;
  for (const auto& [a, b] : mesh.edges) {
    if (++named[edge_key(a, b)] > 1) wrong.push_back("an edge is named twice");
  }
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.neighbour(t, i) != no_edge) continue;
      if (!named.contains(edge_key(complex.node(t, next(i)), complex.node(t, previous(i))))) {
        wrong.push_back("an edge of the border has no patch");
      }
    }
  }
  if (wrong.size() > 20) wrong.resize(20);
  return wrong;
}

/// A disc of radius 1 and a ring about it, with a gap of 0.02 between them over most of the way.
inline PlaneMesh disc_in_a_narrow_gap() {
  constexpr int around = 96;
  const std::array<double, 9> radii{0.4, 0.6, 0.8, 0.9, 1, 1.02, 1.2, 1.6, 2};
  PlaneMesh mesh;
  for (const double radius : radii) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  for (int ring = 0; ring < 8; ++ring) {
    for (int k = 0; k < around; ++k) {
      if (ring == 4 && k < 80) continue;
      const std::int32_t a = ring * around + k;
      const std::int32_t b = ring * around + (k + 1) % around;
      mesh.triangles.push_back({a, a + around, b + around});
      mesh.triangles.push_back({a, b + around, b});
    }
  }
  mesh.regions.assign(mesh.triangles.size(), 0);
  add_border(mesh, [](const Vec2&) { return 1; });
  return mesh;
}

}  // namespace tetfarm::plane_test
