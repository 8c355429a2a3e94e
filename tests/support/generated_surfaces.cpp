#include "tests/support/generated_surfaces.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/array_index.h"
#include "tests/support/chance.h"
#include "tests/support/generated_skins.h"
#include "tests/support/shapes.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

constexpr double pi = std::numbers::pi;

/// A prism of n sides whose top is turned; the sides' diagonals run inside.
SurfaceMesh prism(int n, double twist, double height, double top_radius) {
  SurfaceMesh mesh;
  for (int k = 0; k < 2 * n; ++k) {
    const bool is_top = k >= n;
    const double angle = 2 * pi * (k % n) / n + (is_top ? twist : 0);
    const double radius = is_top ? top_radius : 1;
    mesh.vertices.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), is_top ? height : 0});
  }
  for (std::int32_t k = 1; k + 1 < n; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({n, n + k, n + k + 1});
  }
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t next = (k + 1) % n;
    add_quad(mesh, {k, next, n + next, n + k}, false);
  }
  return with_one_patch(mesh);
}

SurfaceMesh schoenhardt_prism(std::uint64_t seed, int) {
  Chance chance(seed);
  const double most = pi / 3;
  const double left = seed % 2 == 0 ? chance.between(0.05, 0.95) : chance.small(-5, -2);
  // One at a time: compilers differ in the order of arguments.
  const double radius = chance.between(0.5, 1);
  const double height = chance.small(-3, 2);
  return prism(3, most * (seed % 4 < 2 ? left : 1 - left), height, radius);
}

SurfaceMesh twisted_prism(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick(4, 8 * size);
  const double most = pi - 2 * pi / n;
  const double height = chance.small(-1, 1);
  return prism(n, most * chance.between(0, 0.95), height, 1);
}

/// Slits from below whose ridges lie on z = xy, slits from above whose valleys lie a gap higher.
SurfaceMesh chazelle(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int slits = chance.pick(1, size);
  const double gap = chance.small(-3, -1);
  const double depth = chance.between(0.5, 3) * slits;
  const int lines = 2 * slits + 1;
  SurfaceMesh mesh;
  const double top = depth + slits * slits;
  const auto point = [&](double x, double y, double z) {
    mesh.vertices.push_back({x, y, z});
    return static_cast<std::int32_t>(mesh.vertices.size() - 1);
  };
  // Lines of odd number are edges of slits. The first and last line carry the ends of the others.
  std::vector<std::vector<std::int32_t>> low(static_cast<std::size_t>(lines)), high = low;
  for (int k = 0; k < lines; ++k) {
    const double s = 0.5 * k;
    const bool is_slit = k % 2 == 1;
    const bool is_side = k == 0 || k == lines - 1;
    for (int j = 0; j < lines; j += is_side ? 1 : lines - 1) {
      const double r = 0.5 * j;
      low[at(k)].push_back(point(r, s, is_slit ? r * s : -depth));
      high[at(k)].push_back(point(s, r, is_slit ? r * s + gap : top));
    }
  }
  const auto add_strip = [&](const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b,
                             bool is_low) {
    const auto add = [&](std::int32_t u, std::int32_t v, std::int32_t w) {
      mesh.triangles.push_back(is_low ? Triangle{u, v, w} : Triangle{u, w, v});
    };
    for (std::size_t i = 0; i + 1 < a.size(); ++i) add(a[i], b[0], a[i + 1]);
    for (std::size_t i = 0; i + 1 < b.size(); ++i) add(a.back(), b[i], b[i + 1]);
  };
  for (std::size_t k = 0; k + 1 < low.size(); ++k) {
    add_strip(low[k], low[k + 1], true);
    add_strip(high[k], high[k + 1], false);
  }
  const auto add_side = [&](const auto& carrier, const auto& others, bool is_last, bool is_low) {
    for (std::size_t k = 0; k + 1 < others.size(); ++k) {
      const auto end = [&](std::size_t i) {
        return is_last ? others[i].back() : others[i].front();
      };
      std::array<std::int32_t, 4> q = {carrier[k], carrier[k + 1], end(k + 1), end(k)};
      if (is_last == is_low) std::swap(q[1], q[3]);
      add_quad(mesh, q, false);
    }
  };
  add_side(low.front(), high, false, true);
  add_side(low.back(), high, true, true);
  add_side(high.front(), low, false, false);
  add_side(high.back(), low, true, false);
  return with_one_patch(mesh);
}

SurfaceMesh star(std::uint64_t seed, int size) {
  Chance chance(seed);
  SurfaceMesh mesh = sphere({0, 0, 0}, 1, chance.pick(0, size));
  const double shortest = chance.small(-3, -1);
  for (Vec3& p : mesh.vertices) {
    p *= chance.pick(0, 3) == 0 ? chance.between(shortest, 1.5) : chance.between(shortest, 0.3);
  }
  return mesh;
}

/// Triangles split beside their edges, edges beside their ends: angles far below a degree.
SurfaceMesh needles(std::uint64_t seed, int size) {
  Chance chance(seed);
  SurfaceMesh mesh = chance.coin() ? unit_cube() : sphere({0, 0, 0}, 1, size - 1);
  const int splits = chance.pick(3, 30 * size);
  const int power = chance.pick(-6, -1);
  for (int i = 0; i < splits; ++i) {
    const auto number = at(chance.pick(0, static_cast<int>(mesh.triangles.size()) - 1));
    const auto [a, b, c] = mesh.triangles[number];
    const double beside = chance.small(power, -1) / 3;
    const double along = chance.coin() ? chance.between(0.1, 0.9) : chance.small(power, -1);
    const Vec3 on_edge = (1 - along) * mesh.vertices[at(a)] + along * mesh.vertices[at(b)];
    const auto node = static_cast<std::int32_t>(mesh.vertices.size());
    if (chance.coin()) {
      mesh.vertices.push_back((1 - beside) * on_edge + beside * mesh.vertices[at(c)]);
      mesh.triangles[number] = {a, b, node};
      mesh.triangles.push_back({b, c, node});
      mesh.triangles.push_back({c, a, node});
      continue;
    }
    mesh.vertices.push_back(on_edge);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      for (int k = 0; k < 3; ++k) {
        auto& x = mesh.triangles[t];
        const std::int32_t u = x[at(k)], v = x[at((k + 1) % 3)], w = x[at((k + 2) % 3)];
        if (!((u == a && v == b) || (u == b && v == a))) continue;
        x = {u, node, w};
        mesh.triangles.push_back({node, v, w});
        break;
      }
    }
  }
  return with_one_patch(mesh);
}

/// A thin cone or spindle on a polygon: all its triangles meet at the tips.
SurfaceMesh spindle(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick(3, 60 * size);
  const double length = std::pow(10, chance.pick(-2, 4));
  SurfaceMesh mesh;
  for (int k = 0; k < n; ++k) {
    mesh.vertices.push_back({std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0});
  }
  mesh.vertices.push_back({0, 0, length});
  mesh.vertices.push_back({0, 0, chance.coin() ? -length : length * chance.small(-4, -1)});
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t next = (k + 1) % n;
    mesh.triangles.push_back({k, next, n});
    mesh.triangles.push_back({next, k, n + 1});
  }
  return with_one_patch(mesh);
}

void append(SurfaceMesh& mesh, const SurfaceMesh& other) { mesh = between(mesh, other); }

/// Shells in shells, a millionth of their size apart, or blocks that nearly touch.
SurfaceMesh near_shells(std::uint64_t seed, int size) {
  Chance chance(seed);
  const double gap = chance.small(-6, -1);
  const SurfaceMesh outer = chance.coin() ? star(seed + 1, size - 1)
                                          : box({-1, -1, -1}, {1, 1, 1}, chance.pick(1, 2 * size));
  SurfaceMesh mesh = outer;
  SurfaceMesh next = outer;
  for (int shells = chance.pick(1, size); shells > 0; --shells) {
    for (Vec3& p : next.vertices) p *= 1 - gap;
    append(mesh, next);
  }
  if (chance.coin()) {
    SurfaceMesh beside = box({-1, -1, -1}, {1, 1, 1}, chance.pick(1, 2 * size));
    for (Vec3& p : beside.vertices) p.x += 3.5 + gap;
    append(mesh, beside);
    for (Vec3& p : beside.vertices) p.x += 2 + gap;
    append(mesh, beside);
  }
  return with_one_patch(mesh);
}

/// Rings of points on a sphere or a cylinder: all on one sphere, quads flat.
SurfaceMesh rings(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int n = chance.pick(3, 12 * size), m = chance.pick(1, 6 * size);
  SurfaceMesh mesh;
  const bool is_round = chance.coin();
  const double height = chance.small(-3, 1);
  for (int j = 0; j <= m; ++j) {
    const double v = pi * (j + 1) / (m + 2);
    for (int i = 0; i < n; ++i) {
      const double u = 2 * pi * i / n;
      const double r = is_round ? std::sin(v) : 1;
      mesh.vertices.push_back(
          {r * std::cos(u), r * std::sin(u), is_round ? -std::cos(v) : height * j});
    }
  }
  for (std::int32_t k = 1; k + 1 < n; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({m * n, m * n + k, m * n + k + 1});
  }
  for (std::int32_t j = 0; j < m; ++j) {
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t next = (i + 1) % n;
      add_quad(mesh, {j * n + i, j * n + next, (j + 1) * n + next, (j + 1) * n + i}, chance.coin());
    }
  }
  return with_one_patch(mesh);
}

/// A cylinder as CAD tessellates it: both ends are fans of needles from one node of the rim, the
/// side is a strip of two triangles a segment.
SurfaceMesh drum(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int sides = size * chance.pick(20, 60);
  const double height = chance.small(-3, 1);
  const double top_radius = chance.coin() ? 1 : chance.between(0.3, 3);
  return prism(sides, 0, height, top_radius);
}

/// The strip between two closed paths that begin side by side: at each step the one that lags goes
/// on, so that where one has far more nodes there are fans.
void add_strip(SurfaceMesh& mesh, std::int32_t first, int n, std::int32_t second, int m,
               bool is_turned) {
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    mesh.triangles.push_back(is_turned ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  for (int i = 0, j = 0; i < n || j < m;) {
    const std::int32_t p = first + i % n, q = second + j % m;
    if (j == m || (i < n && i * m <= j * n)) {
      add(p, first + (i + 1) % n, q);
      ++i;
    } else {
      add(p, second + (j + 1) % m, q);
      ++j;
    }
  }
}

/// A plate with a round hole: rims of different numbers of nodes, strips of needles between them.
SurfaceMesh washer(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int outer = size * chance.pick(20, 60);
  const int inner = size * chance.pick(5, 30);
  const double thickness = chance.small(-3, 0);
  const double radius = chance.between(0.3, 0.8);
  SurfaceMesh mesh;
  const auto add_rim = [&mesh](int n, double r, double z) {
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * pi * k / n;
      mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  };
  add_rim(outer, 1, 0);
  add_rim(outer, 1, thickness);
  add_rim(inner, radius, 0);
  add_rim(inner, radius, thickness);
  const std::int32_t hole = 2 * outer;
  add_strip(mesh, 0, outer, hole, inner, true);
  add_strip(mesh, outer, outer, hole + inner, inner, false);
  add_strip(mesh, 0, outer, outer, outer, false);
  add_strip(mesh, hole, inner, hole + inner, inner, true);
  return with_one_patch(mesh);
}

/// A tube along a torus knot that winds p times round the axis and q times round the ring.
SurfaceMesh knot(std::uint64_t seed, int size) {
  Chance chance(seed);
  const int p = chance.pick(1, 3), q = p == 1 ? 0 : chance.pick(1, 2) * p + 1;
  const int n = chance.pick(4, 7) * std::max(p, q) * size, m = chance.pick(3, 5);
  const double radius = (p == 1 ? 0.5 : 0.3 / p) * (chance.coin() ? 1 : chance.small(-3, -1));
  const auto curve = [&](double t) {
    const double r = 1 + (p == 1 ? 0 : 0.45) * std::cos(q * t);
    return Vec3{r * std::cos(p * t), r * std::sin(p * t), 0.45 * std::sin(q * t)};
  };
  SurfaceMesh mesh;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    const Vec3 along = normalized(curve(t + 1e-4) - curve(t - 1e-4));
    const Vec3 aside = normalized(cross(along, {0, 0, 1}));
    const Vec3 up = cross(aside, along);
    for (int j = 0; j < m; ++j) {
      const double v = 2 * pi * j / m;
      mesh.vertices.push_back(curve(t) + (radius * std::cos(v)) * aside +
                              (radius * std::sin(v)) * up);
    }
  }
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t next = (i + 1) % n;
    for (std::int32_t j = 0; j < m; ++j) {
      const std::int32_t k = (j + 1) % m;
      add_quad(mesh, {i * m + j, i * m + k, next * m + k, next * m + j}, chance.coin());
    }
  }
  return with_one_patch(mesh);
}

}  // namespace

std::span<const SurfaceGenerator> surface_generators() {
  static constexpr std::array<SurfaceGenerator, 15> all = {
      {{"schoenhardt_prism", schoenhardt_prism},
       {"twisted_prism", twisted_prism},
       {"chazelle", chazelle},
       {"star", star},
       {"needles", needles},
       {"spindle", spindle},
       {"near_shells", near_shells},
       {"voxels", voxels},
       {"handles", handles},
       {"grid", grid},
       {"cubes", cubes},
       {"rings", rings},
       {"knot", knot},
       {"drum", drum},
       {"washer", washer}}};
  return all;
}

SurfaceMesh moved_by_chance(SurfaceMesh surface, std::uint64_t seed) {
  const Box3 box = bounding_box(surface.vertices);
  const double size = norm(box.size());
  const double angle = Chance(seed).between(0, pi);
  for (Vec3& p : surface.vertices) {
    switch (seed % 7) {
      case 1:
        p = {std::cos(angle) * p.x - std::sin(angle) * p.z, p.y,
             std::sin(angle) * p.x + std::cos(angle) * p.z};
        break;
      case 2:
        p += size * Vec3{1e6, -1e6, 1e6};
        break;
      case 3:
        p *= 1e-9;
        break;
      case 4:
        p *= 1e9;
        break;
      case 5:
        p.z *= 1e-4;
        break;
      default:
        break;
    }
  }
  return surface;
}

}  // namespace tetfarm::shapes
