#include "mesh/geometry/bowyer_watson.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/geometry/point_location.h"
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

/// Of uniform random points it is 6.77; more than that only costs time.
constexpr std::size_t tets_per_point = 7;

/// From the sorted points back to the given ones.
void renumber(DelaunayTets& tets, const std::vector<std::int32_t>& order,
              std::span<const Vec3> points) {
  TF_CHECK(order.size() == tets.complex.points.size());
  const auto old_number = [&order](std::int32_t v) { return order[static_cast<std::size_t>(v)]; };
  TetComplex& complex = tets.complex;
  std::copy(points.begin(), points.end(), complex.points.begin());
  for (Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    for (std::int32_t& v : tet) v = old_number(v);
  }
  const std::vector<std::int32_t> sorted = std::move(complex.node2tet);
  complex.node2tet.resize(sorted.size());
  for (std::size_t v = 0; v < sorted.size(); ++v) {
    complex.node2tet[static_cast<std::size_t>(order[v])] = sorted[v];
  }
  for (auto& pair : tets.duplicates) pair = {old_number(pair[0]), old_number(pair[1])};
}

}  // namespace

DelaunayTets bowyer_watson(std::span<const Vec3> points, const WorkProgress& progress) {
  TF_CHECK(points.size() < (std::size_t{1} << 31U) - 4);
  DelaunayTets result;
  TetComplex& complex = result.complex;
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  if (points.empty()) box.add(Vec3{});
  const auto n = static_cast<std::int32_t>(points.size());
  // Neighbours in space are neighbours in memory: the kernel works on sorted points.
  std::vector<std::int32_t> order = brio_order(points);
  complex.points.reserve(points.size() + 4);
  for (const std::int32_t v : order) complex.points.push_back(points[static_cast<std::size_t>(v)]);
  for (const Vec3& corner : enclosing_corners(box)) complex.points.push_back(corner);
  for (std::int32_t v = n; v < n + 4; ++v) order.push_back(v);
  complex.nodes.reserve(tets_per_point * points.size() + 64);
  complex.neighbours.reserve(tets_per_point * points.size() + 64);
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

  CavityInsertion insertion(complex, nullptr, order);
  std::int32_t last = first;
  for (std::int32_t v = 0; v < n; ++v) {
    progress.add();
    const Location location = locate(complex, corner(v), last);
    TF_CHECK(location.tet >= 0);
    if (location.node >= 0) {
      result.duplicates.push_back({v, location.node});
      continue;
    }
    TF_CHECK(insertion.find_cavity(v, location.tet));
    last = insertion.fill();
  }
  renumber(result, order, points);
  return result;
}

}  // namespace tetfarm
