#include "mesh/artifacts/artifact_file.h"

#include <array>
#include <limits>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Tet) == 16);

constexpr std::string_view subdomain_magic = "TFSUBD\r\n";
constexpr std::string_view tet_mesh_magic = "TFTETM\r\n";
constexpr std::uint32_t version = 2;
constexpr std::uint64_t max_count = std::numeric_limits<std::int32_t>::max();

void check_index(std::int32_t index, std::size_t count, const ByteReader& reader) {
  if (index < 0 || at(index) >= count) {
    reader.fail("has the index " + std::to_string(index) + " of " + std::to_string(count) +
                " items");
  }
}

template <std::size_t N>
std::vector<std::array<std::int32_t, N>> read_elements(std::size_t count, std::size_t nodes,
                                                       ByteReader& reader) {
  auto elements = reader.array<std::array<std::int32_t, N>>(count);
  for (const auto& element : elements) {
    bool are_there = true;
    for (const std::int32_t node : element) are_there &= at(node) < nodes;
    if (are_there) continue;
    for (const std::int32_t node : element) check_index(node, nodes, reader);
  }
  return elements;
}

}  // namespace

std::string subdomain_to_bytes(const Subdomain& subdomain) {
  TF_CHECK(subdomain.node_origin.size() == subdomain.vertices.size());
  TF_CHECK(subdomain.triangle_origin.size() == subdomain.triangles.size());
  constexpr std::size_t origin_size = sizeof(std::uint64_t) + sizeof(std::uint32_t);
  TF_CHECK(subdomain.sides.size() == (subdomain.region == 0 ? subdomain.triangles.size() : 0));
  ByteWriter writer = begin_checked(
      subdomain_magic, version,
      4 * sizeof(std::uint64_t) + subdomain.vertices.size() * (sizeof(Vec3) + origin_size) +
          subdomain.triangles.size() * (sizeof(Triangle) + origin_size) +
          subdomain.sides.size() * sizeof(Sides));
  writer.number(subdomain.path.heap);
  writer.number<std::uint64_t>(subdomain.vertices.size());
  writer.number<std::uint64_t>(subdomain.triangles.size());
  writer.number<std::uint64_t>(static_cast<std::uint64_t>(subdomain.region));
  writer.array(subdomain.vertices);
  writer.array(subdomain.triangles);
  writer.origins(subdomain.node_origin);
  writer.origins(subdomain.triangle_origin);
  writer.array(subdomain.sides);
  return finish_checked(std::move(writer));
}

Subdomain subdomain_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader reader = read_checked(bytes, subdomain_magic, version, name);
  Subdomain subdomain;
  subdomain.path.heap = reader.number<std::uint64_t>();
  if (subdomain.path.heap == 0) reader.fail("has the tree path 0");
  const std::size_t vertices = reader.count();
  const std::size_t triangles = reader.count();
  subdomain.region = static_cast<std::int32_t>(reader.count());
  subdomain.vertices = reader.array<Vec3>(vertices);
  subdomain.triangles = read_elements<3>(triangles, vertices, reader);
  subdomain.node_origin = reader.origins(vertices);
  subdomain.triangle_origin = reader.origins(triangles);
  if (subdomain.region == 0) subdomain.sides = read_elements<2>(triangles, max_count, reader);
  reader.expect_end();
  return subdomain;
}

std::string tet_mesh_to_bytes(const TetMesh& mesh) {
  TF_CHECK(mesh.boundary_nodes >= 0 && at(mesh.boundary_nodes) <= mesh.nodes.size());
  const std::size_t inner_nodes = mesh.nodes.size() - at(mesh.boundary_nodes);
  ByteWriter writer = begin_checked(
      tet_mesh_magic, version,
      3 * sizeof(std::uint64_t) + inner_nodes * sizeof(Vec3) + mesh.tets.size() * sizeof(Tet));
  writer.number<std::uint64_t>(at(mesh.boundary_nodes));
  writer.number<std::uint64_t>(inner_nodes);
  writer.number<std::uint64_t>(mesh.tets.size());
  writer.array(std::span(mesh.nodes).last(inner_nodes));
  writer.array(mesh.tets);
  return finish_checked(std::move(writer));
}

TetMesh tet_mesh_from_bytes(std::string_view bytes, const Subdomain& subdomain,
                            const std::string& name) {
  ByteReader reader = read_checked(bytes, tet_mesh_magic, version, name);
  const std::size_t boundary_nodes = reader.count();
  const std::size_t inner_nodes = reader.count();
  const std::size_t tets = reader.count();
  if (boundary_nodes != subdomain.vertices.size()) {
    reader.fail("has " + std::to_string(boundary_nodes) + " boundary nodes, its sub-domain " +
                std::to_string(subdomain.vertices.size()));
  }
  const auto inner = reader.array<Vec3>(inner_nodes);
  TetMesh mesh;
  mesh.boundary_nodes = static_cast<std::int32_t>(boundary_nodes);
  mesh.nodes.reserve(boundary_nodes + inner_nodes);
  mesh.nodes = subdomain.vertices;
  mesh.nodes.insert(mesh.nodes.end(), inner.begin(), inner.end());
  mesh.tets = read_elements<4>(tets, mesh.nodes.size(), reader);
  reader.expect_end();
  return mesh;
}

}  // namespace tetfarm
