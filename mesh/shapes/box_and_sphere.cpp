#include "mesh/shapes/box_and_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

using LatticePoint = std::array<int, 3>;

/// Corners and steps of a box, each lattice point numbered when first asked for.
class BoxLattice {
 public:
  BoxLattice(const Box3& box, const LatticePoint& n) : box_(box), n_(n) {}

  std::int32_t node(const LatticePoint& p) {
    const auto [it, is_new] =
        number_.try_emplace(p, static_cast<std::int32_t>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back({at(0, p[0]), at(1, p[1]), at(2, p[2])});
    }
    return it->second;
  }

  SurfaceMesh mesh;

 private:
  double at(int axis, int i) const {
    const int n = n_[static_cast<std::size_t>(axis)];
    if (i == n) return box_.high[axis];
    return box_.low[axis] + (box_.high[axis] - box_.low[axis]) * i / n;
  }

  Box3 box_;
  LatticePoint n_;
  std::map<LatticePoint, std::int32_t> number_;
};

/// One square of a face, anticlockwise seen along the positive axis when `u` and `v` are the next
/// two axes.
void add_square(BoxLattice& lattice, std::size_t axis, int level, int i, int j,
                const LatticePoint& n) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  std::array<std::int32_t, 4> q{};
  constexpr std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t k = 0; k < 4; ++k) {
    LatticePoint p{};
    p[axis] = level;
    p[u] = i + corners[k][0];
    p[v] = j + corners[k][1];
    q[k] = lattice.node(p);
  }
  const bool rising = (2 * i < n[u]) == (2 * j < n[v]);
  std::array<Triangle, 2> pair =
      rising ? std::array<Triangle, 2>{{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}}
             : std::array<Triangle, 2>{{{q[0], q[1], q[3]}, {q[1], q[2], q[3]}}};
  for (Triangle& t : pair) {
    if (level == 0) std::swap(t[1], t[2]);
    lattice.mesh.triangles.push_back(t);
  }
}

constexpr std::array<Triangle, 20> icosahedron = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::vector<Vec3> icosahedron_corners() {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  return {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
          {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
}

/// Points on the faces of the icosahedron by their weights at its corners. Faces name a point on
/// their common edge alike, so it gets one number, and its sum runs over the corners in one order.
class SphereLattice {
 public:
  SphereLattice(const Vec3& centre, double radius, std::vector<Vec3> corners)
      : corners_(std::move(corners)), centre_(centre), radius_(radius) {}

  std::int32_t node(const Triangle& face, const std::array<int, 3>& weight) {
    Key key{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (weight[i] > 0) key[i] = {face[i] + 1, weight[i]};
    }
    std::ranges::sort(key);
    const auto [it, is_new] =
        number_.try_emplace(key, static_cast<std::int32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(place(key));
    return it->second;
  }

  /// A face in n² triangles.
  void add_face(const Triangle& face, int n) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        const int k = n - i - j;
        const std::int32_t a = node(face, {k, i, j});
        const std::int32_t b = node(face, {k - 1, i + 1, j});
        const std::int32_t c = node(face, {k - 1, i, j + 1});
        mesh.triangles.push_back({a, b, c});
        if (k < 2) continue;
        const std::int32_t d = node(face, {k - 2, i + 1, j + 1});
        mesh.triangles.push_back({b, d, c});
      }
    }
  }

  SurfaceMesh mesh;

 private:
  /// (corner + 1, weight), sorted; (0, 0) where the point lies on an edge or a corner.
  using Key = std::array<std::pair<std::int32_t, int>, 3>;

  Vec3 place(const Key& key) const {
    Vec3 sum;
    for (const auto& [corner, weight] : key) {
      if (weight > 0)
        sum += static_cast<double>(weight) * corners_[static_cast<std::size_t>(corner - 1)];
    }
    return centre_ + radius_ * normalized(sum);
  }

  std::vector<Vec3> corners_;
  Vec3 centre_;
  double radius_;
  std::map<Key, std::int32_t> number_;
};

}  // namespace

SurfaceMesh box_surface(const Box3& box, int n) { return box_surface(box, {n, n, n}); }

SurfaceMesh box_surface(const Box3& box, const std::array<int, 3>& n) {
  return open_box_surface(box, n, {-1, 0});
}

SurfaceMesh open_box_surface(const Box3& box, const std::array<int, 3>& n, const BoxFace& open) {
  TF_CHECK(*std::ranges::min_element(n) > 0);
  BoxLattice lattice(box, n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      if (static_cast<int>(axis) == open.axis && end == open.end) continue;
      for (int i = 0; i < n[(axis + 1) % 3]; ++i) {
        for (int j = 0; j < n[(axis + 2) % 3]; ++j) {
          add_square(lattice, axis, end * n[axis], i, j, n);
        }
      }
    }
  }
  return std::move(lattice.mesh);
}

SurfaceMesh sphere_surface(const Vec3& centre, double radius, int n) {
  TF_CHECK(n > 0);
  SphereLattice lattice(centre, radius, icosahedron_corners());
  for (const Triangle& face : icosahedron) lattice.add_face(face, n);
  return std::move(lattice.mesh);
}

SurfaceMesh half_sphere_surface(const Vec3& centre, double radius, int n, int axis, int side) {
  TF_CHECK(n > 0 && (side == 1 || side == -1));
  std::vector<Vec3> corners(5);
  corners[0][axis] = side;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const int along = (axis + (quarter % 2 == 0 ? 1 : 2)) % 3;
    corners[1 + quarter][along] = quarter < 2 ? 1 : -1;
  }
  SphereLattice lattice(centre, radius, std::move(corners));
  for (std::int32_t quarter = 0; quarter < 4; ++quarter) {
    Triangle face = {0, 1 + quarter, 1 + (quarter + 1) % 4};
    if (side < 0) std::swap(face[1], face[2]);
    lattice.add_face(face, n);
  }
  return std::move(lattice.mesh);
}

double nearest_plane(const SurfaceMesh& sphere, const Vec3& centre) {
  double nearest = HUGE_VAL;
  for (const auto& [a, b, c] : sphere.triangles) {
    const auto at = [&](std::int32_t v) {
      return sphere.vertices[static_cast<std::size_t>(v)] - centre;
    };
    const Vec3 normal = normalized(cross(at(b) - at(a), at(c) - at(a)));
    nearest = std::min(nearest, dot(normal, at(a)));
  }
  return nearest;
}

}  // namespace tetfarm
