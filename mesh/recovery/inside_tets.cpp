#include "mesh/recovery/inside_tets.h"

#include <array>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// Whether the outward face of a tet turns as the triangle with the same nodes does.
bool turns_alike(const std::array<std::int32_t, 3>& face, const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (face[0] == triangle[k]) return face[1] == triangle[(k + 1) % 3];
  }
  return false;
}

enum : std::uint8_t { unknown = 0, inside = 1, outside = 2 };

}  // namespace

std::vector<std::uint8_t> inside_tets(const LocalRemeshing& mesh, const RecoverySurface& surface) {
  const TetComplex& complex = mesh.complex();
  std::vector<std::uint8_t> side(complex.nodes.size(), unknown);
  std::vector<std::int32_t> queue;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    const auto tet = static_cast<std::int32_t>(t);
    if (!complex.is_live(tet)) continue;
    for (int f = 0; f < 4; ++f) {
      if (!mesh.is_constrained(face_handle(tet, f))) continue;
      const auto& k = tet_face_nodes[at(f)];
      const Tet& n = complex.nodes[t];
      const std::array<std::int32_t, 3> face = {n[at(k[0])], n[at(k[1])], n[at(k[2])]};
      const std::int32_t number = surface.find_triangle(face[0], face[1], face[2]);
      if (number < 0) continue;
      const std::uint8_t here =
          turns_alike(face, surface.triangles()[at(number)]) ? inside : outside;
      if (side[t] == unknown) {
        side[t] = here;
        queue.push_back(tet);
      } else if (side[t] != here) {
        return {};
      }
    }
  }
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::int32_t t = queue[head];
    for (int f = 0; f < 4; ++f) {
      if (mesh.is_constrained(face_handle(t, f))) continue;
      const FaceHandle other = complex.neighbours[at(t)][at(f)];
      if (other == no_face) {
        if (side[at(t)] == inside) return {};
        continue;
      }
      std::uint8_t& beyond = side[at(tet_of(other))];
      if (beyond == unknown) {
        beyond = side[at(t)];
        queue.push_back(tet_of(other));
      } else if (beyond != side[at(t)]) {
        return {};
      }
    }
  }
  for (std::uint8_t& s : side) s = s == inside ? 1 : 0;
  return side;
}

InsideComplex keep_inside(const TetComplex& complex, const std::vector<std::uint8_t>& constrained,
                          const std::vector<std::uint8_t>& inside, std::int32_t boundary_nodes,
                          std::int32_t dropped) {
  TF_CHECK(inside.size() == complex.nodes.size() && constrained.size() == complex.nodes.size());
  TF_CHECK(at(boundary_nodes + dropped) <= complex.points.size());
  InsideComplex kept;
  kept.complex.points = complex.points;
  const auto first = kept.complex.points.begin() + boundary_nodes;
  kept.complex.points.erase(first, first + dropped);
  kept.complex.node2tet.assign(kept.complex.points.size(), -1);
  std::vector<std::int32_t> new_number(complex.nodes.size(), -1);
  std::int32_t count = 0;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] != 0) new_number[t] = count++;
  }
  kept.complex.nodes.reserve(at(count));
  kept.complex.neighbours.reserve(at(count));
  kept.constrained.reserve(at(count));
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] == 0) continue;
    Tet nodes = complex.nodes[t];
    for (std::int32_t& v : nodes) {
      TF_CHECK(v < boundary_nodes || v >= boundary_nodes + dropped);
      if (v >= boundary_nodes) v -= dropped;
      kept.complex.node2tet[at(v)] = new_number[t];
    }
    std::array<FaceHandle, 4> neighbours = complex.neighbours[t];
    for (FaceHandle& other : neighbours) {
      if (other == no_face) continue;
      const std::int32_t beyond = new_number[at(tet_of(other))];
      other = beyond < 0 ? no_face : face_handle(beyond, face_of(other));
    }
    kept.complex.nodes.push_back(nodes);
    kept.complex.neighbours.push_back(neighbours);
    kept.constrained.push_back(constrained[t]);
  }
  TF_CHECK(kept.complex.nodes.size() == at(count));
  return kept;
}

}  // namespace tetfarm
