#include "mesh/shapes/trihedral_cavity.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "mesh/shapes/box_and_sphere.h"
#include "mesh/shapes/patched_surface.h"

namespace tetfarm {
namespace {

constexpr double cavity_leg = 0.36;
constexpr double plate = 0.03;
constexpr double back_leg = cavity_leg + 3 * plate;
constexpr double rim_width = 0x1.3988e1409212ep+0 * plate;  // sqrt(3/2): between its two triangles

/// Three sides, each from one corner to the next: on x and y, on y and z, on z and x.
using TriangularRing = std::array<VertexRow, 3>;

/// Three triangular faces that meet at right angles, their legs in n steps along the axes.
class CornerBuilder {
 public:
  CornerBuilder(PatchedSurface& surface, double origin, double leg, int n)
      : surface_(surface), origin_(origin), leg_(leg), n_(n) {}

  /// `upward`: the face's normal points along its axis.
  void add_faces(bool upward) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < n_; ++i) {
        for (int j = 0; i + j < n_; ++j) add_pair(axis, i, j, upward);
      }
    }
  }

  TriangularRing rim() {
    TriangularRing ring;
    for (std::size_t side = 0; side < 3; ++side) {
      for (int i = 0; i <= n_; ++i) {
        ring[side].push_back(node((side + 2) % 3, n_ - i, i));
      }
    }
    return ring;
  }

 private:
  /// On the face across `axis`: u steps along the next axis, v along the one after.
  std::int32_t node(std::size_t axis, int u, int v) {
    std::array<int, 3> steps{};
    steps[(axis + 1) % 3] = u;
    steps[(axis + 2) % 3] = v;
    const auto [it, is_new] = number_.try_emplace(steps, 0);
    if (is_new) it->second = surface_.add_vertex({at(steps[0]), at(steps[1]), at(steps[2])});
    return it->second;
  }

  double at(int steps) const { return origin_ + leg_ * steps / n_; }

  void add_triangle(std::int32_t a, std::int32_t b, std::int32_t c, bool upward) {
    if (!upward) std::swap(b, c);
    surface_.add_triangle(a, b, c);
  }

  /// The triangle next to the corner of a square, and the one beyond its diagonal where that is
  /// still on the face.
  void add_pair(std::size_t axis, int i, int j, bool upward) {
    const std::int32_t right = node(axis, i + 1, j);
    const std::int32_t above = node(axis, i, j + 1);
    add_triangle(node(axis, i, j), right, above, upward);
    if (i + j + 2 <= n_) add_triangle(right, node(axis, i + 1, j + 1), above, upward);
  }

  PatchedSurface& surface_;
  double origin_;
  double leg_;
  int n_;
  std::map<std::array<int, 3>, std::int32_t> number_;
};

/// `share` of the way from one ring to the other.
TriangularRing ring_between(PatchedSurface& surface, const TriangularRing& inner,
                            const TriangularRing& outer, double share) {
  const auto from = static_cast<double>(inner[0].size() - 1);
  const auto to = static_cast<double>(outer[0].size() - 1);
  const int parts = static_cast<int>(std::lround(from + share * (to - from)));
  std::array<std::int32_t, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = surface.at(inner[i].front());
    corner[i] = surface.add_vertex(a + share * (surface.at(outer[i].front()) - a));
  }
  TriangularRing ring;
  for (std::size_t side = 0; side < 3; ++side) {
    const Vec3 a = surface.at(corner[side]);
    const Vec3 step = surface.at(corner[(side + 1) % 3]) - a;
    ring[side].push_back(corner[side]);
    for (int i = 1; i < parts; ++i) {
      ring[side].push_back(surface.add_vertex(a + step * (static_cast<double>(i) / parts)));
    }
    ring[side].push_back(corner[(side + 1) % 3]);
  }
  return ring;
}

/// The plates' edges, in the plane of the mouth. Their normals point into the plates.
void add_rim(PatchedSurface& surface, TriangularRing inner, const TriangularRing& outer,
             int rings) {
  const TriangularRing innermost = inner;
  for (int r = 1; r <= rings; ++r) {
    TriangularRing next =
        r == rings ? outer
                   : ring_between(surface, innermost, outer, static_cast<double>(r) / rings);
    for (std::size_t side = 0; side < 3; ++side) surface.zip(next[side], inner[side]);
    inner = std::move(next);
  }
}

}  // namespace

SurfaceMesh trihedral_cavity(double spacing) {
  constexpr double low = -0.15;
  constexpr double high = 0.54;
  constexpr double row_of_the_rim = 0x1.3988e1409212ep+0;  // its edges are diagonals of squares
  PatchedSurface surface;
  surface.begin_patch("outer");
  surface.add_surface(
      box_surface({{low, low, low}, {high, high, high}}, parts_of_length(high - low, spacing, 1)),
      false);
  surface.begin_patch("cavity");
  CornerBuilder cavity(surface, 0, cavity_leg, parts_of_length(cavity_leg, spacing, 1));
  cavity.add_faces(false);
  surface.begin_patch("body");
  CornerBuilder back(surface, -plate, back_leg, parts_of_length(back_leg, spacing, 1));
  back.add_faces(true);
  add_rim(surface, cavity.rim(), back.rim(),
          parts_of_length(rim_width, row_of_the_rim * spacing, 1));
  return surface.take();
}

}  // namespace tetfarm
