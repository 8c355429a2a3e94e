#include "mesh/geometry/point_location.h"

#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
Location locate(const TetComplex& complex, const Vec3& point, std::int32_t start) {
  TF_CHECK(complex.is_live(start));
  std::int32_t tet = start;
  FaceHandle entry = no_face;
  // A walk in a mesh that is not Delaunay may run in circles; turning the first face tried breaks
  // them.
  std::uint32_t turn = 0;
  const std::size_t most_steps = complex.nodes.size() + 1000;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const Tet& t = complex.nodes[at(tet)];
    // The nodes of the face it came through are known not to be the point.
    for (int i = 0; i < 4; ++i) {
      if (entry != no_face && i != face_of(entry)) continue;
      if (complex.points[at(t[at(i)])] == point) return {tet, t[at(i)]};
    }
    FaceHandle exit = no_face;
    bool is_outside = false;
    turn = turn * 1664525U + 1013904223U;
    for (int k = 0; k < 4; ++k) {
      const int i = (k + static_cast<int>(turn >> 30)) & 3;
      if (face_handle(tet, i) == entry) continue;
      const auto [a, b, c] = complex.face_nodes(face_handle(tet, i));
      if (orient3d(complex.points[at(a)], complex.points[at(b)], complex.points[at(c)], point) <=
          0) {
        continue;
      }
      exit = complex.neighbours[at(tet)][at(i)];
      if (exit == no_face) {
        is_outside = true;
        continue;
      }
      break;
    }
    if (exit == no_face) return is_outside ? Location{} : Location{tet, -1};
    entry = exit;
    tet = tet_of(exit);
  }
  return {};
}

}  // namespace tetfarm
