#include "mesh/cosmetics/edge_removal.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

constexpr std::size_t most_ring = 10;

/// Of the ring's nodes first…last: the best worst quality, and the apex on first-last that gives
/// it.
struct Part {
  double worst = 1;
  std::size_t apex = 0;
};
using Parts = std::array<std::array<Part, most_ring>, most_ring>;

/// The two tets over a triangle of the ring.
std::array<Tet, 2> tets_over(const EdgeRing& ring, std::size_t i, std::size_t k, std::size_t j) {
  const std::int32_t a = ring.nodes[i];
  const std::int32_t b = ring.nodes[k];
  const std::int32_t c = ring.nodes[j];
  return {Tet{a, b, c, ring.to}, Tet{a, c, b, ring.from}};
}

double quality_over(const WorkMesh& work, const EdgeRing& ring, std::size_t i, std::size_t k,
                    std::size_t j) {
  return quality_of_two(work.point(ring.nodes[i]), work.point(ring.nodes[k]),
                        work.point(ring.nodes[j]), work.point(ring.to), work.point(ring.from));
}

/// The best triangulations of all runs of the ring; runs that cannot beat `least` come out as 0.
Parts best_parts(const WorkMesh& work, const EdgeRing& ring, double least) {
  Parts parts{};
  const std::size_t n = ring.nodes.size();
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      Part best{0, 0};
      for (std::size_t k = i + 1; k < j; ++k) {
        double worst = std::min(parts[i][k].worst, parts[k][j].worst);
        if (worst <= best.worst || worst <= least) continue;
        worst = std::min(worst, quality_over(work, ring, i, k, j));
        if (worst > best.worst && worst > least) best = {worst, k};
      }
      parts[i][j] = best;
    }
  }
  return parts;
}

void collect(const Parts& parts, const EdgeRing& ring, std::size_t i, std::size_t j,
             std::vector<Tet>& tets) {
  if (j - i < 2) return;
  const std::size_t k = parts[i][j].apex;
  TF_CHECK(k > i && k < j);
  for (const Tet& tet : tets_over(ring, i, k, j)) tets.push_back(tet);
  collect(parts, ring, i, k, tets);
  collect(parts, ring, k, j, tets);
}

}  // namespace

std::array<std::array<int, 2>, 6> edges_by_angle(const WorkMesh& work, std::int32_t t) {
  const Tet& tet = work.tet(t);
  std::array<Vec3, 4> normals;
  std::array<double, 4> areas;
  for (std::size_t face = 0; face < 4; ++face) {
    const auto& local = tet_face_nodes[face];
    const auto corner = [&](std::size_t i) -> const Vec3& {
      return work.point(tet[static_cast<std::size_t>(local[i])]);
    };
    normals[face] = cross(corner(1) - corner(0), corner(2) - corner(0));
    areas[face] = norm2(normals[face]);
  }
  // Edge (i, j) lies between the faces opposite to the other two nodes; the pairs are in reverse.
  static constexpr std::array<std::array<int, 2>, 6> edges = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  struct Candidate {
    double cosine2;  ///< with its sign
    std::array<int, 2> edge;
  };
  std::array<Candidate, 6> candidates;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto p = static_cast<std::size_t>(edges[5 - e][0]);
    const auto q = static_cast<std::size_t>(edges[5 - e][1]);
    const double product = -dot(normals[p], normals[q]);
    const double area = areas[p] * areas[q];
    candidates[e] = {area > 0 ? product * std::fabs(product) / area : 0, edges[e]};
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::cosine2);
  std::array<std::array<int, 2>, 6> sorted;
  for (std::size_t e = 0; e < 6; ++e) sorted[e] = candidates[e].edge;
  return sorted;
}

std::optional<Replacement> find_edge_removal(const WorkMesh& work, std::int32_t t, int i, int j,
                                             double beat) {
  std::optional<EdgeRing> ring = ring_of_edge(work, t, i, j, most_ring);
  if (!ring || ring->tets.size() < 3) return std::nullopt;
  const double before = worst_of(work, ring->tets);
  const Parts parts = best_parts(work, *ring, std::max({before, beat, 0.0}));
  const double after = parts[0][ring->nodes.size() - 1].worst;
  if (after <= beat || !is_worth(before, after, work.gain)) return std::nullopt;
  Replacement replacement{std::move(ring->tets), {}, before, after, std::nullopt};
  collect(parts, *ring, 0, ring->nodes.size() - 1, replacement.new_tets);
  TF_CHECK(replacement.new_tets.size() == 2 * (ring->nodes.size() - 2));
  return replacement;
}

}  // namespace tetfarm::cosmetics
