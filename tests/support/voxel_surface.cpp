#include "tests/support/voxel_surface.h"

#include <map>
#include <utility>

namespace tetfarm::shapes {
namespace {

using Cell = std::array<int, 3>;

/// The labels with a layer of 0 all round, and the sets of equal ones joined over faces.
class Grid {
 public:
  explicit Grid(const Voxels& voxels) : voxels_(voxels) {
    for_each([this](const Cell& cell) { fill(cell); });
  }
  int set(const Cell& cell) const { return sets_.at(cell); }
  const std::vector<int>& cubes() const { return cubes_; }

  template <class Visit>
  void for_each(const Visit& visit) const {
    Cell cell;
    for (cell[2] = -1; cell[2] <= voxels_.size[2]; ++cell[2]) {
      for (cell[1] = -1; cell[1] <= voxels_.size[1]; ++cell[1]) {
        for (cell[0] = -1; cell[0] <= voxels_.size[0]; ++cell[0]) visit(cell);
      }
    }
  }
  bool contains(const Cell& cell) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (cell[i] < -1 || cell[i] > voxels_.size[i]) return false;
    }
    return true;
  }

 private:
  int label(const Cell& cell) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (cell[i] < 0 || cell[i] >= voxels_.size[i]) return 0;
    }
    return voxels_.label(cell[0], cell[1], cell[2]);
  }
  void fill(const Cell& seed) {
    if (sets_.count(seed) != 0) return;
    const int set = static_cast<int>(cubes_.size());
    cubes_.push_back(0);
    std::vector<Cell> open = {seed};
    sets_[seed] = set;
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      ++cubes_.back();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          Cell next = cell;
          next[axis] += step;
          if (!contains(next) || label(next) != label(seed) || sets_.count(next) != 0) continue;
          sets_[next] = set;
          open.push_back(next);
        }
      }
    }
  }

  const Voxels& voxels_;
  std::map<Cell, int> sets_;
  std::vector<int> cubes_;
};

}  // namespace

VoxelSurface voxel_surface(const Voxels& voxels) {
  const Grid grid(voxels);
  VoxelSurface result;
  SurfaceMesh& mesh = result.surface;
  std::map<Cell, std::int32_t> corner2vertex;
  const auto vertex = [&](const Cell& corner) {
    const auto [it, is_new] =
        corner2vertex.try_emplace(corner, static_cast<std::int32_t>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back({static_cast<double>(corner[0]), static_cast<double>(corner[1]),
                               static_cast<double>(corner[2])});
    }
    return it->second;
  };
  grid.for_each([&](const Cell& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Cell next = cell;
      ++next[axis];
      if (!grid.contains(next) || grid.set(cell) == grid.set(next)) continue;
      const std::size_t u = (axis + 1) % 3;
      const std::size_t v = (axis + 2) % 3;
      std::array<Cell, 4> square = {next, next, next, next};
      square[1][u] += 1;
      square[2][u] += 1;
      square[2][v] += 1;
      square[3][v] += 1;
      const std::array<std::int32_t, 4> q = {vertex(square[0]), vertex(square[1]),
                                             vertex(square[2]), vertex(square[3])};
      mesh.triangles.push_back({q[0], q[1], q[2]});
      mesh.triangles.push_back({q[0], q[2], q[3]});
      for (int i = 0; i < 2; ++i) result.sets.push_back({grid.set(cell), grid.set(next)});
    }
  });
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 0);
  mesh.patch_names = {"surface"};
  result.cubes_of_set = grid.cubes();
  return result;
}

}  // namespace tetfarm::shapes
