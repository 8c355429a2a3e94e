#include "mesh/layers/layer_chunk_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

constexpr std::string_view chunk_magic = "TFLAYR\r\n";
constexpr std::uint32_t chunk_version = 1;
constexpr std::uint32_t chunk_version_with_kinds = 2;
/// Kinds, and what lies in planes.
constexpr std::uint32_t chunk_version_with_sides = 3;
/// All that, and fans.
constexpr std::uint32_t chunk_version_with_fans = 4;
/// All that, and the box within absorbing layers.
constexpr std::uint32_t chunk_version_with_box = 5;
/// All that, where there is a box, and lists of heights.
constexpr std::uint32_t chunk_version_with_lists = 6;
/// All that, and where lines meet.
constexpr std::uint32_t chunk_version_with_ends = 7;
/// What a line of another kind than that of boundary layers is.
constexpr std::uint32_t in_tets_bit = 1;
constexpr std::uint32_t of_pml_bit = 2;
constexpr std::uint32_t early_bit = 4;
/// The largest first of as many numbers in the surface as a line can have layers, and of as many as
/// a side can have triangles.
constexpr std::int32_t last_first = std::numeric_limits<std::int32_t>::max() - most_layers;
constexpr std::int32_t last_first_triangle =
    std::numeric_limits<std::int32_t>::max() - 2 * most_layers;
constexpr std::uint64_t heaps_end = std::uint64_t{1} << 63U;

void write_vector(const Vec3& v, ByteWriter& writer) {
  for (const double x : {v.x, v.y, v.z}) writer.number(x);
}

void write_line(const ChunkLine& line, ByteWriter& writer) {
  writer.number(line.line.foot);
  writer.number(line.line.stop);
  for (const Vec3& v : {line.line.at, line.line.along, line.line.later}) write_vector(v, writer);
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
  for (const ChunkFan& fan : chunk.fans) {
    for (const std::int32_t line : fan.lines) is_used[at(line)] = true;
  }
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end()) {
    reader.fail("has a line of no triangle, nor of a fan");
  }
}

bool has_kinds_of_lines(const LayerChunk& chunk) {
  return std::any_of(chunk.lines.begin(), chunk.lines.end(),
                     [](const ChunkLine& line) { return line.line.of_pml || line.line.in_tets; });
}

bool has_lists(const LayerChunk& chunk) {
  return std::any_of(chunk.lines.begin(), chunk.lines.end(),
                     [](const ChunkLine& l) { return l.line.law.ratios.are_listed(); });
}

bool has_ends(const LayerChunk& chunk) {
  return std::any_of(chunk.lines.begin(), chunk.lines.end(), [](const ChunkLine& l) {
    return l.end || l.inner || l.line.end != LineEnd();
  });
}

std::uint32_t version_for(const LayerChunk& chunk) {
  if (has_ends(chunk)) return chunk_version_with_ends;
  if (has_lists(chunk)) return chunk_version_with_lists;
  if (chunk.within_pml) return chunk_version_with_box;
  const bool has_fans = !chunk.fans.empty() ||
                        std::any_of(chunk.lines.begin(), chunk.lines.end(), [](const ChunkLine& l) {
                          return l.line.early || l.line.low_vertex >= 0;
                        });
  if (has_fans) return chunk_version_with_fans;
  const bool has_sides =
      !chunk.sides.empty() || std::any_of(chunk.lines.begin(), chunk.lines.end(),
                                          [](const ChunkLine& l) { return l.line.vertices > 0; });
  if (has_sides) return chunk_version_with_sides;
  return has_kinds_of_lines(chunk) ? chunk_version_with_kinds : chunk_version;
}

/// By the first bytes; what else they say is looked at by who reads on.
std::uint32_t version_of(std::string_view bytes) {
  for (const std::uint32_t version :
       {chunk_version_with_ends, chunk_version_with_lists, chunk_version_with_box,
        chunk_version_with_fans, chunk_version_with_sides, chunk_version_with_kinds}) {
    if (says_version(bytes, chunk_magic, version)) return version;
  }
  return chunk_version;
}

void write_sides(const LayerChunk& chunk, ByteWriter& writer) {
  for (const ChunkLine& line : chunk.lines) {
    writer.number<std::int32_t>(line.line.vertices);
    writer.number(line.line.first_vertex);
  }
  writer.number<std::uint64_t>(chunk.sides.size());
  for (const ChunkSide& side : chunk.sides) {
    for (const std::int32_t line : side.lines) writer.number(line);
    writer.number(side.patch);
    writer.number(side.last);
  }
}

void read_sides(ByteReader& reader, LayerChunk& chunk) {
  for (ChunkLine& line : chunk.lines) {
    line.line.vertices = reader.number<std::int32_t>();
    line.line.first_vertex = reader.number<std::int32_t>();
    const bool is_right = line.line.vertices >= 0 && line.line.vertices <= line.line.stop &&
                          (line.line.vertices > 0
                               ? line.line.first_vertex >= 0 && line.line.first_vertex <= last_first
                               : line.line.first_vertex == -1);
    if (!is_right) reader.fail("has a line that cannot be");
  }
  const std::size_t sides = reader.count();
  for (std::size_t i = 0; i < sides; ++i) {
    ChunkSide& side = chunk.sides.emplace_back();
    for (std::int32_t& line : side.lines) line = reader.number<std::int32_t>();
    side.patch = reader.number<std::int32_t>();
    side.last = reader.number<std::int32_t>();
  }
}

/// Whether the line's points above so many quads, and that at their end, are of the surface.
bool ends_on_surface(const LayerLine& line, int quads) {
  return vertex_at(line, std::min(line.stop, std::max(quads, 1))) >= 0;
}

/// Whether the points that the triangles of the side have are of the surface.
bool is_on_surface(const LineSide& side) {
  if (is_divided(side)) {
    return side.from.vertices == side.from.stop && side.to.vertices == side.to.stop;
  }
  const int quads = side.first_level + quads_of(side);
  return ends_on_surface(side.from, quads) && ends_on_surface(side.to, quads);
}

/// @pre triangles are right.
void check_sides(const LayerChunk& chunk, const ByteReader& reader) {
  std::set<std::array<std::int32_t, 2>> edges;
  for (const Triangle& t : chunk.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  }
  for (const ChunkSide& side : chunk.sides) {
    if (edges.erase(side.lines) == 0) reader.fail("has a side that is at no edge");
    const LineSide lines = side_of(chunk, side);
    const bool has_triangles = !triangles_of(lines).empty();
    const bool is_right = side.patch >= 0 && (has_triangles ? side.last >= 0 : side.last == -1) &&
                          side.last <= last_first_triangle &&
                          (!has_triangles || is_on_surface(lines));
    if (!is_right) reader.fail("has a side that cannot be");
  }
}

void write_fans(const LayerChunk& chunk, ByteWriter& writer) {
  for (const ChunkLine& line : chunk.lines) writer.number(line.line.low_vertex);
  writer.number<std::uint64_t>(chunk.fans.size());
  for (const ChunkFan& fan : chunk.fans) {
    for (const std::int32_t line : fan.lines) writer.number(line);
    for (const FanEnd& end : fan.ends) {
      writer.number(end.patch);
      writer.number(end.triangle);
    }
  }
}

/// Two lines of one foot, which begin together.
bool are_of_one_foot(const LayerLine& a, const LayerLine& b) {
  return a.foot == b.foot && (a.stop > 0) == (b.stop > 0) && a.early == b.early;
}

/// The triangle of a fan's side has its nodes on the surface, and so has the top.
bool is_end(const LayerChunk& chunk, const ChunkFan& fan, std::size_t number) {
  const FanEnd& end = fan.ends.at(number);
  if (end.patch < 0) return end.patch == -1 && end.triangle == -1;
  const std::array<std::int32_t, 2> lines = lines_at_end(fan.lines, number);
  return end.triangle >= 0 && end.triangle <= last_first_triangle && lines[0] != lines[1] &&
         is_on_surface(side_above(chunk, fan, number)) &&
         std::all_of(lines.begin(), lines.end(),
                     [&chunk](std::int32_t number_of_line) {
                       const LayerLine& line = chunk.lines[at(number_of_line)].line;
                       return line.stop > 0 && vertex_at(line, 1) >= 0;
                     }) &&
         chunk.lines[at(lines[0])].line.stop == chunk.lines[at(lines[1])].line.stop;
}

bool is_fan(const LayerChunk& chunk, const ChunkFan& fan) {
  const auto& [a, b, c, d] = fan.lines;
  const PieceLines lines = lines_of(chunk, fan);
  if (a == b || !are_of_one_foot(*lines[0], *lines[1]) || !are_of_one_foot(*lines[2], *lines[3]) ||
      !is_end(chunk, fan, 0) || !is_end(chunk, fan, 1)) {
    return false;
  }
  const bool begin_together = lines[0]->stop > 0 && lines[2]->stop > 0 && !lines[0]->early;
  const bool is_corner = lines[0]->foot == lines[2]->foot;
  if (is_corner) {
    return c == d && c != a && c != b && are_of_one_foot(*lines[0], *lines[2]) &&
           lines[0]->stop > 0;
  }
  return !(c == d && begin_together) && !base_cells(lines).empty();
}

void read_fans(ByteReader& reader, LayerChunk& chunk) {
  for (ChunkLine& line : chunk.lines) {
    line.line.low_vertex = reader.number<std::int32_t>();
    const bool is_right = line.line.low_vertex >= -1 &&
                          (line.line.low_vertex < 0 || line.line.vertices < line.line.stop);
    if (!is_right) reader.fail("has a line that cannot be");
  }
  const std::size_t fans = reader.count();
  for (std::size_t i = 0; i < fans; ++i) {
    ChunkFan& fan = chunk.fans.emplace_back();
    for (std::int32_t& line : fan.lines) {
      line = reader.number<std::int32_t>();
      if (line < 0 || at(line) >= chunk.lines.size()) {
        reader.fail("has a fan with a line that does not exist");
      }
    }
    for (FanEnd& end : fan.ends) {
      end.patch = reader.number<std::int32_t>();
      end.triangle = reader.number<std::int32_t>();
    }
    if (!is_fan(chunk, fan)) reader.fail("has a fan that cannot be");
  }
}

void read_kinds(ByteReader& reader, std::uint32_t bits, LayerChunk& chunk) {
  for (ChunkLine& line : chunk.lines) {
    const auto kind = reader.number<std::uint32_t>();
    if (kind > bits) reader.fail("has a line that cannot be");
    line.line.early = (kind & early_bit) != 0;
    line.line.in_tets = (kind & in_tets_bit) != 0;
    line.line.of_pml = (kind & of_pml_bit) != 0;
  }
}

/// The lists that lines have, in the order of the lines, and of each line the number of its own;
/// -1: it has none.
void write_lists(const LayerChunk& chunk, ByteWriter& writer) {
  std::vector<HeightRatios> lists;
  std::vector<std::int32_t> list_of_line;
  for (const ChunkLine& line : chunk.lines) {
    const HeightRatios& ratios = line.line.law.ratios;
    const auto found = std::find(lists.begin(), lists.end(), ratios);
    list_of_line.push_back(ratios.are_listed() ? static_cast<std::int32_t>(found - lists.begin())
                                               : -1);
    if (ratios.are_listed() && found == lists.end()) lists.push_back(ratios);
  }
  writer.number<std::uint64_t>(lists.size());
  for (const HeightRatios& list : lists) {
    writer.number<std::uint64_t>(list.values().size());
    for (const double ratio : list.values()) writer.number(ratio);
  }
  for (std::size_t i = 0; i < list_of_line.size(); ++i) {
    writer.number(list_of_line[i]);
    writer.number(chunk.lines[i].line.law.share);
  }
}

HeightRatios read_list(ByteReader& reader) {
  const std::size_t count = reader.count();
  if (count >= most_layers) reader.fail("has a list of heights that is too long");
  std::vector<double> ratios;
  for (std::size_t i = 0; i < count; ++i) {
    ratios.push_back(read_finite(reader));
    if (ratios.back() < least_height_ratio || ratios.back() > most_height_ratio) {
      reader.fail("has heights that cannot be");
    }
  }
  return HeightRatios(std::move(ratios));
}

void read_lists(ByteReader& reader, LayerChunk& chunk) {
  std::vector<HeightRatios> lists;
  const std::size_t count = reader.count();
  for (std::size_t i = 0; i < count; ++i) lists.push_back(read_list(reader));
  for (ChunkLine& line : chunk.lines) {
    const auto list = reader.number<std::int32_t>();
    HeightLaw& law = line.line.law;
    law.share = read_finite(reader);
    const bool has_list = list >= 0 && at(list) < lists.size();
    if (has_list) law.ratios = lists[at(list)];
    const bool is_right =
        (has_list ? law.share >= 0 && law.share <= 1 : list == -1 && law.share == 1) &&
        most_layers_of(law, line.line.stop) == line.line.stop;
    if (!is_right) reader.fail("has a line that cannot be");
  }
}

/// Of none the owner is a number that no owner has.
constexpr std::uint64_t no_owner = top_of_layers - 1;

void write_origin(const std::optional<Origin>& origin, ByteWriter& writer) {
  writer.number<std::uint64_t>(origin ? origin->owner : no_owner);
  writer.number<std::uint32_t>(origin ? origin->index : 0);
}

std::optional<Origin> read_origin(ByteReader& reader) {
  Origin origin;
  origin.owner = reader.number<std::uint64_t>();
  origin.index = reader.number<std::uint32_t>();
  if (origin.owner == no_owner) return std::nullopt;
  if (origin.owner >= heaps_end && origin.owner != top_of_layers) {
    reader.fail("has a line that cannot be");
  }
  return origin;
}

void write_ends(const LayerChunk& chunk, ByteWriter& writer) {
  for (const ChunkLine& line : chunk.lines) {
    writer.number(line.line.end.vertex);
    writer.number<std::int32_t>(line.line.end.depth);
    write_origin(line.end, writer);
    write_origin(line.inner, writer);
  }
}

/// @pre kinds, and what lies in planes, have been read.
void read_ends(ByteReader& reader, LayerChunk& chunk) {
  for (ChunkLine& line : chunk.lines) {
    LineEnd& end = line.line.end;
    end.vertex = reader.number<std::int32_t>();
    end.depth = reader.number<std::int32_t>();
    line.end = read_origin(reader);
    line.inner = read_origin(reader);
    const bool meets = end != LineEnd() || line.end || line.inner;
    const bool is_right =
        (!meets || (line.line.of_pml && line.line.stop > 0)) && end.vertex >= -1 &&
        (end.vertex < 0 || line.line.vertices == line.line.stop) && end.depth >= 0 &&
        end.depth <= most_layers && (end.depth > 0) == line.inner.has_value() &&
        !(line.end && line.line.vertices > 0);
    if (!is_right) reader.fail("has a line that cannot be");
  }
}

std::array<Vec3, 2> read_box(ByteReader& reader) {
  std::array<Vec3, 2> box;
  for (Vec3& corner : box) corner = read_vector(reader);
  const Vec3 size = box[1] - box[0];
  if (size.x < 0 || size.y < 0 || size.z < 0) reader.fail("has a box that cannot be");
  return box;
}

/// Whether there is what follows.
bool reads_whether(ByteReader& reader) {
  const auto is_there = reader.number<std::uint32_t>();
  if (is_there > 1) reader.fail("says neither yes nor no to a box");
  return is_there == 1;
}

}  // namespace

std::string layer_chunk_to_bytes(const LayerChunk& chunk) {
  TF_CHECK(chunk.triangles.size() == chunk.surface_triangles.size());
  const std::uint32_t version = version_for(chunk);
  ByteWriter writer = begin_checked(chunk_magic, version);
  writer.number(chunk.path.heap);
  writer.number<std::uint64_t>(chunk.lines.size());
  writer.number<std::uint64_t>(chunk.triangles.size());
  for (const ChunkLine& line : chunk.lines) write_line(line, writer);
  if (version >= chunk_version_with_kinds) {
    for (const ChunkLine& line : chunk.lines) {
      writer.number<std::uint32_t>((line.line.in_tets ? in_tets_bit : 0) |
                                   (line.line.of_pml ? of_pml_bit : 0) |
                                   (line.line.early ? early_bit : 0));
    }
  }
  if (version >= chunk_version_with_sides) write_sides(chunk, writer);
  if (version >= chunk_version_with_fans) write_fans(chunk, writer);
  if (version >= chunk_version_with_lists) {
    writer.number<std::uint32_t>(chunk.within_pml ? 1 : 0);
  }
  if (chunk.within_pml) {
    for (const Vec3& corner : *chunk.within_pml) write_vector(corner, writer);
  }
  if (version >= chunk_version_with_lists) write_lists(chunk, writer);
  if (version >= chunk_version_with_ends) write_ends(chunk, writer);
  writer.array(chunk.triangles);
  writer.array(chunk.surface_triangles);
  return finish_checked(std::move(writer));
}

LayerChunk layer_chunk_from_bytes(std::string_view bytes, const std::string& name) {
  const std::uint32_t version = version_of(bytes);
  ByteReader reader = read_checked(bytes, chunk_magic, version, name);
  LayerChunk chunk;
  chunk.path = {reader.number<std::uint64_t>()};
  if (chunk.path.heap == 0 || chunk.path.heap >= heaps_end) reader.fail("has no place in a tree");
  const std::size_t lines = reader.count();
  const std::size_t triangles = reader.count();
  for (std::size_t i = 0; i < lines; ++i) chunk.lines.push_back(read_line(reader));
  if (version >= chunk_version_with_kinds) {
    const std::uint32_t old_bits = in_tets_bit | of_pml_bit;
    read_kinds(reader, version >= chunk_version_with_fans ? old_bits | early_bit : old_bits, chunk);
  }
  if (version >= chunk_version_with_sides) read_sides(reader, chunk);
  if (version >= chunk_version_with_fans) read_fans(reader, chunk);
  const bool has_box = version >= chunk_version_with_lists ? reads_whether(reader)
                                                           : version == chunk_version_with_box;
  if (has_box) chunk.within_pml = read_box(reader);
  if (version >= chunk_version_with_lists) read_lists(reader, chunk);
  if (version >= chunk_version_with_ends) read_ends(reader, chunk);
  chunk.triangles = reader.array<Triangle>(triangles);
  chunk.surface_triangles = reader.array<std::uint32_t>(triangles);
  reader.expect_end();
  check_triangles(chunk, reader);
  check_sides(chunk, reader);
  return chunk;
}

}  // namespace tetfarm
