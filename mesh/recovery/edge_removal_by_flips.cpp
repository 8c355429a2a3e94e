#include "mesh/recovery/edge_removal_by_flips.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/ring_triangulation.h"

namespace tetfarm {
namespace {

/// Rings up to this are triangulated as a whole, n^3 signs; longer ones are made shorter first.
constexpr std::size_t longest_whole_ring = 8;
/// Longer rings than this are worked off for the outermost edge only.
constexpr std::size_t longest_inner_ring = 20;

/// An apex of a ring between its neighbours.
struct Apex {
  std::int32_t before, self, after;
};

Apex apex_at(const EdgeRing& ring, std::size_t i) {
  const std::size_t n = ring.apexes.size();
  return {ring.apexes[(i + n - 1) % n], ring.apexes[i], ring.apexes[(i + 1) % n]};
}

bool holds(const Apex& apex, std::int32_t node) {
  return apex.before == node || apex.self == node || apex.after == node;
}

/// What of the edge and the faces round it is in the way.
int crossings_inside(const EdgeRing& ring, std::int32_t a, std::int32_t b,
                     const RecoveryGuard& guard) {
  int sum = guard.crossings(a, b);
  for (const std::int32_t apex : ring.apexes) sum += guard.crossings(a, b, apex);
  return sum;
}

}  // namespace

void EdgeRemoval::hold(std::int32_t tet, int by) {
  if (held_.size() <= at(tet)) held_.resize(mesh_.complex().nodes.size(), 0);
  held_[at(tet)] += by;
  TF_CHECK(held_[at(tet)] >= 0);
}

bool EdgeRemoval::is_held(std::int32_t tet) const {
  return at(tet) < held_.size() && held_[at(tet)] > 0;
}

/// Whether its faces may go, and its tets are of no other ring but, for an ear, the two that it
/// shares with the ring round it.
bool EdgeRemoval::is_free(const EdgeRing& ring, const Target& target) const {
  if (mesh_.has_constraint(ring)) return false;
  const auto held = std::count_if(ring.tets.begin(), ring.tets.end(),
                                  [this](std::int32_t t) { return is_held(t); });
  return held <= (target.ear >= 0 ? 2 : 0);
}

bool EdgeRemoval::flip_ring(const EdgeRing& ring, const Target& target,
                            const RecoveryGuard& guard) {
  const auto found = ring_triangulation(mesh_, ring, target.a, target.b, target.ear, guard);
  if (!found) return false;
  const int change = found->crossings - crossings_inside(ring, target.a, target.b, guard);
  // The outermost must be a gain, or flips could go round in circles.
  const bool is_outermost = target.ear < 0;
  if (is_outermost && guard.is_of_something() ? change_ + change >= 0 : change > 0) return false;
  change_ += change;
  last_tets_ = mesh_.replace(ring.tets, tets_of(*found, ring, target.a, target.b));
  return true;
}

/// The apex has left the ring by the last flip, which put one tet in the place of two.
void EdgeRemoval::drop_apex(EdgeRing& ring, std::size_t i, const Target& target) {
  const std::size_t n = ring.apexes.size();
  TF_CHECK(n > 3 && ring.tets.size() == n);
  const std::size_t before = (i + n - 1) % n;
  const Apex apex = apex_at(ring, i);
  const TetComplex& complex = mesh_.complex();
  const auto joined = std::find_if(last_tets_.begin(), last_tets_.end(), [&](std::int32_t t) {
    return complex.local_node(t, target.a) >= 0 && complex.local_node(t, target.b) >= 0 &&
           complex.local_node(t, apex.before) >= 0 && complex.local_node(t, apex.after) >= 0;
  });
  TF_CHECK(joined != last_tets_.end());
  hold(ring.tets[before], -1);
  hold(ring.tets[i], -1);
  hold(*joined, 1);
  ring.tets[before] = *joined;
  ring.tets.erase(ring.tets.begin() + static_cast<std::ptrdiff_t>(i));
  ring.apexes.erase(ring.apexes.begin() + static_cast<std::ptrdiff_t>(i));
}

/// The 2-3 flip of the face between the edge and the apex.
bool EdgeRemoval::clip_apex(EdgeRing& ring, std::size_t i, const Target& target,
                            const RecoveryGuard& guard) {
  const Apex apex = apex_at(ring, i);
  if (holds(apex, target.ear)) return false;
  const auto [e, c, d] = apex;
  const std::int32_t a = target.a, b = target.b;
  if (mesh_.orient(e, c, d, b) <= 0 || mesh_.orient(e, d, c, a) <= 0 ||
      mesh_.orient(a, b, e, d) <= 0) {
    return false;
  }
  const int change = guard.crossings(e, d) + guard.crossings(e, d, a) + guard.crossings(e, d, b) +
                     guard.crossings(e, d, c) - guard.crossings(a, b, c);
  if (change > 0) return false;
  change_ += change;
  const std::size_t n = ring.tets.size();
  const std::array<std::int32_t, 2> old_tets = {ring.tets[(i + n - 1) % n], ring.tets[i]};
  const std::array<Tet, 3> new_tets = {Tet{e, c, d, b}, Tet{e, d, c, a}, Tet{a, b, e, d}};
  last_tets_ = mesh_.replace(old_tets, new_tets);
  drop_apex(ring, i, target);
  return true;
}

bool EdgeRemoval::clip_apexes(EdgeRing& ring, const Target& target, const RecoveryGuard& guard) {
  bool is_shorter = false;
  for (std::size_t i = 0; i < ring.apexes.size() && ring.apexes.size() > 3;) {
    if (clip_apex(ring, i, target, guard)) {
      is_shorter = true;
      if (i > 0) --i;
    } else {
      ++i;
    }
  }
  return is_shorter;
}

/// Removes the edge between the apex and an end that does not see the apex's neighbours.
bool EdgeRemoval::detach_apex(EdgeRing& ring, std::size_t i, const Target& target,
                              const RecoveryGuard& guard, int depth) {
  const Apex apex = apex_at(ring, i);
  if (holds(apex, target.ear)) return false;
  if (mesh_.orient(target.a, target.b, apex.before, apex.after) <= 0) return false;
  const bool is_hidden_from_b = mesh_.orient(apex.before, apex.self, apex.after, target.b) <= 0;
  const bool is_hidden_from_a = mesh_.orient(apex.before, apex.after, apex.self, target.a) <= 0;
  const bool tries_both = is_hidden_from_a == is_hidden_from_b;
  const auto detach = [&](std::int32_t end, std::int32_t other_end) {
    if (!remove_from_within(ring.tets[i], {end, apex.self, other_end}, guard, depth - 1))
      return false;
    drop_apex(ring, i, target);
    return true;
  };
  if ((is_hidden_from_b || tries_both) && detach(target.b, target.a)) return true;
  return (is_hidden_from_a || tries_both) && detach(target.a, target.b);
}

bool EdgeRemoval::detach_an_apex(EdgeRing& ring, const Target& target, const RecoveryGuard& guard,
                                 int depth) {
  for (std::size_t i = 0; i < ring.apexes.size(); ++i) {
    if (detach_apex(ring, i, target, guard, depth)) return true;
  }
  return false;
}

/// Every time round the ring is shorter by one.
bool EdgeRemoval::work_off(EdgeRing& ring, const Target& target, const RecoveryGuard& guard,
                           int depth) {
  while (--budget_ >= 0) {
    if (ring.apexes.size() <= longest_whole_ring && flip_ring(ring, target, guard)) return true;
    if (clip_apexes(ring, target, guard)) continue;
    if (depth <= 0 || ring.apexes.size() <= 3) return false;
    if (!detach_an_apex(ring, target, guard, depth)) return false;
  }
  return false;
}

bool EdgeRemoval::remove_from_within(std::int32_t tet, const Target& target,
                                     const RecoveryGuard& guard, int depth) {
  if (surface_.has_edge(target.a, target.b)) return false;
  auto ring = mesh_.ring_from(tet, target.a, target.b);
  const bool is_outermost = target.ear < 0;
  if (!ring || (!is_outermost && ring->apexes.size() > longest_inner_ring) ||
      !is_free(*ring, target)) {
    return false;
  }
  const std::size_t mark = mesh_.mark();
  const int change = change_;
  for (const std::int32_t t : ring->tets) hold(t, 1);
  const bool is_gone = work_off(*ring, target, guard, depth);
  for (const std::int32_t t : ring->tets) hold(t, -1);
  if (!is_gone && !(is_outermost && guard.is_of_something())) {
    mesh_.roll_back(mark);
    change_ = change;
  }
  return is_gone;
}

bool EdgeRemoval::remove(std::int32_t tet, std::int32_t a, std::int32_t b,
                         const RecoveryGuard& guard, int depth) {
  change_ = 0;
  return remove_from_within(tet, {a, b, -1}, guard, depth);
}

bool EdgeRemoval::remove(std::int32_t a, std::int32_t b, const RecoveryGuard& guard, int depth) {
  const std::int32_t tet = mesh_.find_edge(a, b);
  return tet >= 0 && remove(tet, a, b, guard, depth);
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
  if (guard.crossings(low, high) > 0) return false;
  std::array<Tet, 3> tets{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t u = x[k], v = x[(k + 1) % 3];
    if (mesh_.orient(low, high, u, v) <= 0 || guard.crossings(u, low, high) > 0) return false;
    tets[k] = {low, high, u, v};
  }
  mesh_.replace(std::array{below, tet_of(other)}, tets);
  return true;
}

}  // namespace tetfarm
