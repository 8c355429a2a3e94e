#include "mesh/shapes/corner_reflector.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "mesh/shapes/box_and_sphere.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

using LatticePoint = std::array<int, 3>;

/// The surface of the body on a lattice of n steps to a unit length, seen from around it.
class ReflectorBuilder {
 public:
  ReflectorBuilder(PatchedSurface& surface, int n) : surface_(surface), n_(n) {}

  /// A square with sides of unit length from `low` along the two axes after `axis`; `upward`: its
  /// normal points along `axis`.
  void add_face(std::size_t axis, const LatticePoint& low, bool upward) {
    for (int i = 0; i < n_; ++i) {
      for (int j = 0; j < n_; ++j) add_square(axis, low, i, j, upward);
    }
  }

 private:
  std::int32_t node(const LatticePoint& p) {
    const auto [it, is_new] = number_.try_emplace(p, 0);
    if (is_new) it->second = surface_.add_vertex({at(p[0]), at(p[1]), at(p[2])});
    return it->second;
  }

  double at(int i) const { return static_cast<double>(i) / n_; }

  /// Its diagonal runs from the nearest corner of the face towards the middle.
  void add_square(std::size_t axis, const LatticePoint& low, int i, int j, bool upward) {
    constexpr std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<std::int32_t, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) {
      LatticePoint p = low;
      p[(axis + 1) % 3] += i + corners[k][0];
      p[(axis + 2) % 3] += j + corners[k][1];
      q[k] = node(p);
    }
    if (!upward) std::swap(q[1], q[3]);
    const bool rising = (2 * i < n_) == (2 * j < n_);
    if (rising) {
      surface_.add_triangle(q[0], q[1], q[2]);
      surface_.add_triangle(q[0], q[2], q[3]);
    } else {
      surface_.add_triangle(q[0], q[1], q[3]);
      surface_.add_triangle(q[1], q[2], q[3]);
    }
  }

  PatchedSurface& surface_;
  int n_;
  std::map<LatticePoint, std::int32_t> number_;
};

}  // namespace

SurfaceMesh corner_reflector(double spacing) {
  const int n = parts_of_length(1, spacing, 1);
  PatchedSurface surface;
  surface.begin_patch("outer");
  surface.add_surface(box_surface({{-3, -3, -3}, {3, 3, 3}}, parts_of_length(6, spacing, 1)),
                      false);
  ReflectorBuilder body(surface, n);
  // Normals point out of the domain, into the body.
  surface.begin_patch("reflector");
  for (std::size_t axis = 0; axis < 3; ++axis) body.add_face(axis, {0, 0, 0}, false);
  surface.begin_patch("body");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int u : {-n, 0}) {
      for (const int v : {-n, 0}) {
        LatticePoint low{};
        low[(axis + 1) % 3] = u;
        low[(axis + 2) % 3] = v;
        low[axis] = -n;
        body.add_face(axis, low, true);
        low[axis] = n;
        if (u < 0 || v < 0) body.add_face(axis, low, false);
      }
    }
  }
  return surface.take();
}

}  // namespace tetfarm
