#include "worker/write_task.h"

#include <algorithm>
#include <utility>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/assemble/forced_nodes.h"
#include "mesh/assemble/portion.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_formats.h"
#include "tasks/write_contract.h"
#include "worker/part_after_cosmetics.h"
#include "worker/shared_mesh_file.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

MeshPart part_as_meshed(const TaskIo& io, const WriteGiven& given) {
  MeshPart part;
  part.subdomain = io.read(given.subdomain, subdomain_from_bytes);
  part.mesh = io.read(given.mesh, [&part](const std::string& bytes, const std::string& name) {
    return tet_mesh_from_bytes(bytes, part.subdomain, name);
  });
  part.is_on_cut = nodes_on_cuts(part.subdomain);
  return part;
}

MeshPart read_part(const TaskIo& io, const WriteGiven& given, const SurfaceMesh& surface) {
  if (!given.colours) return part_as_meshed(io, given);
  const TreePath leaf{io.assign().path()};
  MeshPart part = part_after_cosmetics(io, given, leaf, colours_of(*given.colours));
  part.subdomain.region = region_of_leaf(leaf, region_count(surface));
  return part;
}

/// Where it may, it writes into the file of all. The portion says the same if it may not: the same
/// inputs give the same bytes, wherever the task runs.
void place(const TaskIo& io, const WriteGiven& given, const SurfaceMesh& surface,
           const Numbering& numbering, Portion& portion) {
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  const std::vector<std::string> formats = formats_of_tasks(job.formats);
  const bool is_wanted = std::find(formats.begin(), formats.end(), "vtkhdf") != formats.end();
  if (!is_wanted || !knows_places(numbering)) return;
  SharedFile file = shared_mesh_file(io, given.surface, given.numbering);
  if (io.is_apart()) file.path.clear();
  portion.placed = place_cells(file, portion.part, numbering, surface);
}

/// What the job's gate on unforced angles is judged by, all leaves together.
void report_unforced(TaskIo& io, const UnforcedTets& unforced) {
  io.number("unforced_elements", static_cast<double>(unforced.tets));
  if (unforced.tets == 0) return;
  io.number("unforced_min_dihedral_deg", unforced.min_dihedral_deg);
  io.number("unforced_worst_x", unforced.worst_centroid.x);
  io.number("unforced_worst_y", unforced.worst_centroid.y);
  io.number("unforced_worst_z", unforced.worst_centroid.z);
}

}  // namespace

void write_task(TaskIo& io) {
  const auto given = io.given<WriteGiven>();
  const SurfaceMesh surface = io.read(given.surface, surface_from_bytes);
  const Numbering numbering = io.read(given.numbering, numbering_from_text);
  io.progress().begin(WorkStage::write);
  MeshPart part = read_part(io, given, surface);
  const auto tets = static_cast<double>(part.mesh.tets.size());
  report_cost(io, write_cost(static_cast<double>(surface.triangles.size()), tets));
  Portion portion = make_portion(std::move(part), surface, numbering);
  place(io, given, surface, numbering, portion);
  io.number("tets", tets);
  report_unforced(io, unforced_tets(portion, surface, numbering));
  WriteMade made;
  made.portion = io.publish(portion_to_bytes(portion));
  made.tets = io.publish(portion_cells_to_bytes(portion));
  io.made(made);
}

}  // namespace tetfarm
