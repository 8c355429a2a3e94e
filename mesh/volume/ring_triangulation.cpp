#include "mesh/volume/ring_triangulation.h"

#include <algorithm>

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
    return mesh_.orient(p, q, r, b_) > 0 && mesh_.orient(p, r, q, a_) > 0 &&
           !guard_.forbids_face(p, q, r);
  }

  bool may_have_chord(std::size_t i, std::size_t j) const {
    const std::int32_t p = corners_[i], q = corners_[j];
    return !guard_.forbids_edge(p, q) && !guard_.forbids_face(p, q, a_) &&
           !guard_.forbids_face(p, q, b_);
  }

  bool run() {
    const std::size_t n = corners_.size();
    third_.assign(n * n, none);
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        const bool is_chord = span + 1 < n;
        if (is_chord && !may_have_chord(i, j)) continue;
        for (std::size_t k = i + 1; k < j; ++k) {
          if (!is_cut(i, k) || !is_cut(k, j) || !sees_triangle(i, k, j)) continue;
          third_[i * n + j] = k;
          break;
        }
      }
    }
    return n < 3 || third_[n - 1] != none;
  }

  void collect(std::size_t i, std::size_t j, std::vector<std::array<std::size_t, 3>>& out) const {
    if (j <= i + 1) return;
    const std::size_t k = third_[i * corners_.size() + j];
    out.push_back({i, k, j});
    collect(i, k, out);
    collect(k, j, out);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  bool is_cut(std::size_t i, std::size_t j) const {
    return j == i + 1 || third_[i * corners_.size() + j] != none;
  }

  const LocalRemeshing& mesh_;
  std::vector<std::int32_t> corners_;
  std::int32_t a_;
  std::int32_t b_;
  const RecoveryGuard& guard_;
  std::vector<std::size_t> third_;
};

}  // namespace

std::optional<std::vector<std::array<std::size_t, 3>>> ring_triangulation(
    const LocalRemeshing& mesh, const EdgeRing& ring, std::int32_t a, std::int32_t b,
    std::int32_t ear, const RecoveryGuard& guard) {
  const std::size_t n = ring.apexes.size();
  if (n < 3 || n > longest_ring) return std::nullopt;
  std::vector<std::array<std::size_t, 3>> triangles;
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
    if (n > 3 && !whole.may_have_chord(triangle[0], triangle[2])) return std::nullopt;
    triangles.push_back(triangle);
    corners.erase(it);
    position.erase(position.begin() + static_cast<std::ptrdiff_t>(e));
  }
  if (corners.size() >= 3) {
    RingSearch search(mesh, corners, a, b, guard);
    if (!search.run()) return std::nullopt;
    std::vector<std::array<std::size_t, 3>> rest;
    search.collect(0, corners.size() - 1, rest);
    for (const auto& [i, k, j] : rest) triangles.push_back({position[i], position[k], position[j]});
  }
  return triangles;
}

}  // namespace tetfarm
