#include "mesh/cosmetics/edge_removal.h"

#include <algorithm>

#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

constexpr std::size_t most_ring = 10;

/// Of the ring's nodes first…last: the best worst goodness, and the apex on first-last that gives
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
        for (const Tet& tet : tets_over(ring, i, k, j)) {
          if (worst <= best.worst || worst <= least) break;
          worst = std::min(worst, goodness(work.complex, tet));
        }
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
  for (const Tet& tet : tets_over(ring, i, k, j)) tets.push_back(tet);
  collect(parts, ring, i, k, tets);
  collect(parts, ring, k, j, tets);
}

}  // namespace

std::optional<Replacement> find_edge_removal(const WorkMesh& work, std::int32_t t, int i, int j,
                                             double beat) {
  std::optional<EdgeRing> ring = ring_of_edge(work, t, i, j, most_ring);
  if (!ring || ring->tets.size() < 3) return std::nullopt;
  const double before = worst_of(work, ring->tets);
  const Parts parts = best_parts(work, *ring, std::max({before, beat, 0.0}));
  const double after = parts[0][ring->nodes.size() - 1].worst;
  if (after <= beat || !is_worth(before, after)) return std::nullopt;
  Replacement replacement{std::move(ring->tets), {}, before, after, std::nullopt};
  collect(parts, *ring, 0, ring->nodes.size() - 1, replacement.new_tets);
  return replacement;
}

}  // namespace tetfarm::cosmetics
