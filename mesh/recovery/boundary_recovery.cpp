#include "mesh/recovery/boundary_recovery.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/recovery/edge_recovery.h"
#include "mesh/recovery/face_recovery.h"
#include "mesh/recovery/facet_flips.h"
#include "mesh/recovery/steiner_insertion.h"
#include "mesh/recovery/steiner_relocation.h"
#include "mesh/recovery/steiner_settling.h"
#include "mesh/recovery/surface_splitting.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

/// How deep a pass searches for each thing that is missing: what is near goes first, and makes
/// room. Chains of flips through fans of needles are some twenty long.
constexpr std::array<int, 5> depths = {1, 3, 8, 20, 60};
/// Edges inside flat facets are swapped in after so many depths, and after all of them: what is
/// left then crosses little else.
constexpr std::size_t depths_before_facets = 3;
/// Rings that a pass may try for each.
constexpr std::int64_t most_rings = 300;
/// A pass is idle, and the next goes deeper, when it finds no more than one in so many of what it
/// looked for; so many in a row end the search.
constexpr std::size_t least_gain = 5;
constexpr int most_idle_passes = 2;

/// What is to be split is tried once more first: points put in for others may have made room.
constexpr std::array<int, 3> depths_before_splitting = {1, 4, 16};

/// Splitting ends after so many rounds, or when it makes more work than it does.
constexpr int most_rounds = 40;
constexpr std::size_t most_points_of_small_surface = 300;
constexpr std::size_t most_growth = 3;

/// Each thing that is tried takes some ten thousand instructions at least.
constexpr int tell_every = 16;

/// By a counter: the same on every machine. Seed 0 leaves the order alone.
template <typename T>
void shuffle(std::vector<T>& things, std::uint64_t seed) {
  if (seed == 0) return;
  std::uint64_t state = seed;
  for (std::size_t i = things.size(); i > 1; --i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    std::swap(things[i - 1], things[(state >> 33) % i]);
  }
}

/// Tries `recover(thing, depth)` for everything that is missing, deeper from pass to pass.
template <typename Thing, typename Recover>
void recover_in_passes(std::vector<Thing>& missing, std::span<const int> depths_of_passes,
                       WorkStage stage, const WorkProgress& progress, Recover recover) {
  if (missing.empty()) return;
  progress.begin(stage, missing.size(), tell_every);
  int idle = 0;
  for (std::size_t pass = 0;
       pass < depths_of_passes.size() && !missing.empty() && idle < most_idle_passes;) {
    progress.next_pass();
    const std::size_t before = missing.size();
    std::erase_if(missing, [&](const Thing& thing) {
      const bool is_there = recover(thing, depths_of_passes[pass]);
      progress.add(is_there ? 1 : 0);
      return is_there;
    });
    const bool is_idle = least_gain * (before - missing.size()) <= before;
    idle = is_idle ? idle + 1 : 0;
    if (is_idle) ++pass;
  }
}

void recover_edges(LocalRemeshing& mesh, EdgeRemoval& removal, std::vector<Edge>& missing,
                   std::span<const int> depths_of_passes, const WorkProgress& progress) {
  recover_in_passes(missing, depths_of_passes, WorkStage::edges, progress,
                    [&](const Edge& edge, int depth) {
                      removal.set_budget(most_rings);
                      return recover_edge(mesh, removal, edge[0], edge[1], depth);
                    });
}

void recover_faces(LocalRemeshing& mesh, EdgeRemoval& removal, const RecoverySurface& surface,
                   std::vector<std::int32_t>& missing, const WorkProgress& progress) {
  recover_in_passes(missing, std::span<const int>(depths), WorkStage::faces, progress,
                    [&](std::int32_t number, int depth) {
                      const Triangle& face = surface.triangles()[at(number)];
                      removal.set_budget(most_rings);
                      if (!recover_face(mesh, removal, face, depth)) return false;
                      mesh.constrain(mesh.find_face(face[0], face[1], face[2]), true);
                      return true;
                    });
}

/// What one round of flips over the whole surface leaves missing.
struct Missing {
  std::vector<Edge> edges;
  std::vector<std::int32_t> faces;
  std::int64_t edges_at_first = 0;
  std::int64_t faces_at_first = 0;
};

/// Points that were put beside the boundary, with the boundary triangles that wanted them.
using PointsBeside = std::vector<SteinerSplit>;

/// Missing edges that cross nothing but edges in one plane with them.
void recover_in_facets(LocalRemeshing& mesh, const RecoverySurface& wanted,
                       const SplitSurface& surface, std::vector<Edge>& missing,
                       PointsBeside& beside) {
  std::erase_if(missing, [&](const Edge& edge) {
    std::vector<std::int32_t> points;
    if (!recover_edge_in_facet(mesh, wanted, edge[0], edge[1], points)) return false;
    // At once, before others take their room.
    std::erase_if(points, [&](std::int32_t v) { return remove_node(mesh, wanted, v); });
    if (points.empty()) return true;
    const std::vector<std::int32_t> sources = sources_at(surface, edge[0], edge[1]);
    for (const std::int32_t point : points) beside.push_back({point, sources});
    return true;
  });
}

/// By flips in space, and by swaps inside facets, which make more of them possible.
void recover_edges_in_all_ways(LocalRemeshing& mesh, EdgeRemoval& removal,
                               const RecoverySurface& wanted, const SplitSurface& surface,
                               const WorkProgress& progress, std::vector<Edge>& missing,
                               PointsBeside& beside) {
  const std::span<const int> all = depths;
  for (const std::span<const int> part :
       {all.first(depths_before_facets), all.subspan(depths_before_facets)}) {
    recover_edges(mesh, removal, missing, part, progress);
    recover_in_facets(mesh, wanted, surface, missing, beside);
  }
}

Missing recover_by_flips(LocalRemeshing& mesh, const RecoverySurface& wanted,
                         const SplitSurface& surface, std::uint64_t seed,
                         const WorkProgress& progress, PointsBeside& beside) {
  Missing missing;
  TF_CHECK(surface.source.size() == surface.triangles.size());
  EdgeRemoval removal(mesh, wanted);
  missing.edges = missing_edges(mesh.complex(), wanted);
  missing.edges_at_first = static_cast<std::int64_t>(missing.edges.size());
  shuffle(missing.edges, seed);
  recover_edges_in_all_ways(mesh, removal, wanted, surface, progress, missing.edges, beside);
  missing.faces = constrain_faces(mesh, wanted);
  missing.faces_at_first = static_cast<std::int64_t>(missing.faces.size());
  shuffle(missing.faces, seed);
  recover_faces(mesh, removal, wanted, missing.faces, progress);
  return missing;
}

/// A missing edge inside one boundary triangle, across an edge of the complex in the same plane:
/// the parts may as well be cut as the complex has them.
bool cut_as_the_complex(const LocalRemeshing& mesh, const Edge& edge, SplitSurface& surface) {
  const auto corners = opposite_corners(surface, edge[0], edge[1]);
  if (!corners) return false;
  const auto [x, y] = *corners;
  if (mesh.find_edge(x, y) < 0 || !segments_cross(mesh, edge[0], edge[1], x, y)) return false;
  swap_edge(surface, edge[0], edge[1]);
  return true;
}

/// Whether the face is missing though its edges are there.
bool is_pierced(const LocalRemeshing& mesh, const Triangle& face) {
  const auto& [a, b, c] = face;
  return mesh.find_edge(a, b) >= 0 && mesh.find_edge(b, c) >= 0 && mesh.find_edge(c, a) >= 0 &&
         mesh.find_face(a, b, c) == no_face;
}

/// The parts as recovery asks for them, made anew when they have changed.
class CurrentParts {
 public:
  CurrentParts(const LocalRemeshing& mesh, SplitSurface& surface)
      : mesh_(mesh), surface_(surface) {}
  const RecoverySurface& get() {
    const auto nodes = static_cast<std::int32_t>(mesh_.complex().points.size());
    if (!parts_) parts_.emplace(surface_.triangles, nodes);
    return *parts_;
  }
  /// To change them.
  SplitSurface& surface() {
    parts_.reset();
    return surface_;
  }

 private:
  const LocalRemeshing& mesh_;
  SplitSurface& surface_;
  std::optional<RecoverySurface> parts_;
};

bool recover_before_splitting(LocalRemeshing& mesh, CurrentParts& parts, const Edge& edge) {
  EdgeRemoval removal(mesh, parts.get());
  return std::any_of(depths_before_splitting.begin(), depths_before_splitting.end(), [&](int d) {
    removal.set_budget(most_rings);
    return recover_edge(mesh, removal, edge[0], edge[1], d);
  });
}

/// Whether the edge is there now, whole or in two parts that may be missing.
bool split_missing_edge(LocalRemeshing& mesh, const Edge& edge, CurrentParts& parts) {
  if (recover_before_splitting(mesh, parts, edge)) return true;
  const SegmentWalk walk = walk_segment(mesh, edge[0], edge[1]);
  if (walk.crossings.empty()) return false;
  if (cut_as_the_complex(mesh, edge, parts.surface())) return true;
  const std::int32_t node = insert_on_edge(mesh, parts.get(), edge, walk);
  if (node < 0) return false;
  split_edge(parts.surface(), edge[0], edge[1], node);
  return true;
}

/// Splits every missing edge, one by one, and every missing face whose edges are all there. False:
/// no point had room.
bool split_missing(LocalRemeshing& mesh, const Missing& missing, SplitSurface& surface,
                   const WorkProgress& progress) {
  bool is_changed = false;
  progress.begin(WorkStage::splits, missing.edges.size() + missing.faces.size(), tell_every);
  CurrentParts parts(mesh, surface);
  for (const Edge& edge : missing.edges) {
    progress.add();
    if (split_missing_edge(mesh, edge, parts)) is_changed = true;
  }
  for (const std::int32_t number : missing.faces) {
    progress.add();
    TF_CHECK(at(number) < surface.triangles.size());
    const Triangle face = surface.triangles[at(number)];
    if (!is_pierced(mesh, face)) continue;
    const std::int32_t node = insert_on_face(mesh, parts.get(), face);
    if (node < 0) continue;
    split_face(parts.surface(), number, node);
    is_changed = true;
  }
  return is_changed;
}

/// Every boundary triangle is a face, whole or in parts. What could not be recovered even so is
/// lost.
SplitSurface recover_in_parts(LocalRemeshing& mesh, const std::vector<Triangle>& triangles,
                              std::uint64_t seed, const WorkProgress& progress,
                              PointsBeside& beside, RecoveredBoundary& result) {
  std::size_t least_missing = triangles.size();
  SplitSurface surface = unsplit(triangles);
  for (int round = 0;; ++round) {
    const std::vector<Triangle> parts = surface.triangles;
    const RecoverySurface wanted(parts, static_cast<std::int32_t>(mesh.complex().points.size()));
    const Missing missing = recover_by_flips(mesh, wanted, surface, seed, progress, beside);
    if (round == 0) {
      result.missing_edges = missing.edges_at_first;
      result.missing_faces = missing.faces_at_first;
    }
    if (missing.faces.empty()) return surface;
    least_missing = std::min(least_missing, missing.faces.size());
    if (surface.splits.empty()) mesh.know_surface(triangles);
    const bool is_hopeful =
        surface.splits.size() <= triangles.size() + most_points_of_small_surface &&
        missing.faces.size() <= most_growth * least_missing + 10;
    if (is_hopeful && round < most_rounds && split_missing(mesh, missing, surface, progress)) {
      continue;
    }
    for (const std::int32_t number : missing.faces) {
      result.lost.push_back(surface.source[at(number)]);
    }
    return surface;
  }
}

/// Takes the Steiner points off the boundary and settles them; what does not work out is lost.
void make_whole(LocalRemeshing& mesh, const std::vector<Triangle>& triangles, SplitSurface& surface,
                const PointsBeside& beside, const WorkProgress& progress,
                RecoveredBoundary& result) {
  if (!surface.splits.empty()) progress.begin(WorkStage::added_points, surface.splits.size());
  std::vector<SteinerSplit> waiting(surface.splits.rbegin(), surface.splits.rend());
  std::vector<std::int32_t> points;
  for (const SteinerSplit& point : beside) points.push_back(point.node);
  constexpr int most_sweeps = 4;
  for (int sweep = 0; sweep < most_sweeps && !waiting.empty(); ++sweep) {
    // Those that have left already may make room.
    if (sweep > 0) settle_steiner_points(mesh, points, progress);
    std::erase_if(waiting, [&](const SteinerSplit& split) {
      progress.add(0);
      if (!relocate_steiner_point(mesh, surface, triangles, split.node)) return false;
      // At once, or the room would be less and less from point to point.
      settle_steiner_point(mesh, split.node);
      points.push_back(split.node);
      progress.add();
      return true;
    });
  }
  for (const SteinerSplit& split : waiting) {
    result.lost.insert(result.lost.end(), split.sources.begin(), split.sources.end());
  }
  const SettledPoints settled = settle_steiner_points(mesh, points, progress);
  result.steiner_points = static_cast<std::int64_t>(settled.kept.size());
  TF_CHECK(settled.kept.size() + settled.unsettled.size() <= points.size());
  for (const auto* points_of : {&std::as_const(surface.splits), &beside}) {
    for (const SteinerSplit& split : *points_of) {
      const auto& unsettled = settled.unsettled;
      if (std::find(unsettled.begin(), unsettled.end(), split.node) == unsettled.end()) continue;
      result.lost.insert(result.lost.end(), split.sources.begin(), split.sources.end());
    }
  }
}

}  // namespace

std::vector<Edge> missing_edges(const TetComplex& complex, const RecoverySurface& surface) {
  std::vector<Edge> edges = surface.edges();
  std::vector<std::uint8_t> is_there(edges.size(), 0);
  constexpr std::array<std::array<std::size_t, 2>, 6> ends = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  std::vector<std::size_t> begin(at(surface.nodes()) + 1, 0);
  for (const Edge& edge : edges) ++begin[at(edge[0]) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (const auto& [i, j] : ends) {
      const auto [low, high] = std::minmax(complex.nodes[t][i], complex.nodes[t][j]);
      if (high >= surface.nodes()) continue;
      const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low)]);
      const auto last = edges.begin() + static_cast<std::ptrdiff_t>(begin[at(low) + 1]);
      const auto it = std::lower_bound(first, last, Edge{low, high});
      if (it != last && (*it)[1] == high)
        is_there[static_cast<std::size_t>(it - edges.begin())] = 1;
    }
  }
  std::vector<Edge> missing;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(edges[i]);
  }
  return missing;
}

std::vector<std::int32_t> constrain_faces(LocalRemeshing& mesh, const RecoverySurface& surface) {
  std::vector<std::uint8_t> is_there(surface.triangles().size(), 0);
  const TetComplex& complex = mesh.complex();
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    for (int f = 0; f < 4; ++f) {
      const auto& k = tet_face_nodes[at(f)];
      const Tet& n = complex.nodes[t];
      const std::int32_t a = n[at(k[0])], b = n[at(k[1])], c = n[at(k[2])];
      if (std::max({a, b, c}) >= surface.nodes()) continue;
      const std::int32_t number = surface.find_triangle(a, b, c);
      if (number < 0) continue;
      is_there[at(number)] = 1;
      mesh.constrain(face_handle(static_cast<std::int32_t>(t), f), true);
    }
  }
  std::vector<std::int32_t> missing;
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (is_there[i] == 0) missing.push_back(static_cast<std::int32_t>(i));
  }
  return missing;
}

RecoveredBoundary recover_boundary(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                                   const std::vector<Triangle>& triangles, std::uint64_t seed,
                                   const WorkProgress& progress) {
  RecoveredBoundary result;
  LocalRemeshing mesh(complex, constrained);
  PointsBeside beside;
  SplitSurface surface = recover_in_parts(mesh, triangles, seed, progress, beside, result);
  result.splits = static_cast<std::int64_t>(surface.splits.size());
  if (result.lost.empty()) make_whole(mesh, triangles, surface, beside, progress, result);
  std::sort(result.lost.begin(), result.lost.end());
  result.lost.erase(std::unique(result.lost.begin(), result.lost.end()), result.lost.end());
  TF_CHECK(result.lost.empty() || at(result.lost.back()) < triangles.size());
  return result;
}

}  // namespace tetfarm
