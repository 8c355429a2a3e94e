/// Generated surfaces through check_surface and mesh_volume.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <string>

#include "mesh/inspect/surface_check.h"
#include "tests/mesh/volume/volume_checks.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {

/// Meshes the surface when check_surface finds it valid, and checks the mesh; false when it is not.
/// Every fourth is filled.
inline bool expect_is_meshed_if_valid(const shapes::SurfaceGenerator& generator, std::uint64_t seed,
                                      int size) {
  SCOPED_TRACE(std::string(generator.name) + " of size " + std::to_string(size) + ", seed " +
               std::to_string(seed));
  const CheckedSurface checked =
      check_surface(shapes::moved_by_chance(generator.make(seed, size), seed));
  if (!checked.report.defects.empty()) return false;
  const Subdomain domain = root_subdomain(checked.surface);
  VolumeMeshOptions options;
  options.fill = seed % 4 == 3;
  const double spacing = 0.2 * norm(bounding_box(domain.vertices).size());
  try {
    expect_mesh_of(mesh_volume(domain, SpacingField(spacing), options), domain);
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
  }
  return true;
}

}  // namespace tetfarm
