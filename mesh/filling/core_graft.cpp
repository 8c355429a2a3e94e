#include "mesh/filling/core_graft.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// The nodes of a face with the smallest first, in the order of its direction.
using TurnedFace = std::array<std::int32_t, 3>;

TurnedFace turned(const TurnedFace& f) {
  if (f[0] < f[1] && f[0] < f[2]) return f;
  return f[1] < f[2] ? TurnedFace{f[1], f[2], f[0]} : TurnedFace{f[2], f[0], f[1]};
}

/// The hull's faces by their smallest node, as numbers of the complex.
class HullFaces {
 public:
  HullFaces(const LatticeCore& core, std::span<const std::int32_t> numbers, std::size_t points)
      : on_hull_(points, 0) {
    faces_.reserve(core.hull().size());
    for (std::size_t i = 0; i < core.hull().size(); ++i) {
      const CoreHullFace& on_hull = core.hull()[i];
      const auto& local = tet_face_nodes[at(face_of(on_hull.face))];
      TurnedFace face = {on_hull.tet[at(local[0])], on_hull.tet[at(local[1])],
                         on_hull.tet[at(local[2])]};
      for (std::int32_t& v : face) v = numbers[at(v)];
      if (std::min({face[0], face[1], face[2]}) < 0) continue;
      for (const std::int32_t v : face) on_hull_[at(v)] = 1;
      faces_.push_back({turned(face), static_cast<std::int32_t>(i)});
    }
    std::sort(faces_.begin(), faces_.end());
    starts_.assign(points + 1, 0);
    for (const Face& face : faces_) ++starts_[at(face.nodes[0]) + 1];
    for (std::size_t v = 0; v < points; ++v) starts_[v + 1] += starts_[v];
  }

  bool has_node(std::int32_t v) const { return on_hull_[at(v)] != 0; }
  /// The number of the hull face with this direction, or -1.
  std::int32_t find(const TurnedFace& face) const {
    for (std::int32_t i = starts_[at(face[0])]; i < starts_[at(face[0]) + 1]; ++i) {
      if (faces_[at(i)].nodes == face) return faces_[at(i)].number;
    }
    return -1;
  }

 private:
  struct Face {
    TurnedFace nodes;
    std::int32_t number;
    friend auto operator<=>(const Face&, const Face&) = default;
  };
  std::vector<Face> faces_;
  std::vector<std::int32_t> starts_;
  std::vector<std::uint8_t> on_hull_;
};

/// Of each tet: bit i when its face i is one of the hull, seen from within it.
std::vector<std::uint8_t> mark_inner_faces(const TetComplex& complex,
                                           const std::vector<std::uint8_t>& constrained,
                                           const HullFaces& hull, CoreSeat& seat) {
  std::vector<std::uint8_t> inner(complex.nodes.size(), 0);
  TF_CHECK(constrained.size() == complex.nodes.size());
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    const Tet& tet = complex.nodes[t];
    if (tet[0] < 0) continue;
    std::array<int, 4> on_hull;
    int count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      on_hull[i] = hull.has_node(tet[i]) ? 1 : 0;
      count += on_hull[i];
    }
    if (count < 3) continue;
    for (int f = 0; f < 4; ++f) {
      if (count - on_hull[at(f)] < 3) continue;
      const std::int32_t number =
          hull.find(turned(complex.face_nodes(face_handle(static_cast<std::int32_t>(t), f))));
      if (number < 0) continue;
      seat.outer[at(number)] = complex.neighbours[t][at(f)];
      seat.faces[at(number)] =
          (constrained[t] >> f & 1) != 0 ? FaceOfSeat::constrained : FaceOfSeat::free;
      inner[t] |= static_cast<std::uint8_t>(1U << f);
    }
  }
  return inner;
}

}  // namespace

CoreSeat find_core_seat(const TetComplex& complex, const std::vector<std::uint8_t>& constrained,
                        const LatticeCore& core, std::span<const std::int32_t> node_numbers) {
  CoreSeat seat;
  seat.outer.assign(core.hull().size(), no_face);
  seat.faces.assign(core.hull().size(), FaceOfSeat::missing);
  const HullFaces hull(core, node_numbers, complex.points.size());
  const std::vector<std::uint8_t> inner = mark_inner_faces(complex, constrained, hull, seat);
  seat.fits =
      std::find(seat.faces.begin(), seat.faces.end(), FaceOfSeat::missing) == seat.faces.end();
  if (!seat.fits) return seat;
  std::vector<std::uint8_t> found(complex.nodes.size(), 0);
  for (std::size_t t = 0; t < inner.size(); ++t) {
    if (inner[t] == 0) continue;
    found[t] = 1;
    seat.filling.push_back(static_cast<std::int32_t>(t));
  }
  for (std::size_t head = 0; head < seat.filling.size() && seat.fits; ++head) {
    const std::size_t t = at(seat.filling[head]);
    seat.fits = (constrained[t] & ~inner[t]) == 0 &&
                std::all_of(complex.nodes[t].begin(), complex.nodes[t].end(),
                            [&](std::int32_t v) { return hull.has_node(v); });
    for (int f = 0; f < 4 && seat.fits; ++f) {
      if ((inner[t] >> f & 1) != 0) continue;
      const FaceHandle other = complex.neighbours[t][at(f)];
      seat.fits = other != no_face;
      if (other == no_face || found[at(tet_of(other))] != 0) continue;
      found[at(tet_of(other))] = 1;
      seat.filling.push_back(tet_of(other));
    }
  }
  // What lies beyond a hull face is no filling.
  for (const FaceHandle outer : seat.outer) {
    seat.fits = seat.fits && (outer == no_face || found[at(tet_of(outer))] == 0);
  }
  return seat;
}

void graft_core(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                const LatticeCore& core, std::span<const std::int32_t> node_numbers,
                const CoreSeat& seat) {
  TF_CHECK(seat.outer.size() == core.hull().size() && seat.faces.size() == core.hull().size());
  TF_CHECK(seat.fits);
  for (const std::int32_t t : seat.filling) complex.kill_tet(t);
  const auto first = static_cast<std::int32_t>(complex.nodes.size());
  const std::size_t size = complex.nodes.size() + at(core.tet_count());
  TF_CHECK(size < std::size_t{1} << 29);
  complex.nodes.reserve(size);
  complex.nodes.resize(size);
  complex.neighbours.reserve(size);
  complex.neighbours.resize(size);
  constrained.reserve(size);
  constrained.resize(size, 0);
  core.write(complex, first, node_numbers);
  for (std::size_t i = 0; i < core.hull().size(); ++i) {
    const FaceHandle face = core.hull()[i].face;
    const std::int32_t tet = first + tet_of(face);
    if (seat.outer[i] != no_face) complex.glue(face_handle(tet, face_of(face)), seat.outer[i]);
    if (seat.faces[i] == FaceOfSeat::constrained) {
      constrained[at(tet)] |= static_cast<std::uint8_t>(1U << face_of(face));
    }
  }
}

}  // namespace tetfarm
