#include "mesh/adaptation/mean_length_rules.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/adaptation/edge_collapse.h"
#include "mesh/adaptation/edge_refinement.h"
#include "mesh/adaptation/edge_swaps.h"
#include "mesh/adaptation/metric_smoothing.h"

namespace tetfarm {
namespace {

constexpr double worst_energy_of_collapse = 60;

}  // namespace

double mean_edge_length(const TriangleComplex& complex, std::span<const Metric2> metrics) {
  TF_CHECK(complex.size() > 0 && metrics.size() == complex.points.size());
  double sum = 0;
  std::int64_t count = 0;
  for (const auto& [a, b] : edges_of(complex)) {
    const Vec2& p = complex.point(a);
    const Vec2& q = complex.point(b);
    sum += length_between({q.x - p.x, q.y - p.y}, metrics[at(a)], metrics[at(b)]);
    ++count;
  }
  return sum / static_cast<double>(count);
}

int adapt_by_mean_length(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
                         const MeanLengthRules& rules) {
  RefinementLimits limits;
  limits.longest = rules.longest;
  // The halves of the longest edge that stays: no node comes where others are nearer.
  limits.shortest = rules.longest / 2;
  limits.most_triangles = rules.most_triangles;
  limits.at_middles = true;
  const CollapseLimits collapse{rules.shortest, rules.longest, worst_energy_of_collapse};
  for (int pass = 1; pass <= rules.passes; ++pass) {
    const std::int64_t gone = collapse_edges(mesh, collapse, EdgesToVisit::all);
    const std::int64_t came = refine_edges(mesh, field, cavity, limits, EdgesToVisit::all);
    if (gone + came == 0) return pass;
    std::fill(mesh.active.begin(), mesh.active.end(), std::uint8_t{1});
    swap_edges(mesh, SwapCriterion::ellipse, false);
    swap_edges(mesh, SwapCriterion::energy, false);
    smooth_nodes(mesh, field);
  }
  return rules.passes;
}

}  // namespace tetfarm
