#include "mesh/volume/boundary_recovery.h"

#include <algorithm>

#include "mesh/volume/edge_recovery.h"
#include "mesh/volume/face_recovery.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// How deep and how long a pass searches for each thing that is missing.
struct Effort {
  int depth;
  std::int64_t rings;
};
constexpr std::array<Effort, 6> efforts = {
    {{0, 200}, {1, 2000}, {2, 5000}, {3, 20000}, {4, 50000}, {6, 200000}}};

void recover_edges(LocalRemeshing& mesh, EdgeRemoval& removal, std::vector<Edge>& missing) {
  for (std::size_t pass = 0; pass < efforts.size() && !missing.empty();) {
    const std::size_t before = missing.size();
    std::erase_if(missing, [&](const Edge& edge) {
      removal.set_budget(efforts[pass].rings);
      return recover_edge(mesh, removal, edge[0], edge[1], efforts[pass].depth);
    });
    if (missing.size() == before) ++pass;
  }
}

void recover_faces(LocalRemeshing& mesh, EdgeRemoval& removal, const RecoverySurface& surface,
                   std::vector<std::int32_t>& missing) {
  for (std::size_t pass = 0; pass < efforts.size() && !missing.empty();) {
    const std::size_t before = missing.size();
    std::erase_if(missing, [&](std::int32_t number) {
      const Triangle& face = surface.triangles()[at(number)];
      removal.set_budget(efforts[pass].rings);
      if (!recover_face(mesh, removal, face, efforts[pass].depth)) return false;
      mesh.constrain(mesh.find_face(face[0], face[1], face[2]), true);
      return true;
    });
    if (missing.size() == before) ++pass;
  }
}

}  // namespace

std::vector<Edge> missing_edges(const TetComplex& complex, const RecoverySurface& surface) {
  std::vector<Edge> edges = surface.edges();
  std::vector<std::uint8_t> is_there(edges.size(), 0);
  constexpr std::array<std::array<std::size_t, 2>, 6> ends = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  std::vector<std::size_t> begin(at(surface.nodes()) + 1, 0);
  for (const Edge& edge : edges) ++begin[at(edge[0]) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (const auto& [i, j] : ends) {
      const auto [low, high] = std::minmax(complex.nodes[t][i], complex.nodes[t][j]);
      if (high >= surface.nodes()) continue;
      const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low)]);
      const auto last = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low) + 1]);
      const auto it = std::lower_bound(first, last, Edge{low, high});
      if (it != last && (*it)[1] == high)
        is_there[static_cast<std::size_t>(it - edges.begin())] = 1;
    }
  }
  std::vector<Edge> missing;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(edges[i]);
  }
  return missing;
}

std::vector<std::int32_t> constrain_faces(LocalRemeshing& mesh, const RecoverySurface& surface) {
  std::vector<std::uint8_t> is_there(surface.triangles().size(), 0);
  const TetComplex& complex = mesh.complex();
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (int f = 0; f < 4; ++f) {
      const auto& k = tet_face_nodes[at(f)];
      const Tet& n = complex.nodes[t];
      const std::int32_t a = n[at(k[0])], b = n[at(k[1])], c = n[at(k[2])];
      if (std::max({a, b, c}) >= surface.nodes()) continue;
      const std::int32_t number = surface.find_triangle(a, b, c);
      if (number < 0) continue;
      is_there[at(number)] = 1;
      mesh.constrain(face_handle(static_cast<std::int32_t>(t), f), true);
    }
  }
  std::vector<std::int32_t> missing;
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(static_cast<std::int32_t>(i));
  }
  return missing;
}

RecoveryReport recover_boundary(LocalRemeshing& mesh, const RecoverySurface& surface) {
  RecoveryReport report;
  EdgeRemoval removal(mesh, surface);
  std::vector<Edge> edges = missing_edges(mesh.complex(), surface);
  report.missing_edges = static_cast<std::int64_t>(edges.size());
  recover_edges(mesh, removal, edges);
  report.lost_edges = edges;
  std::vector<std::int32_t> faces = constrain_faces(mesh, surface);
  report.missing_faces = static_cast<std::int64_t>(faces.size());
  recover_faces(mesh, removal, surface, faces);
  report.lost_triangles = faces;
  return report;
}

}  // namespace tetfarm
