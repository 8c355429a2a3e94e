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

/// Faces round the point that must see it, from inside: the link, and the whole triangles.
std::vector<VisibleFace> faces_to_see(const TetComplex& complex,
                                      const std::vector<std::int32_t>& star,
                                      const SteinerSplit& split) {
  std::vector<VisibleFace> faces;
  const auto p = [&complex](std::int32_t v) { return complex.points[at(v)]; };
  for (const std::int32_t t : star) {
    const auto& f = tet_face_nodes[at(complex.local_node(t, split.node))];
    const Tet& n = complex.nodes[at(t)];
    faces.push_back({p(n[at(f[0])]), p(n[at(f[2])]), p(n[at(f[1])])});
  }
  for (const auto& [a, b, c] : split.originals) faces.push_back({p(a), p(c), p(b)});
  return faces;
}

void add_tets_on(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                 const std::vector<std::int32_t>& star, const SteinerSplit& split) {
  std::vector<OpenFace> open;
  const auto gather = [&](std::int32_t t) {
    for (int f = 0; f < 4; ++f) {
      if (complex.neighbours[at(t)][at(f)] != no_face) continue;
      open.push_back({sorted_nodes(complex.nodes[at(t)], f), face_handle(t, f)});
    }
  };
  for (const std::int32_t t : star) gather(t);
  for (const auto& [a, b, c] : split.originals) {
    const std::int32_t t = complex.new_tet();
    constrained.resize(complex.nodes.size(), 0);
    complex.nodes[at(t)] = {a, c, b, split.node};
    complex.neighbours[at(t)] = {no_face, no_face, no_face, no_face};
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
  const auto faces = faces_to_see(complex, star, split);
  double size = HUGE_VAL;
  for (const auto& [a, b, c] : split.originals) {
    const Vec3& p = complex.points[at(a)];
    size = std::min({size, distance(p, complex.points[at(b)]), distance(p, complex.points[at(c)])});
  }
  const auto place = kernel_point(faces, complex.points[at(split.node)], 0.1 * size);
  if (!place) return false;
  complex.points[at(split.node)] = *place;
  add_tets_on(complex, constrained, star, split);
  return true;
}

}  // namespace tetfarm
