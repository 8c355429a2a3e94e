#include "mesh/adaptation/adapt_mesh.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/adaptation/border_crossings.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/edge_collapse.h"
#include "mesh/adaptation/edge_refinement.h"
#include "mesh/adaptation/edge_swaps.h"
#include "mesh/adaptation/mesh_compaction.h"
#include "mesh/adaptation/metric_scaling.h"
#include "mesh/adaptation/metric_smoothing.h"
#include "mesh/adaptation/misfit_mending.h"
#include "mesh/adaptation/sourced_complexity.h"

namespace tetfarm {
namespace {

// What a mesh has to have missed before its nodes move: a mesh that fits is left as it is.
constexpr FittingLimits fitting{0.68, 1.32, 6.0};
constexpr int mendings = 6;
constexpr int most_passes = 60;
// Later on what ellipses swap energies swap back.
constexpr int sweeps_by_ellipses = 3;

// Between the limits of 1/sqrt 2 and sqrt 2 lengths settle below 1: the mesh is made to a metric
// that is coarser by this factor, so that their median is 1 in the metric that was asked for.
constexpr double length_scale = 0.945;
constexpr double metric_factor = length_scale * length_scale;
constexpr RefinementLimits limits_of_length{1.36, 0.69};

void scale(std::vector<Metric2>& metrics, double length_factor) {
  const double factor = length_factor * length_factor;
  for (Metric2& m : metrics) m = factor * m;
}

/// For a field that does not outlive it.
std::shared_ptr<const TriangleComplex> lent(const TriangleComplex& complex) {
  return {std::shared_ptr<const void>(), &complex};
}

/// Before anything is made: a mistyped size asks for more than any memory holds.
void check_size(double complexity, std::int64_t max_triangles) {
  const double triangles = 2 * nodes_per_complexity * complexity;
  if (triangles <= static_cast<double>(max_triangles)) return;
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(),
                "the sizes ask for about %.3g triangles; the most that can be had are %.3g",
                triangles, static_cast<double>(max_triangles));
  throw InvalidInput(text.data(), "");
}

/// A mesh whose border crosses itself is never delivered.
void check_border(const PlaneMesh& mesh) {
  const std::optional<Vec2> place = find_border_crossing(mesh);
  if (!place.has_value()) return;
  throw InvalidInput("with these sizes the two sides of a gap would cross, at " +
                         place_text(*place) + ": ask for shorter edges there",
                     mesh.name);
}

/// The first round looks at edges near active nodes, later ones at those near what has changed.
void begin_rounds(MetricMesh& mesh) {
  for (std::size_t v = 0; v < mesh.touched.size(); ++v) {
    mesh.touched[v] = mesh.active[v] != 0 ? TouchedBits::now : 0;
  }
}

void coarsen(MetricMesh& mesh) {
  for (int pass = 0; pass < most_passes; ++pass) {
    begin_round(mesh);
    if (collapse_edges(mesh, {0.6, 1.41421356, 60}, EdgesToVisit::touched) == 0) return;
    swap_edges(mesh, SwapCriterion::ellipse, true);
  }
}

void refine(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
            const AdaptationOptions& options) {
  RefinementLimits limits = limits_of_length;
  limits.most_triangles = options.max_triangles;
  for (int pass = 0; pass < most_passes; ++pass) {
    begin_round(mesh);
    while (refine_edges(mesh, field, cavity, limits, EdgesToVisit::touched, true) > 0) {
    }
    const std::int64_t nodes = refine_edges(mesh, field, cavity, limits, EdgesToVisit::touched);
    if (mesh.complex.size() - std::ssize(mesh.unused) > options.max_triangles) {
      throw InvalidInput(
          "the metric asks for more than " + std::to_string(options.max_triangles) + " triangles",
          "metric");
    }
    if (nodes == 0) return;
    swap_edges(mesh, SwapCriterion::ellipse, true);
  }
}

void sweep(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity, bool by_ellipses) {
  if (by_ellipses) swap_edges(mesh, SwapCriterion::ellipse, true);
  swap_edges(mesh, SwapCriterion::energy, true);
  smooth_nodes(mesh, field);
  swap_edges(mesh, SwapCriterion::energy, true);
  collapse_edges(mesh, {0.69, 1.36, 12}, EdgesToVisit::active);
  refine_edges(mesh, field, cavity, limits_of_length, EdgesToVisit::active);
}

void mend(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity) {
  for (int i = 0; i < mendings && mend_misfits(mesh, field, fitting) > 0; ++i) {
    swap_edges(mesh, SwapCriterion::energy, true);
    collapse_edges(mesh, {0.665, 1.33, 8}, EdgesToVisit::active);
    refine_edges(mesh, field, cavity, {1.34, 0.67}, EdgesToVisit::active);
  }
  mend_misfits(mesh, field, fitting);
}

/// The mesh with so many nodes near the sources that its edges, which are measured by the metrics
/// of their ends, notice them. `scaled`: of the background.
MetricMesh resolved_mesh(const PlaneMesh& input, const TriangleComplex& complex,
                         const std::vector<Metric2>& scaled, const AdaptationOptions& options) {
  const MetricSources slow = options.sources->noticeable();
  std::vector<Metric2> metrics = scaled;
  for (std::size_t v = 0; v < metrics.size(); ++v) {
    metrics[v] = slow.at(input.points[v], metrics[v], metric_factor);
  }
  MetricMesh mesh =
      make_metric_mesh(input, complex, metrics, options.corner_angle_deg, options.curves);
  EllipseCavity cavity(options.cavity);
  mesh.touched.assign(mesh.touched.size(), TouchedBits::now);
  refine(mesh, MetricField(lent(complex), scaled, {&slow, metric_factor}), cavity, options);
  return mesh;
}

/// Of the field, at each node.
void take_metrics(MetricMesh& mesh, const MetricField& field) {
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.complex.node2triangle[at(v)] < 0) continue;
    NodePlace place = place_of(mesh, v);
    place.metric = field.at(place.point, place.home);
    move_node(mesh, v, place);
  }
  mesh.energies.assign(mesh.energies.size(), MetricMesh::unknown_energy);
}

/// Swaps begin with the triangles that have an active node.
void uncheck_active(MetricMesh& mesh) {
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    const TriangleComplex::Nodes& n = mesh.complex.nodes(t);
    if ((mesh.active[at(n[0])] | mesh.active[at(n[1])] | mesh.active[at(n[2])]) != 0) {
      mesh.unchecked[at(t)] = 0xff;
    }
  }
}

void adapt_to_unit_length(MetricMesh& mesh, const MetricField& field,
                          const AdaptationOptions& options) {
  EllipseCavity cavity(options.cavity);
  const std::int32_t nodes = mesh.nodes();
  activate_misfits(mesh, fitting);
  uncheck_active(mesh);
  begin_rounds(mesh);
  coarsen(mesh);
  begin_rounds(mesh);
  refine(mesh, field, cavity, options);
  if (10 * std::ssize(mesh.unused) > mesh.complex.size() || 10 * nodes < 9 * mesh.nodes()) {
    cavity = EllipseCavity(options.cavity);  // without its marks
    compact(mesh);
  }
  for (int i = 0; i < options.sweeps; ++i) sweep(mesh, field, cavity, i < sweeps_by_ellipses);
  mend(mesh, field, cavity);
}

MeshWithMetrics adapted_to_unit_length(const PlaneMesh& input, const TriangleComplex& complex,
                                       std::vector<Metric2> scaled,
                                       const AdaptationOptions& options) {
  const bool has_sources = options.sources != nullptr;
  MetricMesh mesh = has_sources ? resolved_mesh(input, complex, scaled, options)
                                : make_metric_mesh(input, complex, scaled, options.corner_angle_deg,
                                                   options.curves);
  {
    const MetricField field(lent(complex), std::move(scaled), {options.sources, metric_factor});
    if (has_sources && !options.sources->is_noticeable()) take_metrics(mesh, field);
    adapt_to_unit_length(mesh, field, options);
  }
  return plane_mesh_of(mesh);
}

AdaptationResult adapted_by_mean_length(const PlaneMesh& input, const TriangleComplex& complex,
                                        std::vector<Metric2> metrics,
                                        const AdaptationOptions& options) {
  TF_CHECK(options.sources == nullptr);
  const double mean = mean_edge_length(complex, metrics);
  scale(metrics, 1 / mean);
  check_size(complexity(complex, metrics), options.max_triangles);
  MetricMesh mesh =
      make_metric_mesh(input, complex, metrics, options.corner_angle_deg, options.curves);
  const MetricField field(lent(complex), std::move(metrics));
  EllipseCavity cavity(options.cavity);
  MeanLengthRules rules = options.by_mean;
  rules.most_triangles = std::min(rules.most_triangles, options.max_triangles);
  adapt_by_mean_length(mesh, field, cavity, rules);
  MeshWithMetrics result = plane_mesh_of(mesh);
  check_border(result.mesh);
  const double after = mean_edge_length(checked_complex(result.mesh), result.metrics);
  return {std::move(result.mesh), std::move(result.metrics), mean, mean * after};
}

}  // namespace

AdaptationResult adapt_mesh(const PlaneMesh& input, std::span<const Metric2> metrics,
                            const AdaptationOptions& options) {
  const TriangleComplex complex = checked_complex(input);
  check_metrics(input, metrics);
  return adapt_checked_mesh(input, complex, {metrics.begin(), metrics.end()}, options);
}

AdaptationResult adapt_checked_mesh(const PlaneMesh& input, const TriangleComplex& complex,
                                    std::vector<Metric2> metrics,
                                    const AdaptationOptions& options) {
  if (options.rules == EdgeRules::mean_length) {
    return adapted_by_mean_length(input, complex, std::move(metrics), options);
  }
  const bool has_sources = options.sources != nullptr;
  check_size(has_sources ? sourced_complexity(complex, metrics, *options.sources).complexity
                         : complexity(complex, metrics),
             options.max_triangles);
  scale(metrics, length_scale);
  MeshWithMetrics result = adapted_to_unit_length(input, complex, std::move(metrics), options);
  result.mesh.patch_names = input.patch_names;
  result.mesh.region_names = input.region_names;
  check_border(result.mesh);
  AdaptationResult adapted;
  adapted.mesh = std::move(result.mesh);
  adapted.metrics = std::move(result.metrics);
  scale(adapted.metrics, 1 / length_scale);
  return adapted;
}

}  // namespace tetfarm
