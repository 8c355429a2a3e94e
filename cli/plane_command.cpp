#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/error.h"
#include "cli/adapted_report.h"
#include "cli/commands.h"
#include "mesh/adaptation/adapt_to_metric.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/loop_domain.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_meshb.h"
#include "mesh/formats/plane/read_loops.h"
#include "worker/curve_option.h"
#include "worker/metric_source_file.h"

namespace tetfarm {
namespace {

/// The file's name without its ending, and with a number where the file has several loops.
std::string patch_name_of_loop(const std::string& file, std::size_t loop, std::size_t loops) {
  const std::string stem = std::filesystem::path(file).stem().string();
  return loops > 1 ? stem + "_" + std::to_string(loop + 1) : stem;
}

/// Of all files, each loop a patch, numbered from 1.
std::vector<DomainLoop> loops_of(const std::vector<std::string>& files) {
  std::vector<DomainLoop> loops;
  for (const std::string& file : files) {
    std::vector<PlaneLoop> of_file = read_loops(file);
    for (std::size_t k = 0; k < of_file.size(); ++k) {
      const auto patch = static_cast<std::int32_t>(loops.size()) + 1;
      loops.push_back({std::move(of_file[k].points), patch, std::move(of_file[k].where),
                       patch_name_of_loop(file, k, of_file.size())});
    }
  }
  return loops;
}

/// What is asked for on the domain, or, where the edges of the loops say the sizes, on one with
/// points inside.
MeshWithMetrics wish_of(const PlaneCommand& command, const std::optional<double>& size,
                        PlaneMesh domain) {
  if (size.has_value()) {
    const Metric2 metric = metric_of_sizes({*size, *size, 0});
    std::vector<Metric2> metrics(domain.points.size(), metric);
    return {std::move(domain), std::move(metrics)};
  }
  if (command.metric.empty()) return sized_by_boundary(domain);
  NodeFields fields = read_plane_fields(command.metric);
  if (fields.metrics.size() != 1) {
    throw InvalidInput("has " + std::to_string(fields.metrics.size()) +
                           " symmetric tensors at each point; a metric is one",
                       command.metric);
  }
  check_metrics(domain, fields.metrics.front(), command.metric);
  return {std::move(domain), std::move(fields.metrics.front())};
}

}  // namespace

ExitCode plane_command(const PlaneCommand& command) {
  require_plane_output_name(command.output);
  check_curve_options(command.curves);
  const std::int64_t start = steady_ms();
  PlaneSources written;
  if (!command.sources.empty()) written = read_plane_sources(command.sources);
  const MetricSources sources = metric_sources_of(written.sources);
  const std::optional<double> size =
      command.size.has_value() || !command.metric.empty() ? command.size : written.size;
  const CurvesOfMesh curved = curves_of_options(
      command.curves, domain_of_loops(loops_of(command.inputs)), command.corner_angle_deg);
  MeshWithMetrics asked = wish_of(command, size, curved.mesh);
  const bool is_by_boundary = !size.has_value() && command.metric.empty();
  AdaptationWish wish;
  wish.metrics = std::move(asked.metrics);
  wish.metric_name = command.metric;
  wish.vertices = command.vertices;
  wish.limits.gradation = gradation_of(command.gradation, is_by_boundary ? 1.25 : 0);
  AdaptationOptions options;
  options.corner_angle_deg = command.corner_angle_deg;
  options.curves = curved.curves;
  AdaptedTelling telling{"plane", command.output, command.json, start, &curved};
  if (sources.size() > 0) {
    options.sources = &sources;
    telling.sources = &written;
    telling.sources_file = command.sources;
  }
  const AdaptedMesh adapted =
      adapt_to_metric(asked.mesh, checked_complex(asked.mesh), std::move(wish), options);
  check_that_sources_act(telling, adapted);
  write_plane_mesh(adapted.result.mesh, command.output);
  tell_adapted(telling, adapted);
  return ExitCode::ok;
}

}  // namespace tetfarm
