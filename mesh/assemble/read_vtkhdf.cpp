#include "mesh/assemble/read_vtkhdf.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "mesh/assemble/hdf5_file.h"

namespace tetfarm {
namespace {

constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_tetra = 10;

std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

/// Where a partition begins in the arrays, and how much it has.
struct Partition {
  std::int64_t first_point = 0;
  std::int64_t points = 0;
  std::int64_t first_cell = 0;
  std::int64_t cells = 0;
  std::int64_t first_id = 0;
  std::int64_t ids = 0;
  std::int64_t number = 0;
};

std::vector<Partition> partitions_of(const Hdf5Input& file) {
  const auto points = file.array<std::int64_t>("VTKHDF/NumberOfPoints");
  const auto cells = file.array<std::int64_t>("VTKHDF/NumberOfCells");
  const auto ids = file.array<std::int64_t>("VTKHDF/NumberOfConnectivityIds");
  if (cells.size() != points.size() || ids.size() != points.size()) {
    file.fail("the numbers of points and cells are not of the same partitions");
  }
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  std::vector<Partition> partitions;
  Partition next;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const std::int64_t count : {points[i], cells[i], ids[i] / 4}) {
      if (count < 0 || count > most) file.fail("a partition has a wrong number of points or cells");
    }
    next.points = points[i];
    next.cells = cells[i];
    next.ids = ids[i];
    partitions.push_back(next);
    next.first_point += next.points;
    next.first_cell += next.cells;
    next.first_id += next.ids;
    ++next.number;
  }
  return partitions;
}

/// The number of each point of the partition in the mesh; puts the points there.
std::vector<std::int32_t> join_points(const Hdf5Input& file, const Partition& here,
                                      bool has_numbers, GlobalMesh& mesh) {
  const auto points = file.slice<double>("VTKHDF/Points", here.first_point, here.points, 3);
  std::vector<std::int64_t> numbers;
  if (has_numbers) {
    numbers =
        file.slice<std::int64_t>("VTKHDF/PointData/GlobalNodeId", here.first_point, here.points);
  } else {
    for (std::int64_t i = 0; i < here.points; ++i) numbers.push_back(i);
  }
  std::vector<std::int32_t> local2global;
  local2global.reserve(numbers.size());
  std::vector<Vec3>& nodes = mesh.mesh.nodes;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int64_t number = numbers[i];
    if (number < 0 || number >= std::ssize(nodes)) file.fail("a GlobalNodeId is out of range");
    nodes[at(number)] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    local2global.push_back(static_cast<std::int32_t>(number));
  }
  return local2global;
}

template <class Element>
Element element_at(const Hdf5Input& file, const std::vector<std::int64_t>& connectivity,
                   std::int64_t first, const std::vector<std::int32_t>& local2global) {
  Element element;
  for (std::size_t i = 0; i < element.size(); ++i) {
    const std::int64_t v = connectivity[at(first) + i];
    if (v < 0 || v >= std::ssize(local2global)) file.fail("a cell has a node that is not there");
    element[i] = local2global[at(v)];
  }
  return element;
}

void join_cells(const Hdf5Input& file, const Partition& here, bool has_patches,
                const std::vector<std::int32_t>& local2global, GlobalMesh& mesh) {
  const auto types = file.slice<std::uint8_t>("VTKHDF/Types", here.first_cell, here.cells);
  const auto offsets =
      file.slice<std::int64_t>("VTKHDF/Offsets", here.first_cell + here.number, here.cells + 1);
  const auto connectivity =
      file.slice<std::int64_t>("VTKHDF/Connectivity", here.first_id, here.ids);
  std::vector<std::int32_t> patches(at(here.cells), 0);
  if (has_patches) {
    patches = file.slice<std::int32_t>("VTKHDF/CellData/patch", here.first_cell, here.cells);
  }
  for (std::size_t cell = 0; cell < types.size(); ++cell) {
    const std::int64_t first = offsets[cell];
    const int nodes = types[cell] == vtk_tetra ? 4 : types[cell] == vtk_triangle ? 3 : 0;
    if (nodes == 0)
      file.fail("a cell of type " + std::to_string(types[cell]) +
                "; only triangles (5) and tetrahedra (10) are read");
    if (first < 0 || first > here.ids || offsets[cell + 1] - first != nodes ||
        offsets[cell + 1] > here.ids) {
      file.fail("the offset of a cell is wrong");
    }
    if (nodes == 4) {
      mesh.mesh.tets.push_back(element_at<Tet>(file, connectivity, first, local2global));
    } else {
      mesh.boundary.push_back(element_at<Triangle>(file, connectivity, first, local2global));
      mesh.patch_of_triangle.push_back(patches[cell]);
    }
  }
}

std::int64_t node_count(const Hdf5Input& file, const std::vector<Partition>& partitions,
                        bool has_numbers) {
  if (!has_numbers) {
    if (partitions.size() != 1) file.fail("several partitions, and no GlobalNodeId to join them");
    return partitions.front().points;
  }
  std::int64_t most = -1;
  std::int64_t points = 0;
  for (const Partition& here : partitions) {
    points += here.points;
    for (const std::int64_t number :
         file.slice<std::int64_t>("VTKHDF/PointData/GlobalNodeId", here.first_point, here.points)) {
      most = std::max(most, number);
    }
  }
  if (most >= points || most >= std::numeric_limits<std::int32_t>::max()) {
    file.fail("a GlobalNodeId is out of range");
  }
  return most + 1;
}

}  // namespace

GlobalMesh read_vtkhdf(const std::filesystem::path& path) {
  const Hdf5Input file(path.string());
  if (!file.has("VTKHDF") || file.text_attribute("VTKHDF", "Type") != "UnstructuredGrid") {
    file.fail("not a VTKHDF file of an UnstructuredGrid");
  }
  const bool has_numbers = file.has("VTKHDF/PointData/GlobalNodeId");
  const bool has_patches = file.has("VTKHDF/CellData/patch");
  const std::vector<Partition> partitions = partitions_of(file);
  GlobalMesh mesh;
  if (partitions.empty()) file.fail("no partition");
  mesh.mesh.nodes.resize(at(node_count(file, partitions, has_numbers)));
  mesh.mesh.boundary_nodes = static_cast<std::int32_t>(mesh.mesh.nodes.size());
  mesh.subdomains = static_cast<std::int32_t>(partitions.size());
  for (const Partition& here : partitions) {
    const auto local2global = join_points(file, here, has_numbers, mesh);
    join_cells(file, here, has_patches, local2global, mesh);
  }
  if (file.has("Tetfarm/patch_names")) mesh.patch_names = file.texts("Tetfarm/patch_names");
  return mesh;
}

}  // namespace tetfarm
