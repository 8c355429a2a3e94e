#include "worker/adapt_task.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/solution_metric.h"
#include "mesh/adaptation/solution_transfer.h"
#include "mesh/formats/plane/number_fields.h"
#include "mesh/job_file/loop_job.h"
#include "tasks/adapt_contract.h"
#include "worker/curve_option.h"
#include "worker/cycle_figures.h"
#include "worker/metric_source_file.h"
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
  AdaptationWish wish;
  wish.metrics = metrics_of_solution(complex, fields_to_adapt_to(solution, job.fields),
                                     {job.mode == "lp", job.norm});
  wish.metric_name = "the solution";
  wish.limits = {job.h_min, job.h_max, job.aspect, job.gradation};
  wish.vertices = job.vertices;
  if (!wish.vertices) wish.vertices = static_cast<std::int64_t>(mesh.points.size());
  AdaptationOptions options;
  options.corner_angle_deg = job.corner_angle_deg;
  options.curves = curves;
  const MetricSources sources = metric_sources_of(job.sources);
  if (sources.size() > 0) options.sources = &sources;
  return adapt_to_metric(mesh, complex, std::move(wish), options);
}

TransferMethod method_of(const LoopAdaptation& job) {
  return job.transfer == "linear" ? TransferMethod::linear : TransferMethod::conservative;
}

struct BroughtAlong {
  NodeFields fields;
  double gain = 0;  ///< of the integral of the first field of numbers
};

/// The solution on the new mesh; of vectors each component.
BroughtAlong brought_along(const PlaneMesh& from, const NodeFields& solution, const PlaneMesh& to,
                           TransferMethod method) {
  const std::vector<NumberField> fields = number_fields(solution);
  std::vector<std::vector<double>> numbers;
  for (const NumberField& field : fields) numbers.push_back(field.values);
  TransferredSolution after = transfer_solution(from, numbers, solution.metrics, to, method);
  BroughtAlong result;
  const auto first = std::find_if(fields.begin(), fields.end(),
                                  [](const NumberField& field) { return !field.is_component; });
  if (first != fields.end()) {
    result.gain = after.fields[static_cast<std::size_t>(first - fields.begin())].gain;
  }
  std::vector<std::vector<double>> brought;
  for (TransferredField& field : after.fields) brought.push_back(std::move(field.values));
  result.fields = assembled_fields(solution, std::move(brought), std::move(after.metrics));
  return result;
}

CurvesOfMesh curves_of_job(const TaskIo& io, const AdaptGiven& given, const LoopAdaptation& job) {
  const std::vector<std::string> files = spline_files(job.curves);
  const auto place = [&](const std::string& typed) {
    const auto number = std::find(files.begin(), files.end(), typed) - files.begin() + 1;
    return io.path(file_of_leaf(given.splines, static_cast<std::uint64_t>(number)));
  };
  return curves_of_options(job.curves, read_plane_medit(io.path(given.mesh)), job.corner_angle_deg,
                           place);
}

}  // namespace

void adapt_task(TaskIo& io) {
  const auto given = io.given<AdaptGiven>();
  const LoopAdaptation job = parse_loop_job(io.read(given.job), "job.toml").adapt;
  const NodeFields solution = read_plane_sol(io.path(given.solution));
  report_cost(io,
              cost_of(AdaptGiven::kind, {.input_bytes = static_cast<double>(given.mesh.size)}, {}));
  io.progress().begin(WorkStage::adapt);
  const CurvesOfMesh curved = curves_of_job(io, given, job);
  const PlaneMesh& mesh = curved.mesh;
  const AdaptedMesh next = adapted(mesh, curved.complex, solution, job, curved.curves);
  io.progress().begin(WorkStage::transfer);
  const BroughtAlong start = brought_along(mesh, solution, next.result.mesh, method_of(job));
  const MetricQuality quality =
      metric_quality(checked_complex(next.result.mesh), next.result.metrics);
  AdaptMade made;
  made.figures = io.publish(cycle_figures(next.result.mesh, quality, start.gain));
  made.mesh = io.publish(medit_text(next.result.mesh));
  made.start = io.publish(sol_text(start.fields));
  io.made(made);
  io.number("vertices", static_cast<double>(next.result.mesh.points.size()));
  io.number("triangles", static_cast<double>(next.result.mesh.triangles.size()));
  io.number("unit_edges_percent", quality.unit_edges_percent);
  io.number("quality_min", quality.quality_min);
}

}  // namespace tetfarm
