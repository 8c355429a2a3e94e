/// Surfaces of several regions from labelled cubes: whose regions are known by flood fill.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm::shapes {

/// Unit cubes in a grid of nx * ny * nz, each with a label; round the grid everything is 0.
struct Voxels {
  std::array<int, 3> size{};
  std::function<int(int x, int y, int z)> label;  ///< asked inside of the grid only
};

struct VoxelSurface {
  SurfaceMesh surface;  ///< two triangles for each square between cubes of different label
  /// Of the cubes behind and in front of each triangle: the set of equal cubes joined over faces, 0
  /// the one round the grid.
  std::vector<std::array<int, 2>> sets;
  std::vector<int> cubes_of_set;
};

VoxelSurface voxel_surface(const Voxels& voxels);

}  // namespace tetfarm::shapes
