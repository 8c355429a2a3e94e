#include "mesh/volume/edge_removal_by_flips.h"

#include <algorithm>
#include <array>

#include "mesh/volume/ring_triangulation.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

bool EdgeRemoval::has_constrained_face(const EdgeRing& ring, std::int32_t a, std::int32_t b) const {
  for (std::size_t i = 0; i < ring.tets.size(); ++i) {
    const Tet& n = mesh_.complex().nodes[at(ring.tets[i])];
    for (int f = 0; f < 4; ++f) {
      const std::int32_t opposite = n[at(f)];
      if (opposite != a && opposite != b && mesh_.is_constrained(face_handle(ring.tets[i], f))) {
        return true;
      }
    }
  }
  return false;
}

bool EdgeRemoval::flip_ring(const EdgeRing& ring, std::int32_t a, std::int32_t b, std::int32_t ear,
                            const RecoveryGuard& guard) {
  const auto triangles = ring_triangulation(mesh_, ring, a, b, ear, guard);
  if (!triangles) return false;
  std::vector<Tet> tets;
  for (const auto& [i, j, k] : *triangles) {
    const std::int32_t p = ring.apexes[i], q = ring.apexes[j], r = ring.apexes[k];
    tets.push_back({p, q, r, b});
    tets.push_back({p, r, q, a});
  }
  mesh_.replace(ring.tets, tets);
  return true;
}

bool EdgeRemoval::shorten_ring(const EdgeRing& ring, std::int32_t a, std::int32_t b,
                               const RecoveryGuard& guard, int depth) {
  for (const std::int32_t apex : ring.apexes) {
    if (remove(a, apex, b, guard, depth - 1) || remove(b, apex, a, guard, depth - 1)) return true;
  }
  return false;
}

bool EdgeRemoval::remove(std::int32_t a, std::int32_t b, std::int32_t ear,
                         const RecoveryGuard& guard, int depth) {
  if (surface_.has_edge(a, b)) return false;
  const std::size_t mark = mesh_.mark();
  // Every time round the ring is shorter by one.
  while (--budget_ >= 0) {
    const auto ring = mesh_.ring(a, b);
    if (!ring || has_constrained_face(*ring, a, b)) break;
    if (flip_ring(*ring, a, b, ear, guard)) return true;
    if (depth <= 0 || ring->apexes.size() <= 3) break;
    if (!shorten_ring(*ring, a, b, guard, depth)) break;
  }
  mesh_.roll_back(mark);
  return false;
}

bool EdgeRemoval::remove(std::int32_t a, std::int32_t b, const RecoveryGuard& guard, int depth) {
  return remove(a, b, -1, guard, depth);
}

bool EdgeRemoval::remove_face(FaceHandle face, const RecoveryGuard& guard) {
  if (face == no_face || mesh_.is_constrained(face)) return false;
  const auto& complex = mesh_.complex();
  const std::int32_t below = tet_of(face);
  const FaceHandle other = complex.neighbours[at(below)][at(face_of(face))];
  if (other == no_face) return false;
  const Tet& n = complex.nodes[at(below)];
  const auto& f = tet_face_nodes[at(face_of(face))];
  // x, y, z anticlockwise seen from the tip beyond the face.
  const std::array<std::int32_t, 3> x = {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
  const std::int32_t low = n[at(face_of(face))];
  const std::int32_t high = complex.nodes[at(tet_of(other))][at(face_of(other))];
  if (guard.forbids_edge(low, high)) return false;
  std::array<Tet, 3> tets{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t u = x[k], v = x[(k + 1) % 3];
    if (guard.forbids_face(u, low, high)) return false;
    if (mesh_.orient(low, high, u, v) <= 0) {
      return false;
    }
    tets[k] = {low, high, u, v};
  }
  mesh_.replace(std::array{below, tet_of(other)}, tets);
  return true;
}

}  // namespace tetfarm
