#include "mesh/formats/ugrid/read_ugrid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <fstream>

#include "base/error.h"

namespace tetfarm {
namespace {

static_assert(std::endian::native == std::endian::little, "lb8 is little endian");

template <class T>
void read_into(std::ifstream& file, std::vector<T>& values, const std::string& name) {
  const auto bytes = static_cast<std::streamsize>(values.size() * sizeof(T));
  if (!file.read(reinterpret_cast<char*>(values.data()), bytes)) {
    throw InvalidInput("the file ends too early", name);
  }
}

/// Numbers from 1 become numbers from 0.
template <class Element>
void count_from_zero(std::vector<Element>& elements, std::size_t nodes, const std::string& name) {
  for (Element& element : elements) {
    for (std::int32_t& v : element) {
      if (v < 1 || static_cast<std::size_t>(v) > nodes) {
        throw InvalidInput(
            "an element has node " + std::to_string(v) + " of " + std::to_string(nodes), name);
      }
      --v;
    }
  }
}

}  // namespace

GlobalMesh read_ugrid(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw IoError("cannot read", name, errno != 0 ? errno : ENOENT);
  const std::int64_t bytes = file.tellg();
  file.seekg(0);
  std::vector<std::int32_t> counts(7);
  read_into(file, counts, name);
  const std::int64_t nodes = counts[0];
  const std::int64_t triangles = counts[1];
  const std::int64_t tets = counts[3];
  for (const std::size_t other : {2, 4, 5, 6}) {
    if (counts[other] != 0) throw InvalidInput("has elements other than triangles and tets", name);
  }
  if (nodes < 0 || triangles < 0 || tets < 0 ||
      bytes != 28 + nodes * 24 + triangles * 16 + tets * 16) {
    throw InvalidInput("the length of the file does not match its counts", name);
  }
  GlobalMesh mesh;
  mesh.mesh.nodes.resize(static_cast<std::size_t>(nodes));
  mesh.boundary.resize(static_cast<std::size_t>(triangles));
  mesh.patch_of_triangle.resize(static_cast<std::size_t>(triangles));
  mesh.mesh.tets.resize(static_cast<std::size_t>(tets));
  read_into(file, mesh.mesh.nodes, name);
  read_into(file, mesh.boundary, name);
  read_into(file, mesh.patch_of_triangle, name);
  read_into(file, mesh.mesh.tets, name);
  count_from_zero(mesh.boundary, mesh.mesh.nodes.size(), name);
  count_from_zero(mesh.mesh.tets, mesh.mesh.nodes.size(), name);
  for (std::int32_t& patch : mesh.patch_of_triangle) --patch;
  if (enclosed_volume(mesh.mesh.nodes, mesh.boundary) < 0) {
    for (Triangle& triangle : mesh.boundary) std::swap(triangle[1], triangle[2]);
  }
  mesh.mesh.boundary_nodes = counts[0];
  return mesh;
}

}  // namespace tetfarm
