#include "worker/checked_input.h"

#include <utility>

#include "base/job_name.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/defect_text.h"
#include "worker/evidence.h"

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
  return {read_surface_bytes(bytes, job.surface), static_cast<double>(bytes.size())};
}

CheckedSurface checked_surface(TaskIo& io, const JobFile& job, const SurfaceMesh& surface) {
  io.progress().begin(WorkStage::check);
  CheckedSurface checked = check_surface(surface, region_rules_of(job));
  if (checked.report.defects.empty()) return checked;
  const std::string defects = defects_as_vtp(io, surface, checked.report.defects);
  throw RefusedInput(defects_text(checked.report.defects),
                     {{file_name_of_job(job.name, ".defects.vtp"), defects}});
}

}  // namespace

RegionRules region_rules_of(const JobFile& job) {
  RegionRules rules;
  rules.is_outside_meshed = job.outer_kind != "none";
  for (const JobRegion& region : job.regions) {
    rules.wishes.push_back({region.at, region.name, region.is_void});
  }
  return rules;
}

CheckedInput checked_input(TaskIo& io, const JobFile& job, const TaskFile& file) {
  io.progress().begin(WorkStage::read);
  const InputSurface input = read_input(io, job, file);
  return {checked_surface(io, job, input.surface), input.bytes};
}

}  // namespace tetfarm
