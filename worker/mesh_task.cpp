#include "worker/mesh_task.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/core/tet_quality.h"
#include "mesh/core/validate.h"
#include "mesh/job_file/job_file.h"
#include "mesh/library/leaf_mesh.h"
#include "tasks/mesh_contract.h"
#include "worker/decompose_task.h"
#include "worker/evidence.h"
#include "worker/spacing_input.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// The job's words in the terms of mesh/volume.
VolumeMeshOptions volume_options_of(const JobFile& job) {
  VolumeMeshOptions options;
  options.points = job.points == "sweeps" ? InteriorPoints::sweeps : InteriorPoints::lattice;
  return options;
}

LeafMeshers real_meshers(TaskIo& io, const JobFile& job, const SpacingField& spacing) {
  VolumeMeshOptions options = volume_options_of(job);
  options.progress = io.progress();
  CutOptions cutting;
  cutting.planes = cut_planes_of(job);
  cutting.progress = io.progress();
  return leaf_meshers(spacing, options, std::move(cutting));
}

TetMesh mesh_or_refuse(TaskIo& io, const JobFile& job, const Subdomain& leaf,
                       const SpacingField& spacing) {
  VolumeOutcome outcome = leaf_mesh(leaf, real_meshers(io, job, spacing));
  if (outcome.mesh) return *std::move(outcome.mesh);
  const VolumeFailure& failure = outcome.failure;
  if (failure.cause == VolumeFailure::Cause::same_place) {
    throw refused_subdomain(io, leaf, failure.message, failure.triangles);
  }
  throw unrecovered_subdomain(io, leaf, failure.message, failure.triangles);
}

double smallest_dihedral_deg(const TetMesh& mesh) {
  double cosine = -1;
  const auto at = [&mesh](std::int32_t v) { return mesh.nodes[static_cast<std::size_t>(v)]; };
  for (const Tet& t : mesh.tets) {
    if (!may_have_smaller_dihedral(at(t[0]), at(t[1]), at(t[2]), at(t[3]), cosine)) continue;
    const DihedralCosines here = dihedral_cosines(at(t[0]), at(t[1]), at(t[2]), at(t[3]));
    cosine = std::max(cosine, here.of_smallest);
  }
  return std::acos(cosine) * 180 / std::numbers::pi;
}

}  // namespace

void mesh_task(TaskIo& io) {
  const auto given = io.given<MeshGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  const Subdomain leaf = io.read(given.subdomain, subdomain_from_bytes);
  const SpacingField spacing = spacing_input(io, given.spacing);
  report_cost(io, mesh_cost(size_of(leaf, static_cast<double>(given.work), given.spacing)));
  const TetMesh mesh = mesh_or_refuse(io, job, leaf, spacing);
  io.progress().begin(WorkStage::validate);
  const std::vector<std::string> complaints = validate(mesh, leaf.triangles);
  if (!complaints.empty()) {
    throw Error(ExitCode::failed, "sub-domain " + leaf.path.text() +
                                      ": the mesh is not valid: " + complaints.front());
  }
  io.number("min_dihedral_deg", smallest_dihedral_deg(mesh));
  MeshMade made;
  made.mesh = io.publish(tet_mesh_to_bytes(mesh));
  made.interior_nodes = mesh.nodes.size() - static_cast<std::size_t>(mesh.boundary_nodes);
  made.tets = mesh.tets.size();
  io.made(made);
}

}  // namespace tetfarm
