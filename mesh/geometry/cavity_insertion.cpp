#include "mesh/geometry/cavity_insertion.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

constexpr std::size_t table_side = 128;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

bool sphere_holds(const TetComplex& complex, std::int32_t tet, std::int32_t node) {
  const Tet& t = complex.nodes[at(tet)];
  const auto& p = complex.points;
  return in_perturbed_sphere(p[at(t[0])], p[at(t[1])], p[at(t[2])], p[at(t[3])], p[at(node)],
                             {t[0], t[1], t[2], t[3], node});
}

std::array<std::int32_t, 3> face_nodes(const TetComplex& complex, FaceHandle face) {
  const Tet& t = complex.nodes[at(tet_of(face))];
  const auto& f = tet_face_nodes[at(face_of(face))];
  return {t[at(f[0])], t[at(f[1])], t[at(f[2])]};
}

}  // namespace

CavityInsertion::CavityInsertion(TetComplex& complex, std::vector<std::uint8_t>* constrained)
    : complex_(complex), constrained_(constrained), edge_table_(table_side * table_side) {}

Location CavityInsertion::locate(const Vec3& point, std::int32_t start) const {
  std::int32_t tet = start;
  FaceHandle entry = no_face;
  // A walk in a mesh that is not Delaunay may run in circles; turning the first face tried breaks
  // them.
  std::uint32_t turn = 0;
  const std::size_t most_steps = complex_.nodes.size() + 1000;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const Tet& t = complex_.nodes[at(tet)];
    for (const std::int32_t v : t) {
      if (complex_.points[at(v)] == point) return {tet, v};
    }
    FaceHandle exit = no_face;
    bool is_outside = false;
    turn = turn * 1664525U + 1013904223U;
    for (int k = 0; k < 4; ++k) {
      const int i = (k + static_cast<int>(turn >> 30)) & 3;
      if (face_handle(tet, i) == entry) continue;
      const auto [a, b, c] = face_nodes(complex_, face_handle(tet, i));
      if (orient3d(complex_.points[at(a)], complex_.points[at(b)], complex_.points[at(c)], point) <=
          0) {
        continue;
      }
      exit = complex_.neighbours[at(tet)][at(i)];
      if (exit == no_face) {
        is_outside = true;
        continue;
      }
      break;
    }
    if (exit == no_face) return is_outside ? Location{} : Location{tet, -1};
    entry = exit;
    tet = tet_of(exit);
  }
  return {};
}

bool CavityInsertion::is_constrained(FaceHandle face) const {
  return constrained_ != nullptr && ((*constrained_)[at(tet_of(face))] >> face_of(face) & 1) != 0;
}

void CavityInsertion::grow(std::int32_t tet) {
  cavity_.clear();
  hull_.clear();
  mark_[at(tet)] = round_;
  cavity_.push_back(tet);
  for (std::size_t head = 0; head < cavity_.size(); ++head) {
    const std::int32_t t = cavity_[head];
    for (int i = 0; i < 4; ++i) {
      const FaceHandle other = complex_.neighbours[at(t)][at(i)];
      const FaceHandle here = face_handle(t, i);
      if (other == no_face || is_constrained(here)) {
        hull_.push_back(here);
        continue;
      }
      const std::int32_t next = tet_of(other);
      if (mark_[at(next)] == round_) continue;
      // -round_ marks a tet already found outside the sphere.
      if (mark_[at(next)] != -round_ && sphere_holds(complex_, next, node_)) {
        mark_[at(next)] = round_;
        cavity_.push_back(next);
      } else {
        mark_[at(next)] = -round_;
        hull_.push_back(here);
      }
    }
  }
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
    const auto [a, b, c] = face_nodes(complex_, face);
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
  ++round_;
  node_ = node;
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

void CavityInsertion::glue_star(const std::vector<std::int32_t>& star) {
  node_round_.resize(complex_.points.size(), 0);
  local_.resize(complex_.points.size());
  std::int32_t locals = 0;
  // Base face of a star tet (f0, f2, f1, p): the directed hull edges, and the face of the tet on
  // each.
  constexpr std::array<std::array<int, 3>, 3> edge = {{{0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const std::int32_t t : star) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t v = complex_.nodes[at(t)][k];
      if (node_round_[at(v)] == round_) continue;
      node_round_[at(v)] = round_;
      local_[at(v)] = locals++;
    }
  }
  const auto side = static_cast<std::size_t>(locals);
  if (edge_table_.size() < side * side) edge_table_.resize(side * side);
  const auto entry = [&](std::int32_t u, std::int32_t v) -> FaceHandle& {
    return edge_table_[at(local_[at(u)]) * side + at(local_[at(v)])];
  };
  for (const std::int32_t t : star) {
    const Tet& n = complex_.nodes[at(t)];
    for (const auto& [from, to, face] : edge) {
      entry(n[at(from)], n[at(to)]) = face_handle(t, face);
    }
  }
  for (const std::int32_t t : star) {
    const Tet& n = complex_.nodes[at(t)];
    for (const auto& [from, to, face] : edge) {
      complex_.neighbours[at(t)][at(face)] = entry(n[at(to)], n[at(from)]);
    }
  }
}

std::int32_t CavityInsertion::fill() {
  bases_.clear();
  for (const FaceHandle face : hull_) {
    bases_.push_back({face_nodes(complex_, face),
                      complex_.neighbours[at(tet_of(face))][at(face_of(face))],
                      is_constrained(face)});
  }
  for (const std::int32_t t : cavity_) complex_.kill_tet(t);
  star_.clear();
  for (const Base& base : bases_) {
    const std::int32_t t = complex_.new_tet();
    const auto& [a, b, c] = base.nodes;
    complex_.nodes[at(t)] = {a, c, b, node_};
    for (const std::int32_t v : {a, b, c}) complex_.node2tet[at(v)] = t;
    star_.push_back(t);
  }
  complex_.node2tet.resize(complex_.points.size(), -1);
  complex_.node2tet[at(node_)] = star_.front();
  mark_.resize(complex_.nodes.size(), 0);
  if (constrained_ != nullptr) constrained_->resize(complex_.nodes.size(), 0);
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const std::int32_t t = star_[i];
    mark_[at(t)] = 0;
    if (constrained_ != nullptr) (*constrained_)[at(t)] = bases_[i].constrained ? 8 : 0;
    complex_.neighbours[at(t)][3] = bases_[i].outside;
    if (bases_[i].outside != no_face) {
      complex_.neighbours[at(tet_of(bases_[i].outside))][at(face_of(bases_[i].outside))] =
          face_handle(t, 3);
    }
  }
  glue_star(star_);
  return star_.front();
}

}  // namespace tetfarm
