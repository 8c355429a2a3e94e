#include "worker/remesh_task.h"

#include <string>

#include "base/error.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/remeshing/remeshing_figures.h"
#include "tasks/remesh_contract.h"
#include "worker/checked_input.h"
#include "worker/job_remeshing.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

void report_figures(TaskIo& io, const RemeshingFigures& figures) {
  io.number("remesh_triangles_before", static_cast<double>(figures.triangles_before));
  io.number("remesh_triangles", static_cast<double>(figures.triangles));
  io.number("remesh_smallest_angle_deg", figures.smallest_angle_deg);
  io.number("remesh_distance_from_input", figures.from_input.distance);
  io.number("remesh_distance_to_input", figures.to_input.distance);
}

}  // namespace

void remesh_task(TaskIo& io) {
  const auto given = io.given<RemeshGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  if (!job.remeshing) throw OwnDefect("the job does not ask for remeshing", {});
  const CheckedInput input = checked_input(io, job, given.input_surface);
  io.progress().begin(WorkStage::remeshing);
  JobRemeshed remeshed = remesh_for_job(job, input.checked.surface);
  const RemeshingFigures figures =
      remeshing_figures(input.checked.surface, remeshed.made, remeshed.spacing);
  report_figures(io, figures);
  report_cost(io, remesh_cost(input.bytes,
                              static_cast<double>(figures.triangles_before + figures.triangles)));
  // As a surface that was given: its regions are found by who inspects it.
  SurfaceMesh& surface = remeshed.made.surface;
  surface.sides.clear();
  surface.region_names.clear();
  io.made(RemeshMade{io.publish(surface_to_bytes(surface))});
}

}  // namespace tetfarm
