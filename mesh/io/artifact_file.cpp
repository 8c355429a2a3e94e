#include "mesh/io/artifact_file.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"

namespace tetfarm {
namespace {

// Arrays are copied as they lie in memory; a big-endian machine would need to turn each number.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Tet) == 16);

using Magic = std::string_view;
constexpr Magic surface_magic = "TFSURF\r\n";
constexpr Magic subdomain_magic = "TFSUBD\r\n";
constexpr Magic tet_mesh_magic = "TFTETM\r\n";
constexpr std::uint32_t version = 2;
constexpr std::size_t checksum_size = 16;
constexpr std::uint64_t max_count = std::numeric_limits<std::int32_t>::max();

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

class Writer {
 public:
  Writer(Magic magic, std::size_t size_of_rest) {
    bytes_.reserve(magic.size() + sizeof version + size_of_rest + checksum_size);
    bytes_ += magic;
    number(version);
  }
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void array(const T* data, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(data), count * sizeof(T));
  }
  void origins(const std::vector<Origin>& origins) {
    for (const Origin& origin : origins) number(origin.owner);
    for (const Origin& origin : origins) number(origin.index);
  }
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
  }
  std::string finish() && {
    const Hash128 checksum = hash128(bytes_);
    number(checksum.low);
    number(checksum.high);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
};

/// Nothing is allocated before the bytes that would fill it are known to be there.
class Reader {
 public:
  /// Checks magic, version and checksum.
  Reader(std::string_view bytes, Magic magic, const std::string& name) : name_(name) {
    if (bytes.substr(0, magic.size()) != magic) fail("does not start as the expected kind of file");
    if (bytes.size() < magic.size() + sizeof version + checksum_size) fail("is cut short");
    rest_ = bytes.substr(magic.size(), bytes.size() - magic.size() - checksum_size);
    const auto found = number<std::uint32_t>();
    if (found != version)
      fail("has the format version " + std::to_string(found) + ", not " + std::to_string(version));
    Hash128 checksum;
    std::memcpy(&checksum.low, bytes.end() - 16, 8);
    std::memcpy(&checksum.high, bytes.end() - 8, 8);
    if (hash128(bytes.substr(0, bytes.size() - checksum_size)) != checksum) {
      fail("has a wrong checksum");
    }
  }
  template <class T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, take(1, sizeof value).data(), sizeof value);
    return value;
  }
  std::size_t count() {
    const auto value = number<std::uint64_t>();
    if (value > max_count) fail("has a count of " + std::to_string(value));
    return value;
  }
  template <class T>
  std::vector<T> array(std::size_t count) {
    const std::string_view bytes = take(count, sizeof(T));
    std::vector<T> items(count);
    if (count > 0) std::memcpy(items.data(), bytes.data(), bytes.size());
    return items;
  }
  std::vector<Origin> origins(std::size_t count) {
    const auto owners = array<std::uint64_t>(count);
    const auto indices = array<std::uint32_t>(count);
    std::vector<Origin> origins(count);
    for (std::size_t i = 0; i < count; ++i) origins[i] = {owners[i], indices[i]};
    return origins;
  }
  std::string text() { return std::string(take(number<std::uint32_t>(), 1)); }
  template <std::size_t N>
  std::vector<std::array<std::int32_t, N>> elements(std::size_t count, std::size_t node_count) {
    auto elements = array<std::array<std::int32_t, N>>(count);
    for (const auto& nodes : elements) {
      for (const std::int32_t node : nodes) check_index(node, node_count);
    }
    return elements;
  }
  void check_index(std::int32_t index, std::size_t count) const {
    if (index < 0 || at(index) >= count) {
      fail("has the index " + std::to_string(index) + " of " + std::to_string(count) + " items");
    }
  }
  void expect_end() const {
    if (!rest_.empty()) fail("has " + std::to_string(rest_.size()) + " bytes too many");
  }
  [[noreturn]] void fail(const std::string& what) const { throw CorruptFile(what, name_); }

 private:
  std::string_view take(std::size_t count, std::size_t item_size) {
    if (count > rest_.size() / item_size) fail("is cut short");
    const std::string_view bytes = rest_.substr(0, count * item_size);
    rest_.remove_prefix(bytes.size());
    return bytes;
  }

  std::string_view rest_;
  const std::string& name_;
};

}  // namespace

std::string surface_to_bytes(const SurfaceMesh& surface) {
  TF_CHECK(surface.patch_of_triangle.empty() ||
           surface.patch_of_triangle.size() == surface.triangles.size());
  TF_CHECK(surface.sides.empty() || surface.sides.size() == surface.triangles.size());
  std::size_t size = 6 * sizeof(std::uint64_t) + surface.vertices.size() * sizeof(Vec3) +
                     surface.triangles.size() * sizeof(Triangle) +
                     surface.patch_of_triangle.size() * sizeof(std::int32_t) +
                     surface.sides.size() * sizeof(Sides);
  for (const std::string& name : surface.patch_names) size += sizeof(std::uint32_t) + name.size();
  for (const std::string& name : surface.region_names) size += sizeof(std::uint32_t) + name.size();
  Writer writer(surface_magic, size);
  writer.number<std::uint64_t>(surface.vertices.size());
  writer.number<std::uint64_t>(surface.triangles.size());
  writer.number<std::uint64_t>(surface.patch_of_triangle.size());
  writer.number<std::uint64_t>(surface.patch_names.size());
  writer.number<std::uint64_t>(surface.sides.size());
  writer.number<std::uint64_t>(surface.region_names.size());
  writer.array(surface.vertices.data(), surface.vertices.size());
  writer.array(surface.triangles.data(), surface.triangles.size());
  writer.array(surface.patch_of_triangle.data(), surface.patch_of_triangle.size());
  for (const std::string& name : surface.patch_names) writer.text(name);
  writer.array(surface.sides.data(), surface.sides.size());
  for (const std::string& name : surface.region_names) writer.text(name);
  return std::move(writer).finish();
}

SurfaceMesh surface_from_bytes(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, surface_magic, name);
  const std::size_t vertices = reader.count();
  const std::size_t triangles = reader.count();
  const std::size_t patched_triangles = reader.count();
  const std::size_t patches = reader.count();
  const std::size_t sided_triangles = reader.count();
  const std::size_t regions = reader.count();
  if (patched_triangles != 0 && patched_triangles != triangles) {
    reader.fail("gives patches to some triangles only");
  }
  if (sided_triangles != 0 && sided_triangles != triangles) {
    reader.fail("gives sides to some triangles only");
  }
  SurfaceMesh surface;
  surface.vertices = reader.array<Vec3>(vertices);
  surface.triangles = reader.elements<3>(triangles, vertices);
  surface.patch_of_triangle = reader.array<std::int32_t>(patched_triangles);
  for (const std::int32_t patch : surface.patch_of_triangle) reader.check_index(patch, patches);
  for (std::size_t i = 0; i < patches; ++i) surface.patch_names.push_back(reader.text());
  surface.sides = reader.elements<2>(sided_triangles, regions + 1);
  for (std::size_t i = 0; i < regions; ++i) surface.region_names.push_back(reader.text());
  reader.expect_end();
  return surface;
}

std::string subdomain_to_bytes(const Subdomain& subdomain) {
  TF_CHECK(subdomain.node_origin.size() == subdomain.vertices.size());
  TF_CHECK(subdomain.triangle_origin.size() == subdomain.triangles.size());
  constexpr std::size_t origin_size = sizeof(std::uint64_t) + sizeof(std::uint32_t);
  TF_CHECK(subdomain.sides.size() == (subdomain.region == 0 ? subdomain.triangles.size() : 0));
  Writer writer(subdomain_magic, 4 * sizeof(std::uint64_t) +
                                     subdomain.vertices.size() * (sizeof(Vec3) + origin_size) +
                                     subdomain.triangles.size() * (sizeof(Triangle) + origin_size) +
                                     subdomain.sides.size() * sizeof(Sides));
  writer.number(subdomain.path.heap);
  writer.number<std::uint64_t>(subdomain.vertices.size());
  writer.number<std::uint64_t>(subdomain.triangles.size());
  writer.number<std::uint64_t>(static_cast<std::uint64_t>(subdomain.region));
  writer.array(subdomain.vertices.data(), subdomain.vertices.size());
  writer.array(subdomain.triangles.data(), subdomain.triangles.size());
  writer.origins(subdomain.node_origin);
  writer.origins(subdomain.triangle_origin);
  writer.array(subdomain.sides.data(), subdomain.sides.size());
  return std::move(writer).finish();
}

Subdomain subdomain_from_bytes(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, subdomain_magic, name);
  Subdomain subdomain;
  subdomain.path.heap = reader.number<std::uint64_t>();
  if (subdomain.path.heap == 0) reader.fail("has the tree path 0");
  const std::size_t vertices = reader.count();
  const std::size_t triangles = reader.count();
  subdomain.region = static_cast<std::int32_t>(reader.count());
  subdomain.vertices = reader.array<Vec3>(vertices);
  subdomain.triangles = reader.elements<3>(triangles, vertices);
  subdomain.node_origin = reader.origins(vertices);
  subdomain.triangle_origin = reader.origins(triangles);
  if (subdomain.region == 0) subdomain.sides = reader.elements<2>(triangles, max_count);
  reader.expect_end();
  return subdomain;
}

std::string tet_mesh_to_bytes(const TetMesh& mesh) {
  TF_CHECK(mesh.boundary_nodes >= 0 && at(mesh.boundary_nodes) <= mesh.nodes.size());
  const std::size_t inner_nodes = mesh.nodes.size() - at(mesh.boundary_nodes);
  Writer writer(tet_mesh_magic, 3 * sizeof(std::uint64_t) + inner_nodes * sizeof(Vec3) +
                                    mesh.tets.size() * sizeof(Tet));
  writer.number<std::uint64_t>(at(mesh.boundary_nodes));
  writer.number<std::uint64_t>(inner_nodes);
  writer.number<std::uint64_t>(mesh.tets.size());
  writer.array(mesh.nodes.data() + mesh.boundary_nodes, inner_nodes);
  writer.array(mesh.tets.data(), mesh.tets.size());
  return std::move(writer).finish();
}

TetMesh tet_mesh_from_bytes(std::string_view bytes, const Subdomain& subdomain,
                            const std::string& name) {
  Reader reader(bytes, tet_mesh_magic, name);
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
  mesh.tets = reader.elements<4>(tets, mesh.nodes.size());
  reader.expect_end();
  return mesh;
}

}  // namespace tetfarm
