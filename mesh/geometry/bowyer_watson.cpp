#include "mesh/geometry/bowyer_watson.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

/// A tetrahedron with alternate corners of a cube far round the box.
std::array<Vec3, 4> enclosing_corners(const Box3& box) {
  const Vec3 centre = box.centre();
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z, 1e-30 + 1e-9 * norm(centre)});
  const double r = 8 * largest;
  return {centre + Vec3{-r, -r, -r}, centre + Vec3{r, r, -r}, centre + Vec3{r, -r, r},
          centre + Vec3{-r, r, r}};
}

}  // namespace

DelaunayTets bowyer_watson(std::span<const Vec3> points) {
  DelaunayTets result;
  TetComplex& complex = result.complex;
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  if (points.empty()) box.add(Vec3{});
  const auto n = static_cast<std::int32_t>(points.size());
  complex.points.assign(points.begin(), points.end());
  for (const Vec3& corner : enclosing_corners(box)) complex.points.push_back(corner);
  complex.node2tet.assign(complex.points.size(), -1);
  const std::int32_t first = complex.new_tet();
  Tet& tet = complex.nodes[static_cast<std::size_t>(first)];
  tet = {n, n + 1, n + 2, n + 3};
  const auto corner = [&complex](std::int32_t v) {
    return complex.points[static_cast<std::size_t>(v)];
  };
  if (orient3d(corner(n), corner(n + 1), corner(n + 2), corner(n + 3)) < 0) {
    std::swap(tet[0], tet[1]);
  }
  complex.neighbours[static_cast<std::size_t>(first)] = {no_face, no_face, no_face, no_face};
  for (std::int32_t v = n; v < n + 4; ++v) complex.node2tet[static_cast<std::size_t>(v)] = first;

  CavityInsertion insertion(complex);
  std::int32_t last = first;
  for (const std::int32_t v : brio_order(points)) {
    const Location location = insertion.locate(points[static_cast<std::size_t>(v)], last);
    TF_CHECK(location.tet >= 0);
    if (location.node >= 0) {
      result.duplicates.push_back({v, location.node});
      continue;
    }
    TF_CHECK(insertion.find_cavity(v, location.tet));
    last = insertion.fill();
  }
  return result;
}

}  // namespace tetfarm
