#include "mesh/volume/volume_mesh.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"
#include "mesh/core/tet_complex.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/filling/lattice_filling.h"
#include "mesh/filling/sweep_points.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"

namespace tetfarm {
namespace {

constexpr std::int32_t enclosing_nodes = 4;

/// Triangles at a node of the boundary: the place of an error.
std::vector<std::int32_t> triangles_at(const Subdomain& subdomain, std::int32_t node) {
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < subdomain.triangles.size(); ++i) {
    const Triangle& t = subdomain.triangles[i];
    if (t[0] == node || t[1] == node || t[2] == node) found.push_back(static_cast<std::int32_t>(i));
  }
  return found;
}

DelaunayTets boundary_delaunay(const Subdomain& subdomain, const WorkProgress& progress) {
  constexpr int tell_every = 1 << 12;
  progress.begin(WorkStage::boundary, subdomain.vertices.size(), tell_every);
  return bowyer_watson(subdomain.vertices, progress);
}

VolumeOutcome same_place(const Subdomain& subdomain, std::int32_t node) {
  return {.mesh = {},
          .failure = {.cause = VolumeFailure::Cause::same_place,
                      .message = "sub-domain " + subdomain.path.text() +
                                 ": two vertices are at the same place " +
                                 text_of(subdomain.vertices[at(node)]),
                      .triangles = triangles_at(subdomain, node)}};
}

VolumeOutcome not_recovered(const Subdomain& subdomain, const std::vector<std::int32_t>& lost) {
  std::string message = "sub-domain " + subdomain.path.text() + ": " + std::to_string(lost.size()) +
                        (lost.size() == 1 ? " boundary triangle was" : " boundary triangles were") +
                        " not recovered";
  if (!lost.empty()) {
    const Triangle& t = subdomain.triangles[at(lost.front())];
    message += ", the first at " + text_of(subdomain.vertices[at(t[0])]) + ", " +
               text_of(subdomain.vertices[at(t[1])]) + ", " + text_of(subdomain.vertices[at(t[2])]);
  }
  return {.mesh = {},
          .failure = {.cause = VolumeFailure::Cause::not_recovered,
                      .message = std::move(message),
                      .triangles = lost}};
}

/// The complex with points that belong to a tet only; the boundary nodes stay first.
TetMesh compact_mesh(const TetComplex& complex, std::int32_t boundary_nodes) {
  TetMesh mesh = to_tet_mesh(complex, boundary_nodes);
  std::vector<std::int32_t> new_number(mesh.nodes.size(), -1);
  for (const Tet& tet : mesh.tets) {
    for (const std::int32_t v : tet) new_number[at(v)] = 0;
  }
  std::int32_t count = 0;
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) {
    if (new_number[v] < 0 && v >= at(boundary_nodes)) continue;
    new_number[v] = count;
    mesh.nodes[at(count++)] = mesh.nodes[v];
  }
  TF_CHECK(count >= boundary_nodes && at(count) <= mesh.nodes.size());
  mesh.nodes.resize(at(count));
  for (Tet& tet : mesh.tets) {
    for (std::int32_t& v : tet) v = new_number[at(v)];
  }
  return mesh;
}

/// From the Delaunay tets on, with the flips in the order of the seed.
VolumeOutcome mesh_once(const Subdomain& subdomain, const SpacingField& spacing,
                        const VolumeMeshOptions& options, std::uint64_t seed,
                        VolumeMeshReport* report) {
  const auto boundary_nodes = static_cast<std::int32_t>(subdomain.vertices.size());
  DelaunayTets tets = boundary_delaunay(subdomain, options.progress);
  if (!tets.duplicates.empty()) return same_place(subdomain, tets.duplicates.front()[0]);
  TetComplex& complex = tets.complex;
  std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
  const RecoveredBoundary recovered =
      recover_boundary(complex, constrained, subdomain.triangles, seed, options.progress);
  if (report != nullptr) {
    report->missing_edges = recovered.missing_edges;
    report->missing_faces = recovered.missing_faces;
    report->boundary_steiner_points = recovered.splits;
    report->interior_steiner_points = recovered.steiner_points;
  }
  if (!recovered.lost.empty()) return not_recovered(subdomain, recovered.lost);
  const RecoverySurface surface(subdomain.triangles,
                                static_cast<std::int32_t>(complex.points.size()));
  const auto sides = [&] { return inside_tets(LocalRemeshing(complex, constrained), surface); };
  std::vector<std::uint8_t> inside = sides();
  if (inside.empty()) return not_recovered(subdomain, {});
  TF_CHECK(inside.size() == complex.nodes.size());
  PendingCore core;
  if (options.fill) {
    options.progress.begin(WorkStage::points);
    if (options.points == InteriorPoints::lattice) {
      PointInsertionOptions insertion;
      insertion.progress = options.progress;
      core = insert_shell(complex, constrained, inside, subdomain, spacing, insertion);
      if (report != nullptr) report->lattice = core.cost;
    } else {
      SweepOptions sweeps;
      sweeps.progress = options.progress;
      sweep_points(complex, constrained, inside, spacing, sweeps);
    }
    inside = sides();
    if (inside.empty()) return not_recovered(subdomain, {});
  }
  InsideComplex kept = keep_inside(complex, constrained, inside, boundary_nodes, enclosing_nodes);
  complex = TetComplex{};
  TF_CHECK(kept.complex.nodes.size() == kept.constrained.size());
  const GraftedCore grafted = graft_pending_core(kept.complex, kept.constrained, std::move(core),
                                                 boundary_nodes, enclosing_nodes);
  if (options.fill && options.cosmetics) {
    CosmeticOptions cosmetics;
    cosmetics.progress = options.progress;
    cosmetics.spacing = [&spacing](const Vec3& p) { return spacing.at(p); };
    cosmetics.smallest_spacing = spacing.smallest();
    cosmetics.measures_angles = false;
    cosmetics.regular = {grafted.first, grafted.last, grafted.least_height};
    const CosmeticReport improved = improve_mesh(kept.complex, boundary_nodes, cosmetics);
    if (report != nullptr) report->cosmetic_attempts = improved.attempts;
  }
  return {.mesh = compact_mesh(kept.complex, boundary_nodes), .failure = {}};
}

/// Small surfaces get more attempts: they are cheap, and blocked ones are mostly small.
std::uint64_t attempts_for(std::size_t triangles) {
  constexpr std::size_t small_surface = 2000;
  return triangles <= small_surface ? 12 : 2;
}

}  // namespace

VolumeOutcome mesh_volume(const Subdomain& subdomain, const SpacingField& spacing,
                          const VolumeMeshOptions& options, VolumeMeshReport* report) {
  const std::uint64_t attempts = attempts_for(subdomain.triangles.size());
  VolumeOutcome outcome = mesh_once(subdomain, spacing, options, 0, report);
  for (std::uint64_t seed = 1; seed < attempts && !outcome.mesh; ++seed) {
    if (outcome.failure.cause == VolumeFailure::Cause::same_place) break;
    // Another order of the flips meets other obstacles.
    outcome = mesh_once(subdomain, spacing, options, seed, report);
  }
  return outcome;
}

}  // namespace tetfarm
