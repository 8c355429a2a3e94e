/// The bytes of a portion (portion.h).

#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "base/file_system.h"
#include "mesh/artifacts/checked_bytes.h"
#include "mesh/assemble/portion.h"

namespace tetfarm {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(Tet) == 16);

constexpr std::string_view portion_magic = "TFPORT\r\n";
constexpr std::string_view cells_magic = "TFPTET\r\n";
/// Of a portion of tets and triangles alone, of one that has others besides, and of one that tells
/// of the feet of its nodes as well.
constexpr std::uint32_t portion_version = 2;
constexpr std::uint32_t version_with_others = 3;
constexpr std::uint32_t version_with_feet = 4;
constexpr std::uint32_t cells_version = 1;
constexpr std::uint32_t cells_version_with_others = 2;
constexpr std::uint32_t cells_version_with_marks = 3;
constexpr std::uint32_t cells_version_with_axes = 4;
/// Which marks version 3 has; version 4 has all.
constexpr std::size_t first_marks = 2;
constexpr std::size_t other_types = cell_block_types.size() + face_block_types.size();

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

void check_index(std::int32_t v, std::size_t nodes, const ByteReader& reader) {
  if (v < 0 || static_cast<std::size_t>(v) >= nodes) {
    reader.fail("has an element with a node that does not exist");
  }
}

template <class Element>
void check_indices(const std::vector<Element>& elements, std::size_t nodes,
                   const ByteReader& reader) {
  for (const Element& element : elements) {
    for (const std::int32_t v : element) check_index(v, nodes, reader);
  }
}

std::uint32_t version_of_portion(std::string_view bytes) {
  for (const std::uint32_t version : {version_with_others, version_with_feet}) {
    if (says_version(bytes, portion_magic, version)) return version;
  }
  return portion_version;
}

std::uint32_t version_for(const Portion& portion) {
  if (!portion.part.feet.empty()) return version_with_feet;
  return portion.others != ElementCounts{} ? version_with_others : portion_version;
}

std::uint32_t version_without_marks(const ElementCounts& others) {
  return others != ElementCounts{} ? cells_version_with_others : cells_version;
}

std::uint32_t version_for_cells(const Portion& portion) {
  if (portion.part.marks.empty()) return version_without_marks(portion.others);
  return portion.part.marks[CellMark::pml_axes].empty() ? cells_version_with_marks
                                                        : cells_version_with_axes;
}

std::uint32_t version_of_cells(std::string_view bytes, const ElementCounts& others) {
  for (const std::uint32_t version : {cells_version_with_marks, cells_version_with_axes}) {
    if (says_version(bytes, cells_magic, version)) return version;
  }
  return version_without_marks(others);
}

/// @pre the version has marks.
std::span<const CellMark> marks_in(std::uint32_t version) {
  const std::span<const CellMark> all = all_cell_marks;
  return version == cells_version_with_axes ? all : all.first(first_marks);
}

/// Each is told of every cell, or of none.
void write_marks(const NumberedPart& part, std::uint32_t version, ByteWriter& writer) {
  for (const CellMark mark : marks_in(version)) {
    const std::vector<std::int32_t>& values = part.marks[mark];
    TF_CHECK(values.empty() || std::ssize(values) == cells_of(part));
    writer.number<std::uint64_t>(values.size());
    writer.array(values);
  }
}

CellMarks read_marks(std::int64_t cells, std::uint32_t version, ByteReader& reader) {
  CellMarks marks;
  for (const CellMark mark : marks_in(version)) {
    const std::size_t count = reader.count();
    if (count != 0 && count != at(cells)) reader.fail("has marks of some cells only");
    marks[mark] = reader.array<std::int32_t>(count);
  }
  return marks;
}

void write_other_counts(const ElementCounts& others, ByteWriter& writer) {
  for_each_block(others, [&](ElementType, std::int64_t count) {
    writer.number(static_cast<std::uint64_t>(count));
  });
}

ElementCounts read_other_counts(ByteReader& reader) {
  ElementCounts others{};
  for_each_block(others, [&](ElementType, std::int64_t& count) {
    count = static_cast<std::int64_t>(reader.count());
  });
  return others;
}

/// Elements of one sub-domain, all of its region. @pre the nodes of the part are read.
ElementBlock read_block(ElementType type, std::int64_t count, const NumberedPart& part,
                        ByteReader& reader) {
  ElementBlock block;
  block.nodes = reader.array<std::int32_t>(nodes_of(type) * at(count));
  block.regions.resize(at(count), part.region);
  for (const std::int32_t v : block.nodes) check_index(v, part.nodes.size(), reader);
  return block;
}

NodeFeet read_feet(std::size_t nodes, ByteReader& reader) {
  NodeFeet feet;
  feet.foot = reader.array<std::int64_t>(nodes);
  feet.depth = reader.array<std::int32_t>(nodes);
  return feet;
}

void check_header(const Portion& portion) {
  const NumberedPart& part = portion.part;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.feet.empty() || part.feet.foot.size() == part.nodes.size());
  TF_CHECK(part.feet.foot.size() == part.feet.depth.size());
  TF_CHECK(part.patch_of_face.size() == part.faces.size() &&
           portion.surface_triangles.size() == part.faces.size());
  for (const ElementType type : face_block_types) {
    TF_CHECK(std::ssize(part.blocks[type].patches) == portion.others[type]);
  }
}

void read_other_faces(Portion& portion, ByteReader& reader) {
  NumberedPart& part = portion.part;
  for (const ElementType type : face_block_types) {
    ElementBlock& block = part.blocks[type];
    block = read_block(type, portion.others[type], part, reader);
    block.patches = reader.array<std::int32_t>(block.size());
  }
  portion.other_digest.hash = reader.hash();
  portion.other_digest.count = reader.number<std::int64_t>();
}

std::vector<FileRange> read_ranges(ByteReader& reader) {
  std::vector<FileRange> ranges;
  for (std::size_t rest = reader.count(); rest > 0; --rest) {
    FileRange& range = ranges.emplace_back();
    range.offset = reader.number<std::int64_t>();
    range.size = reader.number<std::int64_t>();
    range.hash = reader.hash();
  }
  return ranges;
}

void write_sum(const MeshDigest::Sum& sum, ByteWriter& writer) {
  writer.hash(sum.hash);
  writer.number(sum.count);
}

}  // namespace

PortionCounts portion_counts(const std::filesystem::path& path, const std::string& name) {
  constexpr std::size_t before_counts =
      portion_magic.size() + sizeof portion_version + 2 * sizeof(std::int32_t);
  const std::string head =
      read_part_of_file(path, 0, before_counts + (3 + other_types) * sizeof(std::uint64_t));
  if (!head.starts_with(portion_magic) || head.size() < before_counts) {
    throw CorruptFile("does not begin like the expected kind of file", name);
  }
  ByteReader reader(std::string_view(head).substr(before_counts), name);
  PortionCounts counts;
  for (std::int64_t* count : {&counts.nodes, &counts.tets, &counts.faces}) {
    *count = static_cast<std::int64_t>(reader.count());
  }
  const std::uint32_t version = version_of_portion(head);
  if (version >= version_with_others) counts.others = read_other_counts(reader);
  counts.has_feet = version >= version_with_feet;
  return counts;
}

std::string portion_to_bytes(const Portion& portion) {
  const NumberedPart& part = portion.part;
  const std::uint32_t version = version_for(portion);
  const bool has_others = version >= version_with_others;
  check_header(portion);
  ByteWriter writer = begin_checked(portion_magic, version);
  writer.number(part.number);
  writer.number(part.region);
  writer.number<std::uint64_t>(part.nodes.size());
  writer.number<std::uint64_t>(static_cast<std::uint64_t>(portion.tets));
  writer.number<std::uint64_t>(part.faces.size());
  if (has_others) write_other_counts(portion.others, writer);
  writer.array(part.nodes);
  writer.array(part.local2global);
  writer.array(part.feet.foot);
  writer.array(part.feet.depth);
  writer.array(part.faces);
  writer.array(part.patch_of_face);
  writer.array(portion.surface_triangles);
  if (has_others) {
    for (const ElementType type : face_block_types) {
      writer.array(part.blocks[type].nodes);
      writer.array(part.blocks[type].patches);
    }
    write_sum(portion.other_digest, writer);
  }
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
  const std::uint32_t version = version_of_portion(bytes);
  const bool has_others = version >= version_with_others;
  ByteReader reader = read_checked(bytes, portion_magic, version, name);
  Portion portion;
  NumberedPart& part = portion.part;
  part.number = reader.number<std::int32_t>();
  part.region = reader.number<std::int32_t>();
  constexpr std::int32_t most_regions = 1 << 20;
  if (part.region < 1 || part.region > most_regions) reader.fail("has no valid region");
  const std::size_t nodes = reader.count();
  const std::size_t tets = reader.count();
  const std::size_t faces = reader.count();
  if (has_others) portion.others = read_other_counts(reader);
  part.nodes = reader.array<Vec3>(nodes);
  part.local2global = reader.array<std::int64_t>(nodes);
  if (version >= version_with_feet) part.feet = read_feet(nodes, reader);
  part.faces = reader.array<Triangle>(faces);
  part.patch_of_face = reader.array<std::int32_t>(faces);
  portion.surface_triangles = reader.array<std::uint32_t>(faces);
  if (has_others) read_other_faces(portion, reader);
  portion.face_sum = reader.number<std::uint64_t>();
  portion.shapes = read_all_shapes(reader, part.region);
  portion.tets = static_cast<std::int64_t>(tets);
  portion.tet_digest = {reader.hash(), portion.tets};
  portion.placed = read_ranges(reader);
  reader.expect_end();
  check_indices(part.faces, nodes, reader);
  return portion;
}

std::string portion_cells_to_bytes(const Portion& portion) {
  const NumberedPart& part = portion.part;
  TF_CHECK(std::ssize(part.tets) == portion.tets);
  const std::uint32_t version = version_for_cells(portion);
  ByteWriter writer = begin_checked(cells_magic, version);
  writer.number(part.number);
  writer.number<std::uint64_t>(part.tets.size());
  writer.array(part.tets);
  for (const ElementType type : cell_block_types) {
    TF_CHECK(std::ssize(part.blocks[type].regions) == portion.others[type]);
    writer.array(part.blocks[type].nodes);
  }
  if (!part.marks.empty()) write_marks(part, version, writer);
  return finish_checked(std::move(writer));
}

void add_portion_cells(std::string_view bytes, const std::string& name, Portion& portion) {
  const std::uint32_t version = version_of_cells(bytes, portion.others);
  const bool has_marks = version >= cells_version_with_marks;
  ByteReader reader = read_checked(bytes, cells_magic, version, name);
  NumberedPart& part = portion.part;
  const auto number = reader.number<std::int32_t>();
  const std::size_t tets = reader.count();
  if (number != part.number || static_cast<std::int64_t>(tets) != portion.tets) {
    reader.fail("belongs to another portion");
  }
  part.tets = reader.array<Tet>(tets);
  check_indices(part.tets, part.nodes.size(), reader);
  for (const ElementType type : cell_block_types) {
    part.blocks[type] = read_block(type, portion.others[type], part, reader);
  }
  part.marks = has_marks ? read_marks(cells_of(part), version, reader) : CellMarks{};
  reader.expect_end();
}

}  // namespace tetfarm
