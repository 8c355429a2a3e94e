#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/error.h"
#include "cli/adapted_report.h"
#include "cli/commands.h"
#include "mesh/adaptation/adapt_to_metric.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/solution_metric.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_meshb.h"
#include "mesh/metric/metric_intersection.h"
#include "worker/curve_option.h"

namespace tetfarm {
namespace {

std::vector<Metric2> metrics_of_file(const std::string& file, const PlaneMesh& mesh) {
  NodeFields fields = read_plane_fields(file);
  if (fields.metrics.empty()) {
    throw InvalidInput("has no symmetric tensors: a metric has kind 3", file);
  }
  check_metrics(mesh, fields.metrics.front(), file);
  std::vector<Metric2> metrics = std::move(fields.metrics.front());
  for (std::size_t k = 1; k < fields.metrics.size(); ++k) {
    check_metrics(mesh, fields.metrics[k], file);
    for (std::size_t v = 0; v < metrics.size(); ++v) {
      metrics[v] = intersection(metrics[v], fields.metrics[k][v]);
    }
  }
  return metrics;
}

std::vector<Metric2> metrics_of_solution_file(const AdaptCommand& command, const PlaneMesh& mesh,
                                              const TriangleComplex& complex) {
  const NodeFields fields = read_plane_fields(command.solution);
  if (fields.scalars.empty()) {
    throw InvalidInput("has no numbers at the nodes: a scalar field has kind 1", command.solution);
  }
  for (const std::vector<double>& values : fields.scalars) {
    check_values(mesh, values, command.solution);
  }
  return metrics_of_solution(complex, fields.scalars, {command.mode == "lp", command.norm});
}

}  // namespace

ExitCode adapt_command(const AdaptCommand& command) {
  if (command.metric.empty() && command.solution.empty()) {
    throw UsageError("say what to adapt to: --metric FILE or --solution FILE", "");
  }
  const bool is_thesis = command.mode == "thesis";
  if (is_thesis && command.vertices.has_value()) {
    throw UsageError(
        "--mode thesis keeps the mean length of the edges that MESH has, and takes no "
        "number of vertices",
        "--vertices");
  }
  require_plane_input_name(command.input);
  require_plane_output_name(command.output);
  check_curve_options(command.curves);
  const std::int64_t start = steady_ms();
  const CurvesOfMesh curved =
      curves_of_options(command.curves, read_plane_mesh(command.input), command.corner_angle_deg);
  const PlaneMesh& mesh = curved.mesh;
  const TriangleComplex& complex = curved.complex;
  const bool has_metric = !command.metric.empty();
  const std::vector<Metric2> metrics = has_metric
                                           ? metrics_of_file(command.metric, mesh)
                                           : metrics_of_solution_file(command, mesh, complex);
  AdaptationWish wish;
  wish.metrics = metrics;
  wish.metric_name = has_metric ? command.metric : command.solution;
  wish.limits = {command.h_min.value_or(0), command.h_max.value_or(0), command.aspect,
                 gradation_of(command.gradation, has_metric || is_thesis ? 0 : 1.4)};
  wish.vertices = command.vertices;
  if (!has_metric && command.mode == "lp" && !wish.vertices.has_value()) {
    wish.vertices = static_cast<std::int64_t>(mesh.points.size());
  }
  AdaptationOptions options;
  options.corner_angle_deg = command.corner_angle_deg;
  options.curves = curved.curves;
  if (is_thesis) {
    options.rules = EdgeRules::mean_length;
    options.cavity.rings = 1;
  }
  const AdaptedMesh adapted = adapt_to_metric(mesh, complex, wish, options);
  write_plane_mesh(adapted.result.mesh, command.output);
  tell_adapted({"adapt", command.output, command.json, start, &curved}, adapted);
  return ExitCode::ok;
}

}  // namespace tetfarm
