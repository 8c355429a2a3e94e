#include "mesh/filling/point_insertion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/geometry/point_location.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

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
    if (is_nearer_to_triangle(point, complex.points[at(x[0])], complex.points[at(x[1])],
                              complex.points[at(x[2])], from_faces)) {
      return false;
    }
  }
  return true;
}

/// Whether no boundary can run between a core node away from it and the point.
bool reaches(const LatticeNode& core_node, const Vec3& p) {
  const double reach = core_reach * core_node.cell_edge;
  return norm2(p - core_node.at) < reach * reach;
}

}  // namespace

std::vector<std::uint8_t> find_inside_nodes(const TetComplex& complex,
                                            const std::vector<std::uint8_t>& inside,
                                            const std::vector<LatticeNode>& nodes,
                                            const std::vector<std::uint8_t>& core_kinds) {
  TF_CHECK(core_kinds.size() == nodes.size() && inside.size() == complex.nodes.size());
  std::vector<std::uint8_t> is_inside(nodes.size(), 0);
  std::int32_t last = 0;
  while (!complex.is_live(last)) ++last;
  // Core nodes that were last met, the latest first: neighbours come one after the other.
  std::array<std::size_t, 4> cores;
  cores.fill(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto near = std::find_if(cores.begin(), cores.end(), [&](std::size_t core) {
      return core < nodes.size() && reaches(nodes[core], nodes[i].place());
    });
    if (near != cores.end()) {
      is_inside[i] = is_inside[*near];
    } else {
      const Location location = locate(complex, nodes[i].place(), last);
      if (location.tet >= 0) last = location.tet;
      is_inside[i] = location.tet >= 0 ? inside[at(location.tet)] : 0;
    }
    if (core_kinds[i] == core_away) {
      std::copy_backward(cores.begin(), cores.end() - 1, cores.end());
      cores[0] = i;
    }
  }
  return is_inside;
}

void insert_lattice(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                    std::int32_t boundary_nodes, const std::vector<LatticeNode>& nodes,
                    const PointInsertionOptions& options) {
  TF_CHECK(boundary_nodes >= 0 && at(boundary_nodes) <= complex.points.size());
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
  constexpr int tell_every = 1 << 12;
  options.progress.begin(WorkStage::points, nodes.size(), tell_every);
  for (const std::int32_t i : brio_order(places)) {
    options.progress.add();
    const std::int32_t node = first + i;
    const Location location = locate(complex, places[at(i)], last);
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
