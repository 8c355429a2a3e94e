#include "mesh/remeshing/edge_flip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetfarm {
namespace {

/// Less than that is rounding.
constexpr double least_gain = 1e-6;
constexpr std::int64_t flips_a_triangle = 10;

using Edge = std::pair<std::int32_t, std::int32_t>;

/// The triangle with `gone` replaced by `come`, whose edge from `come` to `apex` is new.
FaceTriangle flipped(const FaceTriangle& old, const FaceTriangle& other, std::int32_t kept,
                     std::int32_t gone, std::int32_t come) {
  FaceTriangle made = old;
  made.nodes[corner_of(old.nodes, gone)] = come;
  const std::int32_t apex = third_vertex(old.nodes, kept, gone);
  made.features = 0;
  if (is_feature_edge(old, kept, apex)) mark_feature_edge(made, kept, apex);
  if (is_feature_edge(other, kept, come)) mark_feature_edge(made, kept, come);
  return made;
}

/// How many triangles too many a vertex, no corner, has in the face.
std::ptrdiff_t valence_excess(const ChangingSurface& surface, std::int32_t v, std::int32_t face) {
  const auto in_face = std::ranges::count_if(
      surface.ring(v), [&](std::int32_t t) { return surface.triangle(t).face == face; });
  return in_face - (surface.vertex(v).kind == VertexKind::smooth ? 6 : 3);
}

/// Whether taking the edge from the first two vertices and giving it to the others brings all four
/// nearer to what they should have. Corners do not count: their angle says how many they should.
bool evens_valences(const ChangingSurface& surface, const std::array<std::int32_t, 4>& vertices,
                    std::int32_t face) {
  std::ptrdiff_t before = 0;
  std::ptrdiff_t after = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (surface.vertex(vertices[i]).kind == VertexKind::corner) continue;
    const std::ptrdiff_t excess = valence_excess(surface, vertices[i], face);
    const std::ptrdiff_t changed = excess + (i < 2 ? -1 : 1);
    before += excess * excess;
    after += changed * changed;
  }
  return after < before;
}

}  // namespace

bool flip_edge(RemeshingWork& work, std::int32_t a, std::int32_t b, FlipFor wanted) {
  const ChangingSurface& surface = work.surface;
  std::vector<std::int32_t>& on = work.replacement.removed;
  work.replacement.clear();
  surface.find_triangles_on(a, b, on);
  if (on.size() != 2 || surface.is_feature(on.front(), a, b)) return false;
  const FaceTriangle& first = surface.triangle(on[0]);
  const FaceTriangle& second = surface.triangle(on[1]);
  const std::int32_t c = third_vertex(first.nodes, a, b);
  const std::int32_t d = third_vertex(second.nodes, a, b);
  if (c == d) return false;
  work.replacement.fills_hole = true;
  work.replacement.made.push_back(flipped(first, second, a, b, d));
  work.replacement.made.push_back(flipped(second, first, b, a, c));
  const double made = worst_shape(surface, work.replacement.made);
  const bool helps =
      wanted == FlipFor::shape
          ? made >= worst_shape(surface, on) + least_gain
          : made >= passable_shape && evens_valences(surface, {a, b, c, d}, first.face);
  if (!helps) return false;
  if (surface.has_edge(c, d)) return false;
  // The new edge runs from c in one of the two, so its middle is looked at.
  if (!lies_on_input(work, c) || !meets_nothing(work)) return false;
  replace(work);
  return true;
}

std::int64_t flip_edges(RemeshingWork& work, FlipFor wanted) {
  const ChangingSurface& surface = work.surface;
  // What no change came near is as it was when it was last looked at.
  const std::uint64_t then = wanted == FlipFor::shape ? work.flipped : 0;
  std::vector<Edge> waiting;
  const auto may_flip = [&](const FaceTriangle& t, std::size_t k) {
    return !is_feature_side(t, k) &&
           surface.has_changed_since(then, t.nodes[k], t.nodes[(k + 1) % 3]);
  };
  for (std::int32_t i = 0; i < surface.triangle_end(); ++i) {
    if (!surface.is_there(i)) continue;
    const FaceTriangle& t = surface.triangle(i);
    for (std::size_t k = 0; k < 3; ++k) {
      // The two triangles on an edge that is no feature have it in both directions.
      const Edge edge{t.nodes[k], t.nodes[(k + 1) % 3]};
      if (edge.first < edge.second && may_flip(t, k)) waiting.push_back(edge);
    }
  }
  const auto add_edges = [&](const FaceTriangle& t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t.nodes[k];
      const std::int32_t b = t.nodes[(k + 1) % 3];
      if (may_flip(t, k)) waiting.emplace_back(std::min(a, b), std::max(a, b));
    }
  };
  std::int64_t left = flips_a_triangle * surface.triangle_count();
  std::int64_t flips = 0;
  for (std::vector<Edge> now; !waiting.empty() && left > 0;) {
    now.swap(waiting);
    waiting.clear();
    for (const Edge& edge : now) {
      if (left <= 0 || !flip_edge(work, edge.first, edge.second, wanted)) continue;
      --left;
      ++flips;
      for (const FaceTriangle& made : work.replacement.made) add_edges(made);
    }
    std::ranges::sort(waiting);
    waiting.erase(std::unique(waiting.begin(), waiting.end()), waiting.end());
  }
  if (wanted == FlipFor::shape && left > 0) work.flipped = surface.now();
  return flips;
}

}  // namespace tetfarm
