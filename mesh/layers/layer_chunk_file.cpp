#include "mesh/layers/layer_chunk_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

constexpr std::string_view chunk_magic = "TFLAYR\r\n";
constexpr std::uint32_t chunk_version = 1;
constexpr std::uint32_t chunk_version_with_kinds = 2;
/// What a line of another kind than that of boundary layers is.
constexpr std::uint32_t in_tets_bit = 1;
constexpr std::uint32_t of_pml_bit = 2;
constexpr std::uint64_t heaps_end = std::uint64_t{1} << 63U;

void write_line(const ChunkLine& line, ByteWriter& writer) {
  writer.number(line.line.foot);
  writer.number(line.line.stop);
  for (const Vec3& v : {line.line.at, line.line.along, line.line.later}) {
    for (const double x : {v.x, v.y, v.z}) writer.number(x);
  }
  writer.number(line.line.bends_from);
  writer.number(line.line.bends_to);
  const HeightLaw& law = line.line.law;
  for (const double x : {law.first, law.growth, law.acceleration, law.cap}) writer.number(x);
  writer.number(law.equal);
  writer.number(line.top);
  writer.number(line.owner);
  writer.number(line.first_node);
}

double read_finite(ByteReader& reader) {
  const auto x = reader.number<double>();
  if (!std::isfinite(x)) reader.fail("has a number that is not finite");
  return x;
}

Vec3 read_vector(ByteReader& reader) {
  Vec3 v;
  for (double* x : {&v.x, &v.y, &v.z}) *x = read_finite(reader);
  return v;
}

ChunkLine read_line(ByteReader& reader) {
  ChunkLine line;
  line.line.foot = reader.number<std::int32_t>();
  line.line.stop = reader.number<std::int32_t>();
  line.line.at = read_vector(reader);
  line.line.along = read_vector(reader);
  line.line.later = read_vector(reader);
  line.line.bends_from = read_finite(reader);
  line.line.bends_to = read_finite(reader);
  HeightLaw& law = line.line.law;
  for (double* x : {&law.first, &law.growth, &law.acceleration, &law.cap}) *x = read_finite(reader);
  law.equal = reader.number<std::int32_t>();
  line.top = reader.number<std::uint32_t>();
  line.owner = reader.number<std::uint64_t>();
  line.first_node = reader.number<std::uint32_t>();
  const bool is_right = line.line.foot >= 0 && line.line.stop >= 0 &&
                        line.line.stop <= most_layers && law.equal >= 1 && line.owner > 0 &&
                        line.owner < heaps_end;
  if (!is_right) reader.fail("has a line that cannot be");
  return line;
}

void check_triangles(const LayerChunk& chunk, const ByteReader& reader) {
  std::vector<bool> is_used(chunk.lines.size(), false);
  for (const Triangle& triangle : chunk.triangles) {
    const auto& [a, b, c] = triangle;
    bool has_layers = false;
    for (const std::int32_t line : triangle) {
      if (line < 0 || at(line) >= chunk.lines.size()) {
        reader.fail("has a triangle with a line that does not exist");
      }
      is_used[at(line)] = true;
      has_layers = has_layers || chunk.lines[at(line)].line.stop > 0;
    }
    if (a == b || b == c || c == a || !has_layers) {
      reader.fail("has a triangle without layers above it");
    }
  }
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end()) {
    reader.fail("has a line of no triangle");
  }
}

bool has_kinds_of_lines(const LayerChunk& chunk) {
  return std::any_of(chunk.lines.begin(), chunk.lines.end(),
                     [](const ChunkLine& line) { return line.line.of_pml || line.line.in_tets; });
}

/// By the version in the first bytes; what else they say is looked at by who reads on.
bool says_kinds(std::string_view bytes) {
  return bytes.starts_with(begin_checked(chunk_magic, chunk_version_with_kinds).bytes());
}

void read_kinds(ByteReader& reader, LayerChunk& chunk) {
  for (ChunkLine& line : chunk.lines) {
    const auto kind = reader.number<std::uint32_t>();
    if (kind > (in_tets_bit | of_pml_bit)) reader.fail("has a line that cannot be");
    line.line.in_tets = (kind & in_tets_bit) != 0;
    line.line.of_pml = (kind & of_pml_bit) != 0;
  }
}

}  // namespace

std::string layer_chunk_to_bytes(const LayerChunk& chunk) {
  TF_CHECK(chunk.triangles.size() == chunk.surface_triangles.size());
  const bool has_kinds = has_kinds_of_lines(chunk);
  ByteWriter writer =
      begin_checked(chunk_magic, has_kinds ? chunk_version_with_kinds : chunk_version);
  writer.number(chunk.path.heap);
  writer.number<std::uint64_t>(chunk.lines.size());
  writer.number<std::uint64_t>(chunk.triangles.size());
  for (const ChunkLine& line : chunk.lines) write_line(line, writer);
  if (has_kinds) {
    for (const ChunkLine& line : chunk.lines) {
      writer.number<std::uint32_t>((line.line.in_tets ? in_tets_bit : 0) |
                                   (line.line.of_pml ? of_pml_bit : 0));
    }
  }
  writer.array(chunk.triangles);
  writer.array(chunk.surface_triangles);
  return finish_checked(std::move(writer));
}

LayerChunk layer_chunk_from_bytes(std::string_view bytes, const std::string& name) {
  const bool has_kinds = says_kinds(bytes);
  ByteReader reader =
      read_checked(bytes, chunk_magic, has_kinds ? chunk_version_with_kinds : chunk_version, name);
  LayerChunk chunk;
  chunk.path = {reader.number<std::uint64_t>()};
  if (chunk.path.heap == 0 || chunk.path.heap >= heaps_end) reader.fail("has no place in a tree");
  const std::size_t lines = reader.count();
  const std::size_t triangles = reader.count();
  for (std::size_t i = 0; i < lines; ++i) chunk.lines.push_back(read_line(reader));
  if (has_kinds) read_kinds(reader, chunk);
  chunk.triangles = reader.array<Triangle>(triangles);
  chunk.surface_triangles = reader.array<std::uint32_t>(triangles);
  reader.expect_end();
  check_triangles(chunk, reader);
  return chunk;
}

}  // namespace tetfarm
