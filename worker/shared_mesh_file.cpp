#include "worker/shared_mesh_file.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/hash.h"
#include "mesh/job_file/job_formats.h"
#include "worker/job_patch_types.h"

namespace tetfarm {
namespace {

std::vector<CellMark> marks_of_job(const JobFile& job) {
  std::vector<CellMark> marks;
  if (!job.layers.empty()) marks.push_back(CellMark::layer);
  if (job.pml) marks.insert(marks.end(), {CellMark::pml_depth, CellMark::pml_axes});
  return marks;
}

}  // namespace

SharedFile shared_mesh_file(const TaskIo& io, const TaskFile& surface, const TaskFile& numbering) {
  const std::string what =
      io.assign().job() + '\n' + surface.hash + '\n' + numbering.hash + "\npacked";
  const std::string name = "mesh." + hash128(what).hex() + ".vtkhdf";
  return {io.is_without_shared_store() ? io.scratch_path(name) : io.store().scratch_folder() / name,
          io.scratch_path("frame.vtkhdf")};
}

bool has_feet(const JobFile& job) { return !job.layers.empty() || job.pml; }

VtkhdfNames names_of_file(const JobFile& job, const std::vector<std::string>& patches,
                          const std::vector<std::string>& regions) {
  return {patches, regions, marks_of_job(job), has_feet(job), patch_types_of(job, patches)};
}

void place_in_shared_file(const TaskIo& io, const SharedMesh& mesh, const SurfaceInput& surface,
                          const LeafNumbering& numbering, Portion& portion) {
  const JobFile job = parse_job_file(io.read(mesh.job), "job.toml");
  const std::vector<std::string> formats = formats_of_tasks(job.formats);
  const bool is_wanted = std::find(formats.begin(), formats.end(), "vtkhdf") != formats.end();
  if (!is_wanted || !numbering.first_face) return;
  SharedFile file = shared_mesh_file(io, mesh.surface, mesh.numbering);
  if (io.is_without_shared_store()) file.path.clear();
  portion.placed = place_cells(file, portion.part, numbering,
                               names_of_file(job, surface.patch_names(), surface.region_names()));
}

}  // namespace tetfarm
