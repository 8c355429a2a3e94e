#include "mesh/volume/point_insertion.h"

#include <algorithm>
#include <span>

#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Square of the distance from p to the triangle abc.
double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double area2 = norm2(normal);
  bool is_above = area2 > 0;
  double nearest = HUGE_VAL;
  for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
    const Vec3 along = v - u;
    const double length2 = norm2(along);
    const double t = length2 > 0 ? std::clamp(dot(p - u, along) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm2(p - (u + t * along)));
    if (dot(cross(normal, along), p - u) < 0) is_above = false;
  }
  if (!is_above) return nearest;
  const double height = dot(normal, p - a);
  return height * height / area2;
}

/// Whether the cavity's boundary faces and nodes leave the point room.
bool keeps_clear(const TetComplex& complex, const std::vector<std::uint8_t>& constrained,
                 const std::vector<FaceHandle>& hull, const Vec3& point,
                 std::int32_t boundary_nodes, double from_faces, double from_nodes) {
  for (const FaceHandle face : hull) {
    const Tet& n = complex.nodes[at(tet_of(face))];
    const auto& f = tet_face_nodes[at(face_of(face))];
    const std::array<std::int32_t, 3> x = {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
    for (const std::int32_t v : x) {
      if (v < boundary_nodes && norm2(complex.points[at(v)] - point) < from_nodes * from_nodes) {
        return false;
      }
    }
    if ((constrained[at(tet_of(face))] >> face_of(face) & 1) == 0) continue;
    if (distance2_to_triangle(point, complex.points[at(x[0])], complex.points[at(x[1])],
                              complex.points[at(x[2])]) < from_faces * from_faces) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<LatticeNode> nodes_inside(const TetComplex& complex,
                                      const std::vector<std::uint8_t>& inside,
                                      const SpacingField& spacing, const Box3& box) {
  std::vector<LatticeNode> nodes = spacing.lattice_nodes(box);
  // Only walks: nothing is inserted.
  TetComplex& walked = const_cast<TetComplex&>(complex);
  const CavityInsertion walk(walked);
  std::int32_t last = 0;
  while (!complex.is_live(last)) ++last;
  std::erase_if(nodes, [&](const LatticeNode& node) {
    const Location location = walk.locate(node.place(), last);
    if (location.tet < 0) return true;
    last = location.tet;
    return inside[at(location.tet)] == 0;
  });
  return nodes;
}

void insert_lattice(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                    std::int32_t boundary_nodes, const std::vector<LatticeNode>& nodes,
                    const PointInsertionOptions& options) {
  const auto first = static_cast<std::int32_t>(complex.points.size());
  for (const LatticeNode& node : nodes) complex.points.push_back(node.place());
  complex.node2tet.resize(complex.points.size(), -1);
  // The lattice fills the domain with some six tets a node.
  complex.nodes.reserve(complex.nodes.size() + 6 * nodes.size());
  complex.neighbours.reserve(complex.neighbours.size() + 6 * nodes.size());
  CavityInsertion insertion(complex, &constrained);
  std::int32_t last = 0;
  while (!complex.is_live(last)) ++last;
  const std::vector<Vec3> places(complex.points.begin() + first, complex.points.end());
  std::int64_t done = 0;
  constexpr std::int64_t report_every = 1 << 15;
  for (const std::int32_t i : brio_order(places)) {
    if (options.progress && ++done % report_every == 0) {
      options.progress(static_cast<std::int64_t>(complex.live_tets()));
    }
    const std::int32_t node = first + i;
    const Location location = insertion.locate(places[at(i)], last);
    if (location.tet < 0) continue;
    last = location.tet;
    if (location.node >= 0 || !insertion.find_cavity(node, location.tet)) continue;
    const double h = lattice_ratio * nodes[at(i)].cell_edge;
    if (keeps_clear(complex, constrained, insertion.hull(), places[at(i)], boundary_nodes,
                    options.face_clearance * h, options.node_clearance * h)) {
      last = insertion.fill();
    }
  }
}

}  // namespace tetfarm
