#include "mesh/recovery/face_recovery.h"

#include <algorithm>
#include <unordered_set>

#include "base/array_index.h"

namespace tetfarm {
std::vector<std::array<std::int32_t, 2>> piercing_edges(const LocalRemeshing& mesh,
                                                        const Triangle& face) {
  std::vector<std::array<std::int32_t, 2>> found;
  // Large faces of fans and plates are pierced by thousands.
  std::unordered_set<std::uint64_t> seen;
  const auto add_if_piercing = [&](std::int32_t u, std::int32_t v) {
    const std::array<std::int32_t, 2> edge = {std::min(u, v), std::max(u, v)};
    if (!seen.insert(std::uint64_t{static_cast<std::uint32_t>(edge[0])} << 32U |
                     static_cast<std::uint32_t>(edge[1]))
             .second) {
      return;
    }
    const auto is_corner = [&face](std::int32_t w) {
      return w == face[0] || w == face[1] || w == face[2];
    };
    if (is_corner(u) || is_corner(v)) return;
    if (segment_crosses_triangle(mesh, u, v, face)) found.push_back(edge);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto ring = mesh.ring(face[k], face[(k + 1) % 3]);
    if (!ring) continue;
    const std::size_t n = ring->apexes.size();
    for (std::size_t i = 0; i < n; ++i) add_if_piercing(ring->apexes[i], ring->apexes[(i + 1) % n]);
  }
  // Round each piercing edge lie the others: the face runs through all tets of its ring.
  for (std::size_t head = 0; head < found.size(); ++head) {
    const auto [u, v] = found[head];
    const auto ring = mesh.ring(u, v);
    if (!ring) continue;
    for (const std::int32_t t : ring->tets) {
      const Tet& n = mesh.complex().nodes[at(t)];
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) add_if_piercing(n[i], n[j]);
      }
    }
  }
  return found;
}

bool recover_face(LocalRemeshing& mesh, EdgeRemoval& removal, const Triangle& face, int depth) {
  const RecoveryGuard guard = RecoveryGuard::of_face(mesh, face);
  while (mesh.find_face(face[0], face[1], face[2]) == no_face) {
    const auto edges = piercing_edges(mesh, face);
    const bool is_cleared = std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
      return removal.remove(edge[0], edge[1], guard, depth);
    });
    mesh.forget_journal();
    if (!is_cleared) return false;
  }
  return true;
}

}  // namespace tetfarm
