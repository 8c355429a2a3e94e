#include "worker/job_remeshing.h"

#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/remeshing/surface_features.h"
#include "worker/checked_input.h"
#include "worker/job_domain.h"
#include "worker/job_patch_sizes.h"

namespace tetfarm {
namespace {

/// Regions are found anew, and must be the same ones.
CheckedSurface checked_anew(const JobFile& job, const SurfaceMesh& made) {
  SurfaceMesh plain = made;
  plain.sides.clear();
  plain.region_names.clear();
  CheckedSurface checked = check_surface(plain, region_rules_of(job));
  if (checked.report.defects.empty()) return checked;
  throw Error(ExitCode::failed, "the remeshed surface is not sound, which is a fault of Tetfarm: " +
                                    checked.report.defects.front().message);
}

}  // namespace

RemeshOptions remesh_options_of(const JobFile& job, const SurfaceMesh& surface) {
  TF_CHECK(job.remeshing.has_value());
  require_patch_sizes(job, own_patch_names(job, surface));
  SpacingOptions spacing = spacing_options_of(job, surface);
  RemeshOptions options;
  options.size = job.remeshing->size > 0 ? job.remeshing->size : spacing.background;
  options.min_size = job.remeshing->min_size;
  options.angle_deg = job.remeshing->angle;
  options.tolerance = job.remeshing->tolerance;
  options.growth = spacing.growth;
  options.sources = std::move(spacing.sources);
  options.triangles = std::move(spacing.triangles);
  return with_defaults(std::move(options), surface);
}

JobRemeshed remesh_for_job(const JobFile& job, const SurfaceMesh& surface) {
  const RemeshOptions options = remesh_options_of(job, surface);
  const SurfaceFeatures features = surface_features(surface, options.angle_deg);
  RemeshingSpacing spacing = remeshing_spacing(surface, features, options);
  RemeshedSurface made = remesh(surface, features, spacing, options);
  CheckedSurface checked = checked_anew(job, made.surface);
  return {std::move(made), std::move(spacing), std::move(checked)};
}

CheckedSurface surface_to_mesh(const JobFile& job, CheckedSurface given) {
  if (!job.remeshing) return given;
  return remesh_for_job(job, given.surface).checked;
}

}  // namespace tetfarm
