#include "mesh/artifacts/surface_file.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Sides) == 8);

constexpr std::string_view surface_magic = "TFSURF\r\n";
constexpr std::uint32_t surface_version = 3;
constexpr std::uint32_t version_without_blocks = 2;
constexpr std::uint64_t counts_at = surface_magic.size() + sizeof surface_version;

SurfaceCounts read_counts(ByteReader& reader) {
  SurfaceCounts counts;
  counts.vertices = reader.count();
  counts.triangles = reader.count();
  counts.patched_triangles = reader.count();
  counts.patches = reader.count();
  counts.sided_triangles = reader.count();
  counts.regions = reader.count();
  if (counts.patched_triangles != 0 && counts.patched_triangles != counts.triangles) {
    reader.fail("gives patches to only some triangles");
  }
  if (counts.sided_triangles != 0 && counts.sided_triangles != counts.triangles) {
    reader.fail("gives sides to only some triangles");
  }
  return counts;
}

void write_names(const std::vector<std::string>& names, ByteWriter& writer) {
  for (const std::string& name : names) {
    writer.number(static_cast<std::uint32_t>(name.size()));
    writer.text(name);
  }
}

std::vector<std::string> read_names(std::uint64_t count, ByteReader& reader) {
  std::vector<std::string> names;
  for (std::uint64_t i = 0; i < count; ++i) {
    names.push_back(reader.text(reader.number<std::uint32_t>()));
  }
  return names;
}

/// @throws CorruptFile when one of the numbers is not below `count`.
template <class Numbers, class Refuse>
void check_numbers(const Numbers& numbers, std::uint64_t count, const Refuse& refuse) {
  for (const std::int32_t number : numbers) {
    if (number >= 0 && at(number) < count) continue;
    refuse("has the index " + std::to_string(number) + " of " + std::to_string(count) + " items");
  }
}

template <class Item>
std::vector<Item> read_elements(std::uint64_t count, std::uint64_t below, ByteReader& reader) {
  auto items = reader.array<Item>(count);
  for (const Item& item : items) {
    check_numbers(item, below, [&reader](const std::string& what) { reader.fail(what); });
  }
  return items;
}

std::vector<Sides> read_sides(const SurfaceCounts& counts, ByteReader& reader) {
  return read_elements<Sides>(counts.sided_triangles, counts.regions + 1, reader);
}

[[noreturn]] void refuse_piece(const char* what, std::uint32_t number) {
  throw Error(ExitCode::failed,
              "the surface has no " + std::string(what) + ' ' + std::to_string(number));
}

void check_piece(const char* what, std::uint32_t number, std::uint64_t count) {
  if (number >= count) refuse_piece(what, number);
}

/// Calls `read` with each place in `numbers`, by rising number there: a file is read forwards.
template <class Read>
void in_order(const std::vector<std::uint32_t>& numbers, const Read& read) {
  std::vector<std::size_t> places(numbers.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::sort(places.begin(), places.end(),
            [&numbers](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  for (const std::size_t place : places) read(place);
}

}  // namespace

std::uint64_t SurfaceCounts::vertices_at() const { return counts_at + sizeof(SurfaceCounts); }

std::uint64_t SurfaceCounts::triangles_at() const {
  return vertices_at() + vertices * sizeof(Vec3);
}

std::uint64_t SurfaceCounts::patches_at() const {
  return triangles_at() + triangles * sizeof(Triangle);
}

std::uint64_t SurfaceCounts::sides_at() const {
  return patches_at() + patched_triangles * sizeof(std::int32_t);
}

std::uint64_t SurfaceCounts::names_at() const {
  return sides_at() + sided_triangles * sizeof(Sides);
}

std::string surface_to_bytes(const SurfaceMesh& surface) {
  TF_CHECK(surface.patch_of_triangle.empty() ||
           surface.patch_of_triangle.size() == surface.triangles.size());
  TF_CHECK(surface.sides.empty() || surface.sides.size() == surface.triangles.size());
  const SurfaceCounts counts = {
      surface.vertices.size(),    surface.triangles.size(), surface.patch_of_triangle.size(),
      surface.patch_names.size(), surface.sides.size(),     surface.region_names.size()};
  ByteWriter writer;
  // Names and checksums take less, so that nothing is copied while it grows.
  writer.reserve(counts.names_at() + counts.names_at() / 128 + block_size);
  writer.text(surface_magic);
  writer.number(surface_version);
  for (const std::uint64_t count : {counts.vertices, counts.triangles, counts.patched_triangles,
                                    counts.patches, counts.sided_triangles, counts.regions}) {
    writer.number(count);
  }
  writer.array(surface.vertices);
  writer.array(surface.triangles);
  writer.array(surface.patch_of_triangle);
  writer.array(surface.sides);
  TF_CHECK(writer.bytes().size() == counts.names_at());
  write_names(surface.patch_names, writer);
  write_names(surface.region_names, writer);
  return with_block_checksums(writer.take());
}

SurfaceMesh surface_from_bytes(std::string_view bytes, const std::string& name) {
  const bool has_blocks = !is_surface_without_blocks(bytes);
  // Another kind of file is called that before its checksums are found wrong.
  if (has_blocks) read_begun(bytes, surface_magic, surface_version, name);
  ByteReader reader =
      has_blocks ? read_begun(content_of_blocks(bytes, name), surface_magic, surface_version, name)
                 : read_checked(bytes, surface_magic, version_without_blocks, name);
  const SurfaceCounts counts = read_counts(reader);
  SurfaceMesh surface;
  surface.vertices = reader.array<Vec3>(counts.vertices);
  surface.triangles = read_elements<Triangle>(counts.triangles, counts.vertices, reader);
  surface.patch_of_triangle = reader.array<std::int32_t>(counts.patched_triangles);
  check_numbers(surface.patch_of_triangle, counts.patches,
                [&reader](const std::string& what) { reader.fail(what); });
  if (has_blocks) surface.sides = read_sides(counts, reader);
  surface.patch_names = read_names(counts.patches, reader);
  if (!has_blocks) surface.sides = read_sides(counts, reader);
  surface.region_names = read_names(counts.regions, reader);
  reader.expect_end();
  return surface;
}

bool is_surface_without_blocks(std::string_view begin) {
  ByteWriter old;
  old.text(surface_magic);
  old.number(version_without_blocks);
  return begin.starts_with(old.bytes());
}

SurfacePieces pieces_of(const SurfaceMesh& surface, const WantedPieces& wanted) {
  SurfacePieces pieces;
  for (const std::uint32_t v : wanted.vertices) {
    check_piece("vertex", v, surface.vertices.size());
    pieces.vertices.push_back(surface.vertices[v]);
  }
  for (const std::uint32_t t : wanted.triangles) {
    check_piece("triangle", t, surface.triangles.size());
    pieces.triangles.push_back(surface.triangles[t]);
    pieces.patches.push_back(patch_of(surface, t));
    pieces.sides.push_back(sides_of(surface, t));
  }
  return pieces;
}

SurfaceFile::SurfaceFile(const std::filesystem::path& path, const std::string& name)
    : file_(path, name) {
  const std::string begin =
      file_.read(0, std::min(file_.size(), counts_at + sizeof(SurfaceCounts)));
  ByteReader reader = read_begun(begin, surface_magic, surface_version, name);
  counts_ = read_counts(reader);
  const std::uint64_t names_at = counts_.names_at();
  if (names_at > file_.size()) file_.fail("is cut short");
  const std::string names = file_.read(names_at, file_.size() - names_at);
  ByteReader rest(names, name);
  patch_names_ = read_names(counts_.patches, rest);
  region_names_ = read_names(counts_.regions, rest);
  rest.expect_end();
}

SurfacePieces SurfaceFile::read(const WantedPieces& wanted) {
  for (const std::uint32_t v : wanted.vertices) check_piece("vertex", v, counts_.vertices);
  for (const std::uint32_t t : wanted.triangles) check_piece("triangle", t, counts_.triangles);
  SurfacePieces pieces;
  pieces.vertices.resize(wanted.vertices.size());
  in_order(wanted.vertices, [&](std::size_t place) {
    pieces.vertices[place] = file_.item<Vec3>(counts_.vertices_at(), wanted.vertices[place]);
  });
  pieces.triangles.resize(wanted.triangles.size());
  pieces.patches.resize(wanted.triangles.size(), 0);
  pieces.sides.resize(wanted.triangles.size(), Sides{1, 0});
  const auto refuse = [this](const std::string& what) { file_.fail(what); };
  in_order(wanted.triangles, [&](std::size_t place) {
    const std::uint32_t t = wanted.triangles[place];
    pieces.triangles[place] = file_.item<Triangle>(counts_.triangles_at(), t);
    check_numbers(pieces.triangles[place], counts_.vertices, refuse);
    if (counts_.patched_triangles > 0) {
      pieces.patches[place] = file_.item<std::int32_t>(counts_.patches_at(), t);
      check_numbers(std::span(&pieces.patches[place], 1), counts_.patches, refuse);
    }
    if (counts_.sided_triangles > 0) {
      pieces.sides[place] = file_.item<Sides>(counts_.sides_at(), t);
      check_numbers(pieces.sides[place], counts_.regions + 1, refuse);
    }
  });
  return pieces;
}

}  // namespace tetfarm
