#include "mesh/geometry/cavity_insertion.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/sphere_filter.h"

namespace tetfarm {
namespace {

/// Room for so many tets and hull faces; larger cavities make more.
constexpr std::size_t usual_cavity = 64;
/// Nodes of a hull whose edges are looked up in a table of all pairs: 4 MB.
constexpr std::size_t largest_edge_table = 1024;

}  // namespace

CavityInsertion::CavityInsertion(TetComplex& complex, std::vector<std::uint8_t>* constrained,
                                 std::span<const std::int32_t> ids)
    : complex_(complex), constrained_(constrained), ids_(ids) {
  TF_CHECK(ids.empty() || ids.size() >= complex.points.size());
}

bool CavityInsertion::is_constrained(FaceHandle face) const {
  return constrained_ != nullptr && ((*constrained_)[at(tet_of(face))] >> face_of(face) & 1) != 0;
}

[[gnu::always_inline]] inline bool CavityInsertion::sphere_holds(std::int32_t tet) const {
  const Tet& t = complex_.nodes[at(tet)];
  const auto& p = complex_.points;
  const Vec3& a = p[at(t[0])];
  const Vec3& b = p[at(t[1])];
  const Vec3& c = p[at(t[2])];
  const Vec3& d = p[at(t[3])];
  const FilteredSphere filtered = filtered_insphere(a, b, c, d, point_);
  if (filtered.is_certain) [[likely]]
    return filtered.det > 0;
  const auto id = [this](std::int32_t v) { return ids_.empty() ? v : ids_[at(v)]; };
  return in_perturbed_sphere_exactly(a, b, c, d, point_,
                                     {id(t[0]), id(t[1]), id(t[2]), id(t[3]), id(node_)});
}

void CavityInsertion::grow(std::int32_t tet) {
  const std::int32_t round = round_;
  std::int32_t* const mark = mark_.data();
  const std::array<FaceHandle, 4>* const neighbours = complex_.neighbours.data();
  mark[at(tet)] = round;
  cavity_.resize(usual_cavity);
  hull_.resize(usual_cavity);
  cavity_[0] = tet;
  std::size_t tets = 1;
  std::size_t faces = 0;
  for (std::size_t head = 0; head < tets; ++head) {
    const std::int32_t t = cavity_[head];
    if (cavity_.size() < tets + 4) cavity_.resize(2 * tets);
    if (hull_.size() < faces + 4) hull_.resize(2 * faces);
    // Both lists get what may be added, and keep it or not: whether a sphere holds the point is as
    // good as random, and a branch on it would cost more than the stores.
    for (int i = 0; i < 4; ++i) {
      const FaceHandle other = neighbours[at(t)][at(i)];
      const FaceHandle here = face_handle(t, i);
      hull_[faces] = here;
      if (other == no_face || is_constrained(here)) {
        ++faces;
        continue;
      }
      const std::int32_t next = tet_of(other);
      const std::int32_t before = mark[at(next)];
      if (before == round) continue;
      // -round marks a tet already found outside the sphere.
      const bool joins = before != -round && sphere_holds(next);
      mark[at(next)] = joins ? round : -round;
      cavity_[tets] = next;
      tets += joins ? 1 : 0;
      faces += joins ? 0 : 1;
    }
  }
  cavity_.resize(tets);
  hull_.resize(faces);
}

bool CavityInsertion::drop_enclosed_constraints() {
  bool changed = false;
  for (const FaceHandle face : hull_) {
    if (!is_constrained(face) || !in_cavity(tet_of(face))) continue;
    const FaceHandle other = complex_.neighbours[at(tet_of(face))][at(face_of(face))];
    if (other == no_face || !in_cavity(tet_of(other))) continue;
    const std::int32_t dropped = tet_of(face) == seed_ ? tet_of(other) : tet_of(face);
    mark_[at(dropped)] = -round_;
    changed = true;
  }
  return changed;
}

bool CavityInsertion::shrink_to_visible() {
  bool changed = false;
  const Vec3& point = complex_.points[at(node_)];
  for (const FaceHandle face : hull_) {
    if (!in_cavity(tet_of(face))) continue;
    const auto [a, b, c] = complex_.face_nodes(face);
    if (orient3d(complex_.points[at(a)], complex_.points[at(b)], complex_.points[at(c)], point) <
        0) {
      continue;
    }
    mark_[at(tet_of(face))] = -round_;
    changed = true;
  }
  return changed;
}

void CavityInsertion::rebuild_hull() {
  // What no longer hangs together with the seed through its faces leaves the cavity too.
  const std::int32_t old_round = round_;
  ++round_;
  hull_.clear();
  cavity_.assign(1, seed_);
  mark_[at(seed_)] = round_;
  for (std::size_t head = 0; head < cavity_.size(); ++head) {
    const std::int32_t t = cavity_[head];
    for (int i = 0; i < 4; ++i) {
      const FaceHandle here = face_handle(t, i);
      const FaceHandle other = complex_.neighbours[at(t)][at(i)];
      if (other == no_face || is_constrained(here)) {
        hull_.push_back(here);
      } else if (mark_[at(tet_of(other))] == old_round) {
        mark_[at(tet_of(other))] = round_;
        cavity_.push_back(tet_of(other));
      } else if (mark_[at(tet_of(other))] != round_) {
        hull_.push_back(here);
      }
    }
  }
}

bool CavityInsertion::find_cavity(std::int32_t node, std::int32_t tet) {
  TF_CHECK(round_ < std::numeric_limits<std::int32_t>::max() && complex_.is_live(tet));
  ++round_;
  node_ = node;
  point_ = complex_.points[at(node)];
  seed_ = tet;
  mark_.resize(complex_.nodes.size(), 0);
  if (constrained_ != nullptr) constrained_->resize(complex_.nodes.size(), 0);
  grow(tet);
  if (constrained_ == nullptr) return true;
  // Every pass removes a tet, so this ends.
  for (;;) {
    const bool dropped = drop_enclosed_constraints();
    const bool shrunk = shrink_to_visible();
    if (!dropped && !shrunk) return true;
    if (!in_cavity(seed_)) return false;
    rebuild_hull();
  }
}

void CavityInsertion::gather_bases() {
  bases_.resize(hull_.size());
  hull_nodes_.resize(3 * hull_.size());
  local_.resize(complex_.points.size(), -1);
  std::int32_t nodes = 0;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    Base& base = bases_[i];
    const FaceHandle face = hull_[i];
    base.nodes = complex_.face_nodes(face);
    base.outside = complex_.neighbours[at(tet_of(face))][at(face_of(face))];
    base.constrained = is_constrained(face);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t v = base.nodes[k];
      const std::int32_t known = local_[at(v)];
      const std::int32_t local = known < 0 ? nodes : known;
      hull_nodes_[at(nodes)] = v;
      nodes += known < 0 ? 1 : 0;
      local_[at(v)] = local;
      base.local[k] = local;
    }
  }
  hull_nodes_.resize(at(nodes));
  for (const std::int32_t v : hull_nodes_) local_[at(v)] = -1;
}

void CavityInsertion::take_tets() {
  // As if the cavity were killed and its tets taken back one by one, the last first.
  std::size_t left = cavity_.size();
  for (Base& base : bases_) base.tet = left > 0 ? cavity_[--left] : complex_.new_tet();
  for (std::size_t i = 0; i < left; ++i) complex_.kill_tet(cavity_[i]);
  mark_.resize(complex_.nodes.size(), 0);
  if (constrained_ != nullptr) constrained_->resize(complex_.nodes.size(), 0);
}

// The star tet on the base a b c is (a, c, b, node). Each directed edge of the hull names the face
// of the star on it; the same edge the other way round is that of the neighbour.
template <class FaceOfEdge>
void CavityInsertion::link_star(const FaceOfEdge& face_of_edge) {
  for (const Base& base : bases_) {
    const std::size_t a = at(base.local[0]), b = at(base.local[1]), c = at(base.local[2]);
    complex_.nodes[at(base.tet)] = {base.nodes[0], base.nodes[2], base.nodes[1], node_};
    complex_.neighbours[at(base.tet)] = {face_of_edge(c, b), face_of_edge(b, a), face_of_edge(a, c),
                                         base.outside};
    if (base.outside != no_face) {
      complex_.neighbours[at(tet_of(base.outside))][at(face_of(base.outside))] =
          face_handle(base.tet, 3);
    }
    // The last tet of a node stays.
    for (const std::size_t k : {a, b, c}) hull_tets_[k] = base.tet;
  }
}

void CavityInsertion::glue_star() {
  const std::size_t side = hull_nodes_.size();
  if (side > largest_edge_table) {
    glue_large_star();
    return;
  }
  if (edge_table_.size() < side * side) edge_table_.resize(side * side);
  FaceHandle* const table = edge_table_.data();
  for (const Base& base : bases_) {
    const std::size_t a = at(base.local[0]), b = at(base.local[1]), c = at(base.local[2]);
    table[a * side + b] = face_handle(base.tet, 1);
    table[b * side + c] = face_handle(base.tet, 0);
    table[c * side + a] = face_handle(base.tet, 2);
  }
  link_star([table, side](std::size_t from, std::size_t to) { return table[from * side + to]; });
}

/// The middle of a ball sees all of its surface at once: a table of all pairs of nodes would be
/// gigabytes.
void CavityInsertion::glue_large_star() {
  const std::size_t side = hull_nodes_.size();
  std::vector<std::pair<std::size_t, FaceHandle>> edges;
  edges.reserve(3 * bases_.size());
  for (const Base& base : bases_) {
    const std::size_t a = at(base.local[0]), b = at(base.local[1]), c = at(base.local[2]);
    edges.emplace_back(a * side + b, face_handle(base.tet, 1));
    edges.emplace_back(b * side + c, face_handle(base.tet, 0));
    edges.emplace_back(c * side + a, face_handle(base.tet, 2));
  }
  std::sort(edges.begin(), edges.end());
  link_star([&edges, side](std::size_t from, std::size_t to) {
    const std::pair<std::size_t, FaceHandle> wanted(from * side + to, FaceHandle{});
    return std::lower_bound(edges.begin(), edges.end(), wanted,
                            [](const auto& x, const auto& y) { return x.first < y.first; })
        ->second;
  });
}

std::int32_t CavityInsertion::fill() {
  gather_bases();
  TF_CHECK(hull_.size() >= 4 && hull_nodes_.size() >= 4);
  take_tets();
  TF_CHECK(mark_.size() == complex_.nodes.size());
  hull_tets_.resize(hull_nodes_.size());
  glue_star();
  if (constrained_ != nullptr) {
    for (const Base& base : bases_) (*constrained_)[at(base.tet)] = base.constrained ? 8 : 0;
  }
  for (std::size_t i = 0; i < hull_nodes_.size(); ++i) {
    complex_.node2tet[at(hull_nodes_[i])] = hull_tets_[i];
  }
  complex_.node2tet.resize(complex_.points.size(), -1);
  complex_.node2tet[at(node_)] = bases_.front().tet;
  return bases_.front().tet;
}

}  // namespace tetfarm
