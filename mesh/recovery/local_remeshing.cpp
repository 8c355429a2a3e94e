#include "mesh/recovery/local_remeshing.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/sorted_face.h"
#include "mesh/core/tet_replacement.h"

namespace tetfarm {

LocalRemeshing::LocalRemeshing(TetComplex& complex, std::vector<std::uint8_t>& constrained)
    : complex_(complex),
      constrained_(constrained),
      first_fine_(static_cast<std::int32_t>(complex.points.size())) {
  constrained_.resize(complex_.nodes.size(), 0);
}

void LocalRemeshing::save(std::int32_t tet) {
  journal_.push_back({Entry::Kind::contents, constrained_[at(tet)], tet, complex_.nodes[at(tet)],
                      complex_.neighbours[at(tet)]});
}

std::int32_t LocalRemeshing::add_point(const FinePoint& point) {
  const auto v = static_cast<std::int32_t>(complex_.points.size());
  complex_.points.push_back(point.high);
  complex_.node2tet.push_back(-1);
  low_.push_back(point.low);
  journal_.push_back({Entry::Kind::point, 0, v, {}, {}});
  return v;
}

std::int32_t LocalRemeshing::add_point_on(std::span<const std::int32_t> corners,
                                          const FinePoint& point) {
  TF_CHECK(corners.size() == 2 || corners.size() == 3);
  const std::int32_t v = add_point(point);
  flats_.add(v, corners);
  return v;
}

void LocalRemeshing::move_point(std::int32_t v, const FinePoint& to) {
  TF_CHECK(v >= first_fine_);
  flats_.remove(v);
  complex_.points[at(v)] = to.high;
  low_[at(v - first_fine_)] = to.low;
}

void LocalRemeshing::roll_back(std::size_t mark) {
  TF_CHECK(mark <= journal_.size());
  const auto point_nodes_here = [this](std::int32_t tet) {
    for (const std::int32_t v : complex_.nodes[at(tet)]) complex_.node2tet[at(v)] = tet;
  };
  while (journal_.size() > mark) {
    const Entry entry = journal_.back();
    journal_.pop_back();
    switch (entry.kind) {
      case Entry::Kind::point:
        complex_.points.pop_back();
        complex_.node2tet.pop_back();
        low_.pop_back();
        flats_.remove(entry.tet);
        break;
      case Entry::Kind::reused:
        complex_.kill_tet(entry.tet);
        break;
      case Entry::Kind::appended:
        complex_.nodes.pop_back();
        complex_.neighbours.pop_back();
        constrained_.pop_back();
        break;
      case Entry::Kind::killed:
        TF_CHECK(complex_.free_tets.back() == entry.tet);
        complex_.free_tets.pop_back();
        [[fallthrough]];
      case Entry::Kind::contents:
        complex_.nodes[at(entry.tet)] = entry.nodes;
        complex_.neighbours[at(entry.tet)] = entry.neighbours;
        constrained_[at(entry.tet)] = entry.constrained;
        point_nodes_here(entry.tet);
        break;
    }
  }
}

void LocalRemeshing::save_old(std::int32_t tet) {
  save(tet);
  journal_.back().kind = Entry::Kind::killed;
}

std::vector<std::int32_t> LocalRemeshing::replace(std::span<const std::int32_t> old_tets,
                                                  std::span<const Tet> new_tets) {
  marks_.make_room(complex_.nodes.size());
  const std::vector<OpenFace> faces = open_faces(complex_, old_tets, new_tets, marks_);
  TF_CHECK(are_pairs(faces));
  // Constraints are known from beyond the cavity, but for faces on the outside of the complex.
  std::vector<std::array<std::int32_t, 3>> constrained_outside;
  for (const std::int32_t t : old_tets) {
    for (int face = 0; face < 4; ++face) {
      if (complex_.neighbours[at(t)][at(face)] != no_face) continue;
      if (!is_constrained(face_handle(t, face))) continue;
      constrained_outside.push_back(sorted_face(complex_.nodes[at(t)], face));
    }
    save_old(t);
  }
  const auto was_constrained = [&](const OpenFace& face) {
    if (face.handle != no_face) return is_constrained(face.handle);
    return std::find(constrained_outside.begin(), constrained_outside.end(), face.nodes) !=
           constrained_outside.end();
  };
  const std::size_t size = complex_.nodes.size();
  std::vector<std::int32_t> tets = exchange_tets(complex_, old_tets, new_tets);
  constrained_.resize(complex_.nodes.size(), 0);
  for (const std::int32_t t : tets) {
    constrained_[at(t)] = 0;
    const auto kind = at(t) < size ? Entry::Kind::reused : Entry::Kind::appended;
    journal_.push_back({kind, 0, t, {}, {}});
  }
  for (const OpenFace& face : faces) {
    if (face.is_outer && face.handle != no_face) save(tet_of(face.handle));
  }
  glue_pairs(complex_, faces, tets);
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    if (!faces[i].is_outer || !was_constrained(faces[i])) continue;
    const FaceHandle here = face_in_complex(faces[i + 1], tets);
    std::uint8_t& bits = constrained_[at(tet_of(here))];
    bits = static_cast<std::uint8_t>(bits | 1 << face_of(here));
  }
  return tets;
}

std::vector<std::int32_t> LocalRemeshing::star(std::int32_t node) const {
  std::vector<std::int32_t> tets;
  const std::int32_t first = complex_.node2tet[at(node)];
  if (first < 0) return tets;
  marks_.make_room(complex_.nodes.size());
  marks_.clear();
  tets.push_back(first);
  marks_.add(first);
  for (std::size_t head = 0; head < tets.size(); ++head) {
    const std::int32_t t = tets[head];
    const int own = complex_.local_node(t, node);
    for (int i = 0; i < 4; ++i) {
      const FaceHandle other = complex_.neighbours[at(t)][at(i)];
      if (i == own || other == no_face || marks_.has(tet_of(other))) continue;
      marks_.add(tet_of(other));
      tets.push_back(tet_of(other));
    }
  }
  return tets;
}

std::int32_t LocalRemeshing::find_edge(std::int32_t a, std::int32_t b) const {
  for (const std::int32_t t : star(a)) {
    if (complex_.local_node(t, b) >= 0) return t;
  }
  return -1;
}

std::optional<EdgeRing> LocalRemeshing::ring(std::int32_t a, std::int32_t b) const {
  const std::int32_t first = find_edge(a, b);
  if (first < 0) return std::nullopt;
  return ring_from(first, a, b);
}

std::optional<EdgeRing> LocalRemeshing::ring_from(std::int32_t first, std::int32_t a,
                                                  std::int32_t b) const {
  // p and q so that (a, b, p, q) is positive.
  constexpr std::array<std::array<std::array<int, 2>, 4>, 4> rest = {{
      {{{-1, -1}, {2, 3}, {3, 1}, {1, 2}}},
      {{{3, 2}, {-1, -1}, {0, 3}, {2, 0}}},
      {{{1, 3}, {3, 0}, {-1, -1}, {0, 1}}},
      {{{2, 1}, {0, 2}, {1, 0}, {-1, -1}}},
  }};
  EdgeRing ring;
  std::int32_t t = first;
  do {
    const int i = complex_.local_node(t, a);
    const int j = complex_.local_node(t, b);
    const auto& [p, q] = rest[at(i)][at(j)];
    ring.tets.push_back(t);
    ring.apexes.push_back(complex_.nodes[at(t)][at(p)]);
    const FaceHandle next = complex_.neighbours[at(t)][at(p)];
    if (next == no_face) return std::nullopt;
    t = tet_of(next);
  } while (t != first);
  return ring;
}

FaceHandle LocalRemeshing::find_face(std::int32_t a, std::int32_t b, std::int32_t c) const {
  for (const std::int32_t t : star(a)) {
    if (complex_.local_node(t, b) < 0 || complex_.local_node(t, c) < 0) continue;
    const Tet& n = complex_.nodes[at(t)];
    for (int i = 0; i < 4; ++i) {
      const std::int32_t v = n[at(i)];
      if (v != a && v != b && v != c) return face_handle(t, i);
    }
  }
  return no_face;
}

bool LocalRemeshing::has_constraint(const EdgeRing& ring) const {
  const std::size_t n = ring.tets.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t t = ring.tets[i];
    if (is_constrained(face_handle(t, complex_.local_node(t, ring.apexes[(i + 1) % n])))) {
      return true;
    }
  }
  return false;
}

void LocalRemeshing::constrain(FaceHandle face, bool on) {
  const auto set = [this, on](FaceHandle f) {
    if (f == no_face) return;
    std::uint8_t& bits = constrained_[at(tet_of(f))];
    const int bit = 1 << face_of(f);
    bits = static_cast<std::uint8_t>(on ? bits | bit : bits & ~bit);
  };
  set(face);
  set(complex_.neighbours[at(tet_of(face))][at(face_of(face))]);
}

}  // namespace tetfarm
