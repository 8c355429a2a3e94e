/// Generated surfaces through check_surface and mesh_volume.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <string>

#include "mesh/inspect/surface_check.h"
#include "tests/mesh/volume/volume_checks.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {

enum class Outcome { meshed, refused, invalid };

/// Meshes the surface when check_surface finds it valid, every fourth one with points inside, and
/// checks the mesh. A refusal is printed, so that it can be tried again.
inline Outcome mesh_generated_surface(const shapes::SurfaceGenerator& generator, std::uint64_t seed,
                                      int size) {
  const std::string name = std::string(generator.name) + " of size " + std::to_string(size) +
                           ", seed " + std::to_string(seed);
  SCOPED_TRACE(name);
  const CheckedSurface checked =
      check_surface(shapes::moved_by_chance(generator.make(seed, size), seed));
  if (!checked.report.defects.empty()) return Outcome::invalid;
  const Subdomain domain = root_subdomain(checked.surface);
  VolumeMeshOptions options;
  options.fill = seed % 4 == 3;
  const double spacing = 0.2 * norm(bounding_box(domain.vertices).size());
  const VolumeOutcome outcome = mesh_volume(domain, SpacingField(spacing), options);
  if (!outcome.mesh) {
    EXPECT_EQ(outcome.failure.cause, VolumeFailure::Cause::not_recovered);
    EXPECT_FALSE(outcome.failure.triangles.empty());
    std::cout << name << ": " << outcome.failure.message << "\n";
    return Outcome::refused;
  }
  expect_mesh_of(*outcome.mesh, domain);
  return Outcome::meshed;
}

}  // namespace tetfarm
