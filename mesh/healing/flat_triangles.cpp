#include "mesh/healing/flat_triangles.h"

#include <algorithm>
#include <span>

namespace tetfarm {
namespace {

constexpr int most_flat_passes = 100;

/// The place of the vertex opposite to the longest side.
std::size_t corner_on_side(const TrianglePoints& c) {
  std::size_t best = 0;
  double longest2 = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side2 = norm2(c[(k + 2) % 3] - c[(k + 1) % 3]);
    if (side2 > longest2) {
      longest2 = side2;
      best = k;
    }
  }
  return best;
}

std::vector<std::size_t> flat_triangles(const SurfaceMesh& surface) {
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_degenerate(points_of(surface, t))) flat.push_back(t);
  }
  return flat;
}

/// 1 for each triangle that may be on an edge of one of these.
std::vector<char> beside(const SurfaceMesh& surface, std::span<const std::size_t> flat) {
  std::vector<char> is_corner(surface.vertices.size(), 0);
  for (const std::size_t t : flat) {
    for (const std::int32_t v : surface.triangles[t]) is_corner[static_cast<std::size_t>(v)] = 1;
  }
  std::vector<char> sieve;
  sieve.reserve(surface.triangles.size());
  for (const Triangle& nodes : surface.triangles) {
    const auto shared = std::ranges::count_if(
        nodes, [&](std::int32_t v) { return is_corner[static_cast<std::size_t>(v)] != 0; });
    sieve.push_back(shared >= 2 ? 1 : 0);
  }
  return sieve;
}

/// One pass: no triangle is touched twice. Only the edges round flat triangles are sorted, as a
/// large surface takes many passes for the few that it has.
class FlatPass {
 public:
  explicit FlatPass(HealingWork& work)
      : work_(work),
        flat_(flat_triangles(work.surface)),
        uses_(edge_uses(work.surface.triangles, beside(work.surface, flat_))),
        is_gone_(work.surface.triangles.size(), 0) {}

  std::int64_t run() {
    std::int64_t removed = 0;
    for (const std::size_t t : flat_) {
      if (is_gone_[t] == 0 && remove(t)) ++removed;
    }
    is_gone_.resize(work_.surface.triangles.size(), 0);
    remove_triangles(work_.surface, is_gone_);
    return removed;
  }

 private:
  bool remove(std::size_t t) {
    const Triangle nodes = work_.surface.triangles[t];
    const TrianglePoints points = points_of(work_.surface, t);
    const std::size_t k = corner_on_side(points);
    const std::int32_t between = nodes[k];
    const auto beyond = uses_of_edge(uses_, nodes[(k + 1) % 3], nodes[(k + 2) % 3]);
    const bool may = std::ranges::none_of(beyond, [&](const EdgeUse& use) {
      const Triangle& other = work_.surface.triangles[static_cast<std::size_t>(use.triangle)];
      const bool is_other = static_cast<std::size_t>(use.triangle) != t;
      const bool has_it = std::ranges::find(other, between) != other.end();
      return is_other && (has_it || is_gone_[static_cast<std::size_t>(use.triangle)] != 0);
    });
    if (!may) return false;
    for (const EdgeUse& use : beyond) {
      const auto other = static_cast<std::size_t>(use.triangle);
      if (other != t) divide(other, use, between);
    }
    is_gone_[t] = 1;
    work_.acts.push_back({HealKind::flat, points[k], {points}});
    return true;
  }

  /// Puts two triangles in place of one, with `between` on the side.
  void divide(std::size_t t, const EdgeUse& side, std::int32_t between) {
    const Triangle nodes = work_.surface.triangles[t];
    const std::int32_t patch = patch_of(work_.surface, t);
    for (const std::int32_t end : {side.low, side.high}) {
      Triangle half = nodes;
      *std::ranges::find(half, end) = between;
      add_triangle(work_.surface, half, patch);
    }
    is_gone_[t] = 1;
  }

  HealingWork& work_;
  std::vector<std::size_t> flat_;
  std::vector<EdgeUse> uses_;
  std::vector<char> is_gone_;
};

}  // namespace

std::int64_t remove_flat_triangles(HealingWork& work) {
  std::int64_t removed = 0;
  for (int pass = 0; pass < most_flat_passes; ++pass) {
    const std::int64_t now = FlatPass(work).run();
    if (now == 0) break;
    removed += now;
  }
  return removed;
}

}  // namespace tetfarm
