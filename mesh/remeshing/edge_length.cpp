#include "mesh/remeshing/edge_length.h"

#include <algorithm>
#include <tuple>

namespace tetfarm {
namespace {

/// Calls visit(a, b), a < b, for each edge: once, or more than once where it is a feature.
template <typename Visitor>
void for_each_edge_of(const ChangingSurface& surface, Visitor&& visit) {
  for (std::int32_t t = 0; t < surface.triangle_end(); ++t) {
    if (!surface.is_there(t)) continue;
    const Triangle& nodes = surface.triangle(t).nodes;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = nodes[k];
      const std::int32_t b = nodes[(k + 1) % 3];
      // Inside a face its two triangles have it in both directions; between sheets all may have it
      // in one.
      if (a < b || is_feature_side(surface.triangle(t), k)) {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  }
}

std::vector<MeasuredEdge> sorted(std::vector<MeasuredEdge> edges, double direction) {
  std::ranges::sort(edges, [direction](const MeasuredEdge& a, const MeasuredEdge& b) {
    return std::tuple(direction * a.length, a.ends) < std::tuple(direction * b.length, b.ends);
  });
  return edges;
}

/// Without a look at the spacing of the middle, which grows slowly from that of the ends.
bool surely_no_longer(const RemeshingWork& work, std::int32_t a, std::int32_t b, double limit) {
  const double ends = edge_length(work, a, b);
  if (ends < 0.5 * limit) return true;
  const double length = distance(work.surface.at(a), work.surface.at(b));
  const double larger = std::max(work.surface.vertex(a).spacing, work.surface.vertex(b).spacing);
  return ends <= limit && length <= limit * work.spacing.least_near(larger, 0.5 * length);
}

}  // namespace

double long_edge_length(const RemeshingWork& work, std::int32_t a, std::int32_t b) {
  const Vec3& from = work.surface.at(a);
  const Vec3& to = work.surface.at(b);
  const double ends = 0.5 * (work.surface.vertex(a).spacing + work.surface.vertex(b).spacing);
  return distance(from, to) / std::min(ends, work.spacing.at(0.5 * (from + to)));
}

std::vector<MeasuredEdge> edges_longer_than(const RemeshingWork& work, double limit,
                                            std::uint64_t then) {
  std::vector<MeasuredEdge> edges;
  for_each_edge_of(work.surface, [&](std::int32_t a, std::int32_t b) {
    if (!work.surface.has_changed_since(then, a, b)) return;
    if (surely_no_longer(work, a, b, limit)) return;
    const double length = long_edge_length(work, a, b);
    if (length > limit) edges.push_back({length, {a, b}});
  });
  return sorted(std::move(edges), -1);
}

std::vector<MeasuredEdge> edges_shorter_than(const RemeshingWork& work, double limit) {
  std::vector<MeasuredEdge> edges;
  for_each_edge_of(work.surface, [&](std::int32_t a, std::int32_t b) {
    const double length = edge_length(work, a, b);
    if (length < limit) edges.push_back({length, {a, b}});
  });
  return sorted(std::move(edges), 1);
}

}  // namespace tetfarm
