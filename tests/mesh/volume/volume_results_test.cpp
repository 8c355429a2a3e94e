// Volume meshes of small surfaces, known by their digests (tests/golden/volume.txt): nodes, tets,
// what was reported, how far it was told to have come, and why there is no mesh.
#include <gtest/gtest.h>

#include "tests/mesh/recovery/blocked_surfaces.h"
#include "tests/support/result_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void add_outcome(ResultDigest& result, const Subdomain& domain, const SpacingField& spacing,
                 VolumeMeshOptions options) {
  options.progress = result.listener();
  VolumeMeshReport report;
  const VolumeOutcome outcome = mesh_volume(domain, spacing, options, &report);
  result.add(report.missing_edges, report.missing_faces, report.boundary_steiner_points,
             report.interior_steiner_points, report.cosmetic_attempts);
  result.add(report.lattice.visits.cells, report.lattice.visits.questions, report.lattice.listed,
             report.lattice.inside);
  result.add(outcome.mesh.has_value(), outcome.failure.cause, outcome.failure.message,
             outcome.failure.triangles);
  if (outcome.mesh) {
    result.add(outcome.mesh->nodes, outcome.mesh->tets, outcome.mesh->boundary_nodes);
  }
}

TEST(VolumeResults, of_surfaces_that_are_in_the_way_of_recovery_are_known) {
  VolumeMeshOptions sweeps;
  sweeps.points = InteriorPoints::sweeps;
  VolumeMeshOptions empty;
  empty.fill = false;
  VolumeMeshOptions raw;
  raw.cosmetics = false;
  for (const auto& [name, surface] : shapes::blocked_surfaces()) {
    // Of the stars and grids most look alike to all but recovery, or have many tets.
    const bool is_one_of_many = name.starts_with("star") && name != "star_0";
    if (is_one_of_many || name.starts_with("grid") || surface.triangles.size() > 80 ||
        name == "slits_2") {
      continue;
    }
    const Subdomain domain = root_subdomain(surface);
    const SpacingField spacing(0.4);
    ResultDigest result;
    for (const VolumeMeshOptions& options : {VolumeMeshOptions{}, sweeps, empty, raw}) {
      add_outcome(result, domain, spacing, options);
    }
    test::expect_known("volume", name, result);
  }
}

TEST(VolumeResults, of_a_ball_with_a_core_of_the_lattice_are_known) {
  ResultDigest result;
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 3));
  add_outcome(result, domain, SpacingField(0.17), {});
  test::expect_known("volume", "ball", result);
}

}  // namespace
}  // namespace tetfarm
