#include "mesh/recovery/ring_triangulation.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// The polygon of the ring without the ear, cut by dynamic programming: cut_[i][j] is the third
/// corner of the triangle on the chord (i, j) for the polygon i..j.
class RingSearch {
 public:
  RingSearch(const LocalRemeshing& mesh, std::vector<std::int32_t> corners, std::int32_t a,
             std::int32_t b, const RecoveryGuard& guard)
      : mesh_(mesh), corners_(std::move(corners)), a_(a), b_(b), guard_(guard) {}

  bool sees_triangle(std::size_t i, std::size_t j, std::size_t k) const {
    const std::int32_t p = corners_[i], q = corners_[j], r = corners_[k];
    return mesh_.orient(p, q, r, b_) > 0 && mesh_.orient(p, r, q, a_) > 0;
  }
  int triangle_crossings(std::size_t i, std::size_t j, std::size_t k) const {
    return guard_.crossings(corners_[i], corners_[j], corners_[k]);
  }
  int chord_crossings(std::size_t i, std::size_t j) const {
    const std::int32_t p = corners_[i], q = corners_[j];
    return guard_.crossings(p, q) + guard_.crossings(p, q, a_) + guard_.crossings(p, q, b_);
  }

  /// The fewest crossings, or `never`.
  int run() {
    const std::size_t n = corners_.size();
    third_.assign(n * n, none);
    crossings_.assign(n * n, never);
    for (std::size_t i = 0; i + 1 < n; ++i) crossings_[i * n + i + 1] = 0;
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        int least = never;
        for (std::size_t k = i + 1; k < j; ++k) {
          const int parts = crossings_[i * n + k] + crossings_[k * n + j];
          if (parts >= least || !sees_triangle(i, k, j)) continue;
          const int whole = parts + triangle_crossings(i, k, j);
          if (whole >= least) continue;
          least = whole;
          third_[i * n + j] = k;
        }
        if (least < never && span + 1 < n) least += chord_crossings(i, j);
        crossings_[i * n + j] = least;
      }
    }
    return n < 3 ? 0 : crossings_[n - 1];
  }

  void collect(std::size_t i, std::size_t j, std::vector<std::array<std::size_t, 3>>& out) const {
    if (j <= i + 1) return;
    const std::size_t k = third_[i * corners_.size() + j];
    out.push_back({i, k, j});
    collect(i, k, out);
    collect(k, j, out);
  }

  static constexpr int never = 1 << 20;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const LocalRemeshing& mesh_;
  std::vector<std::int32_t> corners_;
  std::int32_t a_;
  std::int32_t b_;
  const RecoveryGuard& guard_;
  std::vector<std::size_t> third_;
  std::vector<int> crossings_;
};

}  // namespace

std::vector<Tet> tets_of(const RingTriangulation& triangulation, const EdgeRing& ring,
                         std::int32_t a, std::int32_t b) {
  std::vector<Tet> tets;
  for (const auto& [i, j, k] : triangulation.triangles) {
    const std::int32_t p = ring.apexes[i], q = ring.apexes[j], r = ring.apexes[k];
    tets.push_back({p, q, r, b});
    tets.push_back({p, r, q, a});
  }
  return tets;
}

std::optional<RingTriangulation> ring_triangulation(const LocalRemeshing& mesh,
                                                    const EdgeRing& ring, std::int32_t a,
                                                    std::int32_t b, std::int32_t ear,
                                                    const RecoveryGuard& guard) {
  const std::size_t n = ring.apexes.size();
  if (n < 3 || n > longest_ring) return std::nullopt;
  RingTriangulation result;
  std::vector<std::int32_t> corners = ring.apexes;
  std::vector<std::size_t> position(n);
  for (std::size_t i = 0; i < n; ++i) position[i] = i;
  if (ear >= 0) {
    const auto it = std::find(corners.begin(), corners.end(), ear);
    if (it == corners.end()) return std::nullopt;
    const auto e = static_cast<std::size_t>(it - corners.begin());
    std::array<std::size_t, 3> triangle = {(e + n - 1) % n, e, (e + 1) % n};
    const RingSearch whole(mesh, corners, a, b, guard);
    if (!whole.sees_triangle(triangle[0], triangle[1], triangle[2])) return std::nullopt;
    result.crossings += whole.triangle_crossings(triangle[0], triangle[1], triangle[2]);
    if (n > 3) result.crossings += whole.chord_crossings(triangle[0], triangle[2]);
    result.triangles.push_back(triangle);
    corners.erase(it);
    position.erase(position.begin() + static_cast<std::ptrdiff_t>(e));
  }
  if (corners.size() >= 3) {
    RingSearch search(mesh, corners, a, b, guard);
    const int least = search.run();
    if (least >= RingSearch::never) return std::nullopt;
    result.crossings += least;
    std::vector<std::array<std::size_t, 3>> rest;
    search.collect(0, corners.size() - 1, rest);
    for (const auto& [i, k, j] : rest)
      result.triangles.push_back({position[i], position[k], position[j]});
  }
  TF_CHECK(result.triangles.size() == n - 2);
  return result;
}

}  // namespace tetfarm
