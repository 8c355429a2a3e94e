#include "mesh/volume/steiner_relocation.h"

#include <algorithm>
#include <array>

#include "mesh/volume/kernel_point.h"
#include "mesh/volume/local_remeshing.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

std::array<std::int32_t, 3> sorted_nodes(const Tet& n, int face) {
  const auto& f = tet_face_nodes[at(face)];
  std::array<std::int32_t, 3> key = {n[at(f[0])], n[at(f[1])], n[at(f[2])]};
  std::sort(key.begin(), key.end());
  return key;
}

struct OpenFace {
  std::array<std::int32_t, 3> key;
  FaceHandle handle;
  friend bool operator<(const OpenFace& a, const OpenFace& b) {
    return a.key != b.key ? a.key < b.key : a.handle < b.handle;
  }
};

/// The tets of the star that stay, those that go, and the triangles that get a new tet.
struct Sorted {
  std::vector<std::int32_t> kept;
  std::vector<std::int32_t> dropped;
  std::vector<Triangle> open;
};

/// A tet whose face opposite the point is one of the whole triangles goes: rounding has put the
/// point on that triangle's far side, and the triangle is there already.
Sorted sort_star(const TetComplex& complex, const std::vector<std::int32_t>& star,
                 const SteinerSplit& split) {
  Sorted sorted;
  sorted.open = split.originals;
  for (const std::int32_t t : star) {
    const auto face = sorted_nodes(complex.nodes[at(t)], complex.local_node(t, split.node));
    const auto is_whole = [&face](Triangle triangle) {
      std::sort(triangle.begin(), triangle.end());
      return triangle == face;
    };
    const bool goes = std::erase_if(sorted.open, is_whole) > 0;
    (goes ? sorted.dropped : sorted.kept).push_back(t);
  }
  return sorted;
}

/// Faces round the point that must see it, from inside: the link, and the whole triangles.
std::vector<VisibleFace> faces_to_see(const TetComplex& complex, const Sorted& sorted,
                                      std::int32_t node) {
  std::vector<VisibleFace> faces;
  const auto p = [&complex](std::int32_t v) { return complex.points[at(v)]; };
  for (const std::int32_t t : sorted.kept) {
    const auto& f = tet_face_nodes[at(complex.local_node(t, node))];
    const Tet& n = complex.nodes[at(t)];
    faces.push_back({p(n[at(f[0])]), p(n[at(f[2])]), p(n[at(f[1])])});
  }
  for (const auto& [a, b, c] : sorted.open) faces.push_back({p(a), p(c), p(b)});
  return faces;
}

/// The neighbours' faces become boundary.
void drop(TetComplex& complex, std::vector<std::uint8_t>& constrained,
          const std::vector<std::int32_t>& tets) {
  for (const std::int32_t t : tets) {
    const Tet nodes = complex.nodes[at(t)];
    const auto neighbours = complex.neighbours[at(t)];
    for (const FaceHandle h : neighbours) {
      if (h == no_face) continue;
      complex.neighbours[at(tet_of(h))][at(face_of(h))] = no_face;
      constrained[at(tet_of(h))] =
          static_cast<std::uint8_t>(constrained[at(tet_of(h))] | 1 << face_of(h));
    }
    complex.kill_tet(t);
    constrained[at(t)] = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (complex.node2tet[at(nodes[i])] != t) continue;
      complex.node2tet[at(nodes[i])] = -1;
      for (std::size_t k = 0; k < 4; ++k) {
        // The face opposite k holds node i.
        if (k != i && neighbours[k] != no_face && complex.is_live(tet_of(neighbours[k]))) {
          complex.node2tet[at(nodes[i])] = tet_of(neighbours[k]);
        }
      }
    }
  }
}

void add_tets_on(TetComplex& complex, std::vector<std::uint8_t>& constrained, const Sorted& sorted,
                 std::int32_t node) {
  std::vector<OpenFace> open;
  const auto gather = [&](std::int32_t t) {
    for (int f = 0; f < 4; ++f) {
      if (complex.neighbours[at(t)][at(f)] != no_face) continue;
      open.push_back({sorted_nodes(complex.nodes[at(t)], f), face_handle(t, f)});
    }
  };
  for (const std::int32_t t : sorted.kept) {
    gather(t);
    for (const std::int32_t v : complex.nodes[at(t)]) complex.node2tet[at(v)] = t;
  }
  for (const auto& [a, b, c] : sorted.open) {
    const std::int32_t t = complex.new_tet();
    constrained.resize(complex.nodes.size(), 0);
    complex.nodes[at(t)] = {a, c, b, node};
    complex.neighbours[at(t)] = {no_face, no_face, no_face, no_face};
    for (const std::int32_t v : {a, b, c, node}) complex.node2tet[at(v)] = t;
    constrained[at(t)] = 8;
    gather(t);
  }
  std::sort(open.begin(), open.end());
  for (std::size_t i = 0; i + 1 < open.size(); ++i) {
    if (open[i].key != open[i + 1].key) continue;
    for (const FaceHandle h : {open[i].handle, open[i + 1].handle}) {
      constrained[at(tet_of(h))] =
          static_cast<std::uint8_t>(constrained[at(tet_of(h))] & ~(1 << face_of(h)));
    }
    complex.glue(open[i].handle, open[i + 1].handle);
    ++i;
  }
}

}  // namespace

bool relocate_steiner_point(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                            const SteinerSplit& split) {
  const LocalRemeshing mesh(complex, constrained);
  const auto star = mesh.star(split.node);
  if (star.empty()) return false;
  const Sorted sorted = sort_star(complex, star, split);
  const auto faces = faces_to_see(complex, sorted, split.node);
  if (!faces.empty()) {
    const auto place = kernel_point(faces, complex.points[at(split.node)]);
    if (!place) return false;
    complex.points[at(split.node)] = *place;
  }
  drop(complex, constrained, sorted.dropped);
  add_tets_on(complex, constrained, sorted, split.node);
  return true;
}

}  // namespace tetfarm
