/// CAD-like surfaces through check_surface and mesh_volume.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <ctime>
#include <string>

#include "mesh/inspect/surface_check.h"
#include "tests/mesh/volume/volume_checks.h"
#include "tests/support/cad_surfaces.h"

namespace tetfarm {

inline std::string name_of(const shapes::SurfaceGenerator& generator, std::uint64_t seed,
                           int size) {
  return std::string(generator.name) + " of size " + std::to_string(size) + ", seed " +
         std::to_string(seed);
}

/// Meshes the surface with points inside and cosmetics, as a leaf of a job, and checks the mesh and
/// what was spent on it. The CPU seconds of meshing, for people.
inline double mesh_cad_surface(const shapes::SurfaceGenerator& generator, std::uint64_t seed,
                               int size) {
  SCOPED_TRACE(name_of(generator, seed, size));
  const CheckedSurface checked =
      check_surface(shapes::moved_exactly(generator.make(seed, size), seed));
  EXPECT_TRUE(checked.report.defects.empty());
  if (!checked.report.defects.empty()) return 0;
  const Subdomain domain = root_subdomain(checked.surface);
  const SpacingField spacing(0.2 * norm(bounding_box(domain.vertices).size()));
  const std::clock_t start = std::clock();
  VolumeMeshReport report;
  const VolumeOutcome outcome = mesh_volume(domain, spacing, {}, &report);
  const auto seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_TRUE(outcome.mesh) << outcome.failure.message;
  if (!outcome.mesh) return seconds;
  EXPECT_LT(report.cosmetic_attempts, 120'000 + 250 * std::ssize(domain.vertices));
  expect_mesh_of(*outcome.mesh, domain);
  return seconds;
}

}  // namespace tetfarm
