#include "dashboard/shown_surface.h"

#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "dashboard/fewer_triangles.h"
#include "mesh/artifacts/byte_stream.h"

namespace tetfarm {
namespace {

constexpr std::string_view shown_magic = "TFSHOWN\n";
constexpr std::uint32_t shown_version = 1;
constexpr double largest_coordinate = 1e30;  // differences and squares are numbers of 32 bits, too

std::int32_t code_of(ShownPiece piece) { return static_cast<std::int32_t>(piece); }

Box3 checked_box(const Subdomain& subdomain, const std::string& name) {
  Box3 box;
  for (const Vec3& vertex : subdomain.vertices) {
    const bool is_small = std::abs(vertex.x) < largest_coordinate &&
                          std::abs(vertex.y) < largest_coordinate &&
                          std::abs(vertex.z) < largest_coordinate;
    if (!is_small) throw CorruptFile("has a coordinate that is not a number below 1e30", name);
    box.add(vertex);
  }
  return box;
}

}  // namespace

std::vector<std::uint32_t> numbers_in_input(const Subdomain& subdomain) {
  std::vector<std::uint32_t> numbers;
  for (const Origin& origin : subdomain.triangle_origin) {
    if (origin.owner == 0) numbers.push_back(origin.index);
  }
  return numbers;
}

std::vector<std::int32_t> pieces_of_boundary(const Subdomain& subdomain,
                                             std::span<const std::int32_t> patches) {
  std::vector<std::int32_t> pieces;
  pieces.reserve(subdomain.triangle_origin.size());
  std::size_t next = 0;
  for (const Origin& origin : subdomain.triangle_origin) {
    if (origin.owner == top_of_layers) {
      pieces.push_back(code_of(ShownPiece::top));
    } else if (origin.owner != 0) {
      pieces.push_back(code_of(ShownPiece::cut));
    } else if (patches.empty()) {
      pieces.push_back(code_of(ShownPiece::unknown_patch));
    } else {
      TF_CHECK(next < patches.size());
      pieces.push_back(patches[next++]);
    }
  }
  return pieces;
}

std::string shown_surface(const Subdomain& subdomain, std::span<const std::int32_t> pieces,
                          std::size_t most, const std::string& name) {
  TF_CHECK(pieces.size() == subdomain.triangles.size());
  const Box3 box = checked_box(subdomain, name);
  const Vec3 origin = box.empty() ? Vec3{} : 0.5 * (box.low + box.high);
  const FewerTriangles few = fewer_triangles(subdomain.vertices, subdomain.triangles, most);
  ByteWriter writer;
  writer.reserve(shown_surface_head + 12 * few.vertices.size() + 16 * few.triangles.size());
  writer.text(shown_magic);
  writer.number(shown_version);
  writer.number(static_cast<std::uint32_t>(few.vertices.size()));
  writer.number(static_cast<std::uint32_t>(few.triangles.size()));
  writer.number(static_cast<std::uint32_t>(subdomain.triangles.size()));
  for (int axis = 0; axis < 3; ++axis) writer.number(origin[axis]);
  TF_CHECK(writer.bytes().size() == shown_surface_head);
  for (const Vec3& vertex : few.vertices) {
    const Vec3 seen = vertex - origin;
    for (int axis = 0; axis < 3; ++axis) writer.number(static_cast<float>(seen[axis]));
  }
  writer.array(few.triangles);
  for (const std::uint32_t was : few.was) writer.number(pieces[was]);
  return writer.take();
}

}  // namespace tetfarm
