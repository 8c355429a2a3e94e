#include "worker/adapt_task.h"

#include <utility>
#include <vector>

#include "base/file_system.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/solution_metric.h"
#include "mesh/adaptation/solution_transfer.h"
#include "mesh/formats/plane/plane_medit.h"
#include "mesh/job_file/loop_job.h"
#include "tasks/adapt_contract.h"
#include "worker/curve_option.h"
#include "worker/cycle_figures.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// Those that the job names by their numbers; without names all.
std::vector<std::vector<double>> fields_to_adapt_to(const NodeFields& solution,
                                                    const std::vector<std::int64_t>& numbers) {
  if (solution.scalars.empty()) {
    throw InvalidInput("has no numbers at the nodes: a scalar field has kind 1", "the solution");
  }
  if (numbers.empty()) return solution.scalars;
  std::vector<std::vector<double>> fields;
  for (const std::int64_t number : numbers) {
    const auto place = static_cast<std::size_t>(number - 1);
    if (place >= solution.scalars.size()) {
      throw InvalidInput("has " + std::to_string(solution.scalars.size()) +
                             " fields of numbers; `fields` of the job names field " +
                             std::to_string(number),
                         "the solution");
    }
    fields.push_back(solution.scalars[place]);
  }
  return fields;
}

AdaptedMesh adapted(const PlaneMesh& mesh, const TriangleComplex& complex,
                    const NodeFields& solution, const LoopAdaptation& job,
                    const std::vector<PatchCurve>& curves) {
  const std::vector<Metric2> metrics = metrics_of_solution(
      complex, fields_to_adapt_to(solution, job.fields), {job.mode == "lp", job.norm});
  AdaptationWish wish;
  wish.metrics = metrics;
  wish.metric_name = "the solution";
  wish.limits = {job.h_min, job.h_max, job.aspect, job.gradation};
  wish.vertices = job.vertices;
  if (!wish.vertices) wish.vertices = static_cast<std::int64_t>(mesh.points.size());
  AdaptationOptions options;
  options.corner_angle_deg = job.corner_angle_deg;
  options.curves = curves;
  return adapt_to_metric(mesh, complex, wish, options);
}

TransferMethod method_of(const LoopAdaptation& job) {
  return job.transfer == "linear" ? TransferMethod::linear : TransferMethod::conservative;
}

/// Vectors are carried over component by component.
std::vector<std::vector<double>> components_of(const NodeFields& solution) {
  std::vector<std::vector<double>> all = solution.scalars;
  for (const std::vector<Vec2>& field : solution.vectors) {
    for (double Vec2::*const component : {&Vec2::x, &Vec2::y}) {
      std::vector<double>& values = all.emplace_back();
      for (const Vec2& v : field) values.push_back(v.*component);
    }
  }
  return all;
}

NodeFields with_components(const NodeFields& before, TransferredSolution after) {
  NodeFields fields;
  fields.order = before.order;
  auto next = after.fields.begin();
  for (std::size_t k = 0; k < before.scalars.size(); ++k) {
    fields.scalars.push_back(std::move((next++)->values));
  }
  for (std::size_t k = 0; k < before.vectors.size(); ++k) {
    const std::vector<double> x = std::move((next++)->values);
    const std::vector<double> y = std::move((next++)->values);
    std::vector<Vec2>& field = fields.vectors.emplace_back();
    for (std::size_t v = 0; v < x.size(); ++v) field.push_back({x[v], y[v]});
  }
  fields.metrics = std::move(after.metrics);
  return fields;
}

}  // namespace

void adapt_task(TaskIo& io) {
  const auto given = io.given<AdaptGiven>();
  const LoopAdaptation job = parse_loop_job(io.read(given.job), "job.toml").adapt;
  const PlaneMesh read = read_plane_medit(io.path(given.mesh));
  const NodeFields solution = read_plane_sol(io.path(given.solution));
  report_cost(io,
              cost_of(AdaptGiven::kind, {.input_bytes = static_cast<double>(given.mesh.size)}, {}));
  io.progress().begin(WorkStage::adapt);
  const CurvesOfMesh curved =
      curves_of_options(job.curves, read, checked_complex(read), job.corner_angle_deg);
  const PlaneMesh& mesh = curved.mesh;
  const TriangleComplex complex = checked_complex(mesh);
  const AdaptedMesh next = adapted(mesh, complex, solution, job, curved.curves);
  io.progress().begin(WorkStage::transfer);
  TransferredSolution start = transfer_solution(mesh, components_of(solution), solution.metrics,
                                                next.result.mesh, method_of(job));
  const MetricQuality quality =
      metric_quality(checked_complex(next.result.mesh), next.result.metrics);
  AdaptMade made;
  made.figures = io.publish(
      cycle_figures(next.result.mesh, quality, start.fields.empty() ? 0 : start.fields[0].gain));
  made.mesh = io.publish(medit_text(next.result.mesh));
  const std::filesystem::path path = io.scratch_path("start.sol");
  write_plane_sol(with_components(solution, std::move(start)), path);
  made.start = io.publish(read_file(path));
  io.made(made);
  io.number("vertices", static_cast<double>(next.result.mesh.points.size()));
  io.number("triangles", static_cast<double>(next.result.mesh.triangles.size()));
  io.number("unit_edges_percent", quality.unit_edges_percent);
  io.number("quality_min", quality.quality_min);
}

}  // namespace tetfarm
