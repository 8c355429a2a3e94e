#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/error.h"
#include "cli/adapted_report.h"
#include "cli/commands.h"
#include "mesh/adaptation/adapt_to_metric.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/sizes_of_mesh.h"
#include "mesh/adaptation/solution_metric.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_meshb.h"
#include "mesh/metric/metric_intersection.h"
#include "worker/curve_option.h"
#include "worker/metric_source_file.h"

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

/// What is asked for at the nodes of the mesh, by the file that says it; without one the background
/// of the sources: of their size, or as fine as the mesh.
std::vector<Metric2> metrics_of_command(const AdaptCommand& command, const CurvesOfMesh& curved,
                                        const PlaneSources& sources) {
  if (!command.metric.empty()) return metrics_of_file(command.metric, curved.mesh);
  if (!command.solution.empty()) {
    return metrics_of_solution_file(command, curved.mesh, curved.complex);
  }
  if (!sources.size.has_value()) return sizes_of_mesh(curved.complex);
  const Metric2 metric = metric_of_sizes({*sources.size, *sources.size, 0});
  return std::vector<Metric2>(curved.mesh.points.size(), metric);
}

PlaneSources sources_of_command(const AdaptCommand& command) {
  if (command.sources.empty()) return {};
  PlaneSources sources = read_plane_sources(command.sources);
  if (!sources.size.has_value()) return sources;
  const bool has_metric = !command.metric.empty();
  if (has_metric || !command.solution.empty()) {
    throw UsageError("`size` is the size where nothing else is asked for, but " +
                         std::string(has_metric ? "--metric" : "--solution") +
                         " asks for something everywhere: leave it out, or give --h-max",
                     command.sources);
  }
  return sources;
}

void check_what_to_adapt_to(const AdaptCommand& command) {
  if (command.metric.empty() && command.solution.empty() && command.sources.empty()) {
    throw UsageError("say what to adapt to: --metric FILE, --solution FILE or --sources FILE", "");
  }
  if (command.mode != "thesis") return;
  if (!command.sources.empty()) {
    throw UsageError("--mode thesis compares edges with their mean length, and takes no sources",
                     "--sources");
  }
  if (command.vertices.has_value()) {
    throw UsageError(
        "--mode thesis keeps the mean length of the edges that MESH has, and takes no "
        "number of vertices",
        "--vertices");
  }
}

}  // namespace

ExitCode adapt_command(const AdaptCommand& command) {
  check_what_to_adapt_to(command);
  const bool is_thesis = command.mode == "thesis";
  require_plane_input_name(command.input);
  require_plane_output_name(command.output);
  check_curve_options(command.curves);
  const std::int64_t start = steady_ms();
  const PlaneSources written = sources_of_command(command);
  const MetricSources sources = metric_sources_of(written.sources);
  CurvesOfMesh curved =
      curves_of_options(command.curves, read_plane_mesh(command.input), command.corner_angle_deg);
  const bool has_solution = !command.solution.empty();
  AdaptationWish wish;
  wish.metrics = metrics_of_command(command, curved, written);
  wish.metric_name = has_solution ? command.solution : command.metric;
  wish.limits = {command.h_min.value_or(0), command.h_max.value_or(0), command.aspect,
                 gradation_of(command.gradation, has_solution && !is_thesis ? 1.4 : 0)};
  wish.vertices = command.vertices;
  if (has_solution && command.mode == "lp" && !wish.vertices.has_value()) {
    wish.vertices = static_cast<std::int64_t>(curved.mesh.points.size());
  }
  AdaptationOptions options;
  options.corner_angle_deg = command.corner_angle_deg;
  options.curves = curved.curves;
  if (is_thesis) {
    options.rules = EdgeRules::mean_length;
    options.cavity.rings = 1;
  }
  AdaptedTelling telling{"adapt", command.output, command.json, start, &curved};
  if (sources.size() > 0) {
    options.sources = &sources;
    telling.sources = &written;
    telling.sources_file = command.sources;
  }
  curved.mesh.triangles = std::vector<TriangleComplex::Nodes>();  // the complex has them
  const AdaptedMesh adapted =
      adapt_to_metric(curved.mesh, curved.complex, std::move(wish), options);
  curved.complex = TriangleComplex();  // what is written next takes as much room again
  if (!has_solution && command.metric.empty()) check_that_sources_act(telling, adapted);
  write_plane_mesh(adapted.result.mesh, command.output);
  tell_adapted(telling, adapted);
  return ExitCode::ok;
}

}  // namespace tetfarm
