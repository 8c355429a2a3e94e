/// The bytes of a portion (portion.h).

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/artifacts/checked_bytes.h"
#include "mesh/assemble/portion.h"

namespace tetfarm {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Tet) == 16);

constexpr std::string_view magic = "TFPORT\r\n";
constexpr std::string_view tets_magic = "TFPTET\r\n";
constexpr std::uint32_t version = 2;
constexpr std::uint32_t tets_version = 1;

void write_vector(const Vec3& v, ByteWriter& writer) {
  for (const double x : {v.x, v.y, v.z}) writer.number(x);
}

Vec3 read_vector(ByteReader& reader) {
  Vec3 v;
  for (double* x : {&v.x, &v.y, &v.z}) *x = reader.number<double>();
  return v;
}

void write_shapes(const ShapeStatistics& shapes, ByteWriter& writer) {
  writer.number(shapes.tets);
  writer.number(shapes.min_dihedral_deg);
  writer.number(shapes.max_dihedral_deg);
  for (const std::int64_t count : shapes.dihedral_histogram) writer.number(count);
  writer.number(shapes.min_radius_ratio);
  writer.number(shapes.sum_radius_ratio);
  writer.number(shapes.smallest_height);
  write_vector(shapes.worst_centroid, writer);
}

ShapeStatistics read_shapes(ByteReader& reader) {
  ShapeStatistics shapes;
  shapes.tets = reader.number<std::int64_t>();
  shapes.min_dihedral_deg = reader.number<double>();
  shapes.max_dihedral_deg = reader.number<double>();
  for (std::int64_t& count : shapes.dihedral_histogram) count = reader.number<std::int64_t>();
  shapes.min_radius_ratio = reader.number<double>();
  shapes.sum_radius_ratio = reader.number<double>();
  shapes.smallest_height = reader.number<double>();
  shapes.worst_centroid = read_vector(reader);
  return shapes;
}

/// The part's own region is the last one that has figures.
void write_all_shapes(const MeshShapes& shapes, ByteWriter& writer) {
  write_shapes(shapes.all, writer);
  write_shapes(shapes.near_cuts, writer);
  write_shapes(shapes.away_from_cuts, writer);
  writer.number(shapes.regions.empty() ? 0.0 : shapes.regions.back().volume);
}

MeshShapes read_all_shapes(ByteReader& reader, std::int32_t region) {
  MeshShapes shapes;
  shapes.all = read_shapes(reader);
  shapes.near_cuts = read_shapes(reader);
  shapes.away_from_cuts = read_shapes(reader);
  shapes.regions.resize(static_cast<std::size_t>(region));
  shapes.regions.back() = {reader.number<double>(), shapes.all};
  return shapes;
}

template <class Element>
void check_indices(const std::vector<Element>& elements, std::size_t nodes,
                   const ByteReader& reader) {
  for (const Element& element : elements) {
    for (const std::int32_t v : element) {
      if (v < 0 || static_cast<std::size_t>(v) >= nodes)
        reader.fail("has an element with a node that does not exist");
    }
  }
}

}  // namespace

PortionCounts portion_counts(const std::filesystem::path& path, const std::string& name) {
  constexpr std::size_t before_counts = magic.size() + sizeof version + 2 * sizeof(std::int32_t);
  const std::string head = read_part_of_file(path, 0, before_counts + 3 * sizeof(std::uint64_t));
  if (!head.starts_with(magic) || head.size() < before_counts) {
    throw CorruptFile("does not begin like the expected kind of file", name);
  }
  ByteReader reader(std::string_view(head).substr(before_counts), name);
  PortionCounts counts;
  for (std::int64_t* count : {&counts.nodes, &counts.tets, &counts.faces}) {
    *count = static_cast<std::int64_t>(reader.count());
  }
  return counts;
}

std::string portion_to_bytes(const Portion& portion) {
  const NumberedPart& part = portion.part;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.patch_of_face.size() == part.faces.size() &&
           portion.surface_triangles.size() == part.faces.size());
  ByteWriter writer = begin_checked(magic, version);
  writer.number(part.number);
  writer.number(part.region);
  writer.number<std::uint64_t>(part.nodes.size());
  writer.number<std::uint64_t>(static_cast<std::uint64_t>(portion.tets));
  writer.number<std::uint64_t>(part.faces.size());
  writer.array(part.nodes);
  writer.array(part.local2global);
  writer.array(part.faces);
  writer.array(part.patch_of_face);
  writer.array(portion.surface_triangles);
  writer.number(portion.face_sum);
  write_all_shapes(portion.shapes, writer);
  writer.hash(portion.tet_digest.hash);
  writer.number<std::uint64_t>(portion.placed.size());
  for (const FileRange& range : portion.placed) {
    writer.number(range.offset);
    writer.number(range.size);
    writer.hash(range.hash);
  }
  return finish_checked(std::move(writer));
}

Portion portion_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader reader = read_checked(bytes, magic, version, name);
  Portion portion;
  NumberedPart& part = portion.part;
  part.number = reader.number<std::int32_t>();
  part.region = reader.number<std::int32_t>();
  constexpr std::int32_t most_regions = 1 << 20;
  if (part.region < 1 || part.region > most_regions) reader.fail("has no valid region");
  const std::size_t nodes = reader.count();
  const std::size_t tets = reader.count();
  const std::size_t faces = reader.count();
  part.nodes = reader.array<Vec3>(nodes);
  part.local2global = reader.array<std::int64_t>(nodes);
  part.faces = reader.array<Triangle>(faces);
  part.patch_of_face = reader.array<std::int32_t>(faces);
  portion.surface_triangles = reader.array<std::uint32_t>(faces);
  portion.face_sum = reader.number<std::uint64_t>();
  portion.shapes = read_all_shapes(reader, part.region);
  portion.tets = static_cast<std::int64_t>(tets);
  portion.tet_digest = {reader.hash(), portion.tets};
  const std::size_t ranges = reader.count();
  for (std::size_t i = 0; i < ranges; ++i) {
    FileRange& range = portion.placed.emplace_back();
    range.offset = reader.number<std::int64_t>();
    range.size = reader.number<std::int64_t>();
    range.hash = reader.hash();
  }
  reader.expect_end();
  check_indices(part.faces, nodes, reader);
  return portion;
}

std::string portion_tets_to_bytes(const Portion& portion) {
  ByteWriter writer = begin_checked(tets_magic, tets_version);
  TF_CHECK(static_cast<std::int64_t>(portion.part.tets.size()) == portion.tets);
  writer.number(portion.part.number);
  writer.number<std::uint64_t>(portion.part.tets.size());
  writer.array(portion.part.tets);
  return finish_checked(std::move(writer));
}

void add_portion_tets(std::string_view bytes, const std::string& name, Portion& portion) {
  ByteReader reader = read_checked(bytes, tets_magic, tets_version, name);
  const auto number = reader.number<std::int32_t>();
  const std::size_t tets = reader.count();
  if (number != portion.part.number || static_cast<std::int64_t>(tets) != portion.tets) {
    reader.fail("belongs to another portion");
  }
  portion.part.tets = reader.array<Tet>(tets);
  reader.expect_end();
  check_indices(portion.part.tets, portion.part.nodes.size(), reader);
}

}  // namespace tetfarm
