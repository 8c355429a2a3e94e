#include "mesh/planar/planar_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "mesh/planar/constrained_delaunay.h"
#include "mesh/planar/edge_flips.h"
#include "mesh/planar/point_insertion.h"
#include "mesh/planar/restricted_cavity.h"
#include "mesh/planar/smoothing.h"

namespace tetfarm {
namespace {

using Chord = std::pair<std::int32_t, std::int32_t>;

std::vector<Chord> sorted_chords(const PlanarOptions& options) {
  std::vector<Chord> chords;
  for (const auto& [a, b] : options.forbidden_chords)
    chords.emplace_back(std::min(a, b), std::max(a, b));
  std::ranges::sort(chords);
  return chords;
}

/// The inner edges of the complex that are forbidden, each once.
std::vector<EdgeHandle> find_chords(const TriangleComplex& complex,
                                    const std::vector<Chord>& forbidden) {
  std::vector<EdgeHandle> found;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (complex.is_constrained(t, i) || complex.neighbour(t, i) < edge_handle(t, 0)) continue;
      const auto [a, b] = std::minmax({complex.node(t, next(i)), complex.node(t, previous(i))});
      if (std::ranges::binary_search(forbidden, Chord{a, b})) found.push_back(edge_handle(t, i));
    }
  }
  return found;
}

/// Puts a point in the middle of every forbidden chord. New edges all end at the new point, so this
/// makes no other chord.
void split_chords(TriangleComplex& complex, const std::vector<Chord>& forbidden) {
  if (forbidden.empty()) return;
  Cavity cavity;
  bool is_changed = true;
  while (is_changed) {
    is_changed = false;
    // One at a time would scan too often: those whose triangle the others have replaced wait.
    const std::vector<EdgeHandle> chords = find_chords(complex, forbidden);
    std::vector<TriangleComplex::Nodes> nodes;
    for (const EdgeHandle chord : chords) nodes.push_back(complex.nodes(triangle_of(chord)));
    for (std::size_t k = 0; k < chords.size(); ++k) {
      const std::int32_t t = triangle_of(chords[k]);
      if (complex.nodes(t) != nodes[k]) continue;
      const Vec2& a = complex.point(complex.node(t, next(edge_of(chords[k]))));
      const Vec2& b = complex.point(complex.node(t, previous(edge_of(chords[k]))));
      const Vec2 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
      const auto holder = locate(complex, t, middle);
      if (!holder || !find_cavity(complex, *holder, middle, cavity)) continue;
      fill_cavity(complex, middle, cavity);
      is_changed = true;
    }
  }
}

/// A place where the spacing is not positive and finite, if one is found among the points.
std::optional<PlanarFailure> check_spacing(const PlanarRegion& region,
                                           const PlanarSpacing& spacing) {
  for (const Vec2& p : region.points) {
    const double h = spacing(p);
    if (!(h > 0) || !std::isfinite(h))
      return PlanarFailure{"the spacing is not positive and finite", {p}};
  }
  return std::nullopt;
}

void improve(TriangleComplex& complex, std::int32_t first_free) {
  TF_CHECK(first_free >= 0);
  constexpr int sweeps = 4;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::size_t moved = smooth(complex, first_free);
    flip_to_delaunay(complex);
    if (moved == 0) break;
  }
}

}  // namespace

PlanarResult mesh_region(const PlanarRegion& region, const PlanarSpacing& spacing,
                         const PlanarOptions& options) {
  ConstrainedDelaunay delaunay = constrained_delaunay(region);
  if (delaunay.failure) return {{}, std::move(delaunay.failure)};
  if (auto failure = check_spacing(region, spacing)) return {{}, std::move(failure)};

  TriangleComplex& complex = delaunay.complex;
  const auto boundary_points = static_cast<std::int32_t>(region.points.size());
  const PlanarFailure too_many{"the spacing asks for too many triangles", {region.points[0]}};
  if (estimated_triangles(complex, spacing) > static_cast<double>(options.max_triangles))
    return {{}, too_many};
  if (!insert_points(complex, spacing, options.max_triangles)) return {{}, too_many};

  const std::vector<Chord> chords = sorted_chords(options);
  split_chords(complex, chords);
  improve(complex, boundary_points);
  split_chords(complex, chords);
  TF_CHECK(complex.points.size() >= region.points.size());
  return {{std::move(complex.points), std::move(complex.triangles)}, std::nullopt};
}

}  // namespace tetfarm
