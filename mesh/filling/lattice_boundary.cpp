#include "mesh/filling/lattice_boundary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t hash = 0;
  for (const double x : {p.x, p.y, p.z}) {
    // Adding zero makes one of the two zeros.
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

/// Vertices of cuts by their place; open addressing.
class VerticesOfCuts {
 public:
  explicit VerticesOfCuts(const Subdomain& subdomain) : vertices_(subdomain.vertices) {
    const auto count = static_cast<std::size_t>(
        std::count_if(subdomain.node_origin.begin(), subdomain.node_origin.end(), is_of_cut));
    if (count == 0) return;
    slots_.assign(std::bit_ceil(4 * count), -1);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (!is_of_cut(subdomain.node_origin[v])) continue;
      std::size_t i = first_slot(vertices_[v]);
      while (slots_[i] >= 0) i = (i + 1) & (slots_.size() - 1);
      slots_[i] = static_cast<std::int32_t>(v);
    }
  }

  bool empty() const { return slots_.empty(); }
  std::int32_t find(const Vec3& p) const {
    for (std::size_t i = first_slot(p); slots_[i] >= 0; i = (i + 1) & (slots_.size() - 1)) {
      if (vertices_[at(slots_[i])] == p) return slots_[i];
    }
    return -1;
  }

 private:
  std::size_t first_slot(const Vec3& p) const { return hash_of(p) & (slots_.size() - 1); }

  const std::vector<Vec3>& vertices_;
  std::vector<std::int32_t> slots_;
};

bool is_unshifted(const LatticeNode& node) { return node.shift == std::array<std::int8_t, 3>{}; }

/// The distance on each axis, in half cells, ascending.
std::array<std::int32_t, 3> half_cells_between(const LatticeNode& a, const LatticeNode& b) {
  std::array<std::int32_t, 3> d;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    d[axis] = std::abs(a.grid[axis] - b.grid[axis]) >> (a.cell_bits - 1);
  }
  std::sort(d.begin(), d.end());
  return d;
}

/// Faces of lattice tets: an edge as long as a cell's, and two from corners to centres.
bool is_face_of_lattice(const LatticeNode& a, const LatticeNode& b, const LatticeNode& c) {
  if (a.cell_bits == 0 || a.cell_bits != b.cell_bits || a.cell_bits != c.cell_bits) return false;
  constexpr std::array<std::int32_t, 3> along_edge = {0, 0, 2};
  constexpr std::array<std::int32_t, 3> to_centre = {1, 1, 1};
  int edges = 0;
  int halves = 0;
  for (const auto& d :
       {half_cells_between(a, b), half_cells_between(b, c), half_cells_between(c, a)}) {
    if (d == along_edge) ++edges;
    if (d == to_centre) ++halves;
  }
  return edges == 1 && halves == 2;
}

}  // namespace

LatticeBoundary find_lattice_boundary(std::span<const LatticeNode> nodes,
                                      const Subdomain& subdomain) {
  TF_CHECK(subdomain.node_origin.size() == subdomain.vertices.size());
  LatticeBoundary boundary;
  boundary.is_lattice_face.assign(subdomain.triangles.size(), 0);
  const VerticesOfCuts vertices(subdomain);
  if (vertices.empty()) return boundary;
  boundary.node2vertex.assign(nodes.size(), -1);
  std::vector<std::int32_t> vertex2node(subdomain.vertices.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_unshifted(nodes[i])) continue;
    const std::int32_t vertex = vertices.find(nodes[i].at);
    if (vertex < 0) continue;
    boundary.node2vertex[i] = vertex;
    vertex2node[at(vertex)] = static_cast<std::int32_t>(i);
  }
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    const auto& [a, b, c] = subdomain.triangles[t];
    const std::int32_t i = vertex2node[at(a)], j = vertex2node[at(b)], k = vertex2node[at(c)];
    boundary.is_lattice_face[t] =
        i >= 0 && j >= 0 && k >= 0 && is_face_of_lattice(nodes[at(i)], nodes[at(j)], nodes[at(k)])
            ? 1
            : 0;
  }
  return boundary;
}

}  // namespace tetfarm
