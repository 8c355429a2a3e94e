#include "worker/write_task.h"

#include <utility>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/assemble/portion.h"
#include "mesh/assemble/unforced_tets.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/layers/top_jumps.h"
#include "tasks/ratio_histogram.h"
#include "tasks/write_contract.h"
#include "worker/leaf_inputs.h"
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

MeshPart read_part(const TaskIo& io, const WriteGiven& given, std::int32_t regions) {
  if (!given.colours) return part_as_meshed(io, given);
  const TreePath leaf{io.assign().path()};
  MeshPart part = part_after_cosmetics(io, given, leaf, colours_of(*given.colours));
  part.subdomain.region = region_of_leaf(leaf, regions);
  return part;
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

/// How the tets on top of the layers fit to the last prisms.
void report_top_jumps(TaskIo& io, const TaskFile& heights, const MeshPart& part) {
  const std::vector<Origin>& origins = part.subdomain.node_origin;
  const std::vector<std::uint64_t> firsts = firsts_of_top(origins);
  if (firsts.empty()) return;
  const std::vector<TopHeight> below = io.look_into(heights, [&](const auto& path) {
    return TopHeightsFile(path, io.name_of(heights)).with_first(firsts);
  });
  RatioHistogram jumps;
  for (const double jump : top_jumps(part.mesh, origins, below)) jumps.add(jump);
  if (jumps.count() > 0) io.text("top_jumps", jumps.text());
}

}  // namespace

void write_task(TaskIo& io) {
  const auto given = io.given<WriteGiven>();
  SurfaceInput surface(io, given.surface);
  NumberingInput numbering(io, given.numbering, surface);
  io.progress().begin(WorkStage::write);
  MeshPart part = read_part(io, given, numbering.regions());
  const auto tets = static_cast<double>(part.mesh.tets.size());
  report_cost(io, write_cost(tets));
  const Subdomain& leaf = part.subdomain;
  const LeafNumbering numbers = numbering.leaf({leaf.path, leaf.region, leaf.node_origin});
  const SurfacePieces pieces = surface.pieces(surface_pieces(leaf));
  if (given.top_heights) report_top_jumps(io, *given.top_heights, part);
  Portion portion = make_portion(std::move(part), pieces, numbers);
  place_in_shared_file(io, {given.job, given.surface, given.numbering}, surface, numbers, portion);
  io.number("tets", tets);
  report_unforced(io, unforced_tets(portion, numbers.is_forced));
  WriteMade made;
  made.portion = io.publish(portion_to_bytes(portion));
  made.tets = io.publish(portion_cells_to_bytes(portion));
  io.made(made);
}

}  // namespace tetfarm
