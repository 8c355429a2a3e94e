#include "worker/checked_input.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/counted.h"
#include "base/job_name.h"
#include "mesh/core/complaints.h"
#include "mesh/formats/gzip.h"
#include "mesh/half_body/close_half_body.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/spacing/spacing_field.h"
#include "worker/evidence.h"
#include "worker/job_domain.h"
#include "worker/job_patch_sizes.h"
#include "worker/job_surface.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

/// A file that the coordinator took as it was may be packed.
std::string unpacked(std::string bytes, const std::string& name) {
  return is_gzip(bytes) ? unpack_gzip(bytes, name) : std::move(bytes);
}

struct InputSurface {
  SurfaceMesh surface;
  double bytes = 0;
};

InputSurface read_input(const TaskIo& io, const JobFile& job, const TaskFile& file) {
  const std::string bytes = io.read(file, unpacked);
  return {read_surface_of_job(job, bytes, job.surface), static_cast<double>(bytes.size())};
}

CheckedSurface checked_surface(TaskIo& io, const JobFile& job, SurfaceMesh surface) {
  io.progress().begin(WorkStage::check);
  CheckedSurface checked = check_surface_of_job(job, std::move(surface));
  if (checked.report.defects.empty()) return checked;
  const std::string defects = defects_as_vtp(io, checked.surface, checked.report.defects);
  throw RefusedInput(defects_text(checked.report.defects),
                     {{file_name_of_job(job.name, ".defects.vtp"), defects}});
}

/// Of half a body, with its outer boundary but without the plane that closes it.
SpacingOptions options_of_open(const JobFile& job, const SurfaceMesh& open) {
  JobFile without_plane = job;
  without_plane.symmetry.reset();
  std::vector<std::string> own = patch_names_of(open);
  own.resize(own.size() - std::min(added_patches(without_plane), own.size()));
  SpacingOptions options = spacing_options_of(job);
  options.triangles = patch_demands(job, open, own);
  return options;
}

}  // namespace

RegionRules region_rules_of(const JobFile& job) {
  RegionRules rules;
  rules.is_outside_meshed = job.outer_kind != "none" && !job.symmetry;
  for (const JobRegion& region : job.regions) {
    rules.wishes.push_back({region.at, region.name, region.is_void});
  }
  return rules;
}

CheckedSurface check_surface_of_job(const JobFile& job, SurfaceMesh surface) {
  if (!job.symmetry) return check_surface(std::move(surface), region_rules_of(job));
  const auto make_spacing = [&job](const SurfaceMesh& open) {
    const auto field =
        std::make_shared<SpacingField>(make_spacing_field(open, options_of_open(job, open)));
    return [field](const Vec3& place) { return field->at(place); };
  };
  ClosedHalfBody closed =
      close_half_body(surface, *job.symmetry, outer_boundary_of(job), job.growth, make_spacing);
  CheckedSurface checked = check_surface(std::move(closed.surface), region_rules_of(job));
  if (closed.ends.moved > 0) {
    checked.report.remarks.push_back(
        counted(static_cast<std::uint64_t>(closed.ends.moved), "vertex", "vertices") +
        " on open edges moved onto the plane of symmetry " + closed.ends.plane.text() +
        ", by at most " + text_of(closed.ends.farthest_move));
  }
  return checked;
}

CheckedInput checked_input(TaskIo& io, const JobFile& job, const TaskFile& file) {
  io.progress().begin(WorkStage::read);
  InputSurface input = read_input(io, job, file);
  return {checked_surface(io, job, std::move(input.surface)), input.bytes};
}

}  // namespace tetfarm
