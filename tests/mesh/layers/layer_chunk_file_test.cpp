#include "mesh/layers/layer_chunk_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/hash.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_box.h"
#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

using test::LayeredSphere;
using testing::HasSubstr;
using testing::ThrowsMessage;

LayerChunk some_chunk() {
  const LayeredSphere sphere = LayeredSphere::uneven();
  return chunks_of(sphere.plan, sphere.surface, 60).at(3);
}

/// Those with lines in planes.
std::vector<LayerChunk> chunks_with_sides() {
  const test::LayeredBox box(2);
  std::vector<LayerChunk> chunks = chunks_of(box.plan, box.surface, 60);
  std::erase_if(chunks, [](const LayerChunk& chunk) {
    return std::none_of(chunk.lines.begin(), chunk.lines.end(),
                        [](const ChunkLine& line) { return line.line.vertices > 0; });
  });
  return chunks;
}

constexpr std::size_t first_line_at = 8 + 4 + 3 * 8;

/// `bytes` with the number at `offset` replaced and the checksum made right again.
template <class T>
std::string forged(std::string bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  const Hash128 checksum = hash128(bytes.data(), bytes.size() - 16);
  std::memcpy(bytes.data() + bytes.size() - 16, &checksum.low, 8);
  std::memcpy(bytes.data() + bytes.size() - 8, &checksum.high, 8);
  return bytes;
}

void expect_refused(const std::string& bytes, const std::string& why) {
  EXPECT_THAT([&] { layer_chunk_from_bytes(bytes, "chunk"); },
              ThrowsMessage<CorruptFile>(HasSubstr(why)));
}

TEST(LayerChunkFile, gives_back_what_was_written) {
  const LayerChunk chunk = some_chunk();
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
}

TEST(LayerChunkFile, tells_which_lines_are_in_tets_or_absorb_in_a_version_of_its_own) {
  LayerChunk chunk = some_chunk();
  EXPECT_EQ(layer_chunk_to_bytes(chunk)[8], 1);
  chunk.lines.at(2).line.of_pml = true;
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
  chunk.lines.at(2).line.in_tets = true;
  chunk.lines.at(0).line.in_tets = true;
  const std::string bytes = layer_chunk_to_bytes(chunk);
  EXPECT_EQ(bytes[8], 2);
  EXPECT_EQ(layer_chunk_from_bytes(bytes, "chunk"), chunk);
  const std::size_t flags = first_line_at + chunk.lines.size() * 148;
  expect_refused(forged<std::uint32_t>(bytes, flags, 4), "has a line that cannot be");
}

TEST(LayerChunkFile, tells_the_box_within_absorbing_layers_in_a_version_of_its_own) {
  LayerChunk chunk = some_chunk();
  const std::size_t triangles = chunk.triangles.size();
  chunk.within_pml = {Vec3{-1, 0.5, 2}, Vec3{3, 0.5, 4}};
  const std::string bytes = layer_chunk_to_bytes(chunk);
  EXPECT_EQ(bytes[8], 5);
  EXPECT_EQ(layer_chunk_from_bytes(bytes, "chunk"), chunk);
  const std::size_t lowest = bytes.size() - 16 - triangles * 16 - 6 * 8;
  expect_refused(forged(bytes, lowest, 3.5), "has a box that cannot be");
  expect_refused(forged(bytes, lowest, std::numeric_limits<double>::infinity()),
                 "has a number that is not finite");
}

LayerChunk chunk_with_lists() {
  LayerChunk chunk = some_chunk();
  const std::vector<double> heights(20, 0.25);
  const HeightLaw twenty = law_of_heights(heights);
  for (ChunkLine& line : chunk.lines) line.line.law = twenty;
  chunk.lines.at(1).line.law = HeightLaw{.first = 0.5};
  chunk.lines.at(2).line.law.ratios = HeightRatios(std::vector<double>(30, 1.5));
  chunk.lines.at(2).line.law.share = 0.75;
  return chunk;
}

TEST(LayerChunkFile, tells_lists_of_heights_in_a_version_of_its_own) {
  LayerChunk chunk = chunk_with_lists();
  const std::string bytes = layer_chunk_to_bytes(chunk);
  EXPECT_EQ(bytes[8], 6);
  EXPECT_EQ(layer_chunk_from_bytes(bytes, "chunk"), chunk);
  chunk.within_pml = {Vec3{-1, 0.5, 2}, Vec3{3, 0.5, 4}};
  chunk.lines.at(0).line.in_tets = true;
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
}

TEST(LayerChunkFile, refuses_lists_of_heights_that_cannot_be) {
  const LayerChunk chunk = chunk_with_lists();
  const std::string bytes = layer_chunk_to_bytes(chunk);
  const std::size_t lines_at =
      bytes.size() - 16 - chunk.triangles.size() * 16 - chunk.lines.size() * 12;
  const std::size_t lists_at = lines_at - (8 + 19 * 8) - (8 + 30 * 8) - 8;
  const double infinite = std::numeric_limits<double>::infinity();
  expect_refused(forged<std::uint32_t>(bytes, lists_at - 4, 2), "says neither yes nor no to a box");
  expect_refused(forged<std::uint64_t>(bytes, lists_at + 8, 1000),
                 "a list of heights that is too long");
  expect_refused(forged(bytes, lists_at + 16, 0.49), "has heights that cannot be");
  expect_refused(forged(bytes, lists_at + 16, 2.01), "has heights that cannot be");
  expect_refused(forged(bytes, lists_at + 16, infinite), "has a number that is not finite");
  const char* line = "has a line that cannot be";
  expect_refused(forged<std::int32_t>(bytes, lines_at, 2), line);
  expect_refused(forged<std::int32_t>(bytes, lines_at, -2), line);
  expect_refused(forged(bytes, lines_at + 4, 1.5), line);
  expect_refused(forged(bytes, lines_at + 4, -0.5), line);
  expect_refused(forged(bytes, lines_at + 12 + 4, 0.5), line);
  LayerChunk higher = chunk;
  higher.lines.at(0).line.stop = 21;
  expect_refused(layer_chunk_to_bytes(higher), line);
}

TEST(LayerChunkFile, tells_what_lies_in_planes_in_a_version_of_its_own) {
  for (const LayerChunk& chunk : chunks_with_sides()) {
    const std::string bytes = layer_chunk_to_bytes(chunk);
    EXPECT_EQ(bytes[8], 3);
    EXPECT_EQ(layer_chunk_from_bytes(bytes, "chunk"), chunk);
  }
}

TEST(LayerChunkFile, refuses_sides_that_cannot_be) {
  int broken = 0;
  for (const LayerChunk& chunk : chunks_with_sides()) {
    const auto expect_broken = [&](const std::string& why, const auto& break_it) {
      LayerChunk copy = chunk;
      break_it(copy);
      expect_refused(layer_chunk_to_bytes(copy), why);
      ++broken;
    };
    const char* line = "has a line that cannot be";
    expect_broken(line, [](LayerChunk& c) { c.lines[0].line.vertices = -1; });
    expect_broken(line, [](LayerChunk& c) {
      c.lines[0].line.vertices = c.lines[0].line.stop + 1;
      c.lines[0].line.first_vertex = 0;
    });
    expect_broken(line, [](LayerChunk& c) {
      c.lines[0].line.stop = c.lines[0].line.vertices = 1;
      c.lines[0].line.first_vertex = -1;
    });
    expect_broken("has a side that is at no edge", [](LayerChunk& c) {
      c.sides.push_back({{0, 0}, 1, -1});
    });
    if (chunk.sides.empty()) continue;
    expect_broken("has a side that is at no edge",
                  [](LayerChunk& c) { c.sides.push_back(c.sides.front()); });
    expect_broken("has a side that cannot be", [](LayerChunk& c) { c.sides[0].patch = -1; });
    expect_broken("has a side that cannot be",
                  [](LayerChunk& c) { c.sides[0].last = c.sides[0].last < 0 ? 0 : -1; });
    if (chunk.sides[0].last < 0) continue;
    expect_broken("has a side that cannot be", [](LayerChunk& c) {
      for (const std::int32_t l : c.sides[0].lines) {
        c.lines.at(static_cast<std::size_t>(l)).line.vertices = 0;
        c.lines.at(static_cast<std::size_t>(l)).line.first_vertex = -1;
      }
    });
  }
  EXPECT_GT(broken, 20);
}

LayerChunk chunk_with_fans() {
  const test::LayeredBody body(test::lens_in_box(4, 40, 40), test::fanned(0.05, 4, 60));
  return chunks_of(body.plan, body.surface).at(0);
}

TEST(LayerChunkFile, tells_of_fans_in_a_version_of_its_own) {
  const LayerChunk chunk = chunk_with_fans();
  EXPECT_GT(chunk.fans.size(), 20U);
  const std::string bytes = layer_chunk_to_bytes(chunk);
  EXPECT_EQ(bytes[8], 4);
  EXPECT_EQ(layer_chunk_from_bytes(bytes, "chunk"), chunk);
  LayerChunk early = some_chunk();
  early.lines.at(1).line.early = true;
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(early), "chunk"), early);
}

TEST(LayerChunkFile, refuses_fans_that_cannot_be) {
  const LayerChunk chunk = chunk_with_fans();
  const auto expect_broken = [&](const std::string& why, const auto& break_it) {
    LayerChunk broken = chunk;
    break_it(broken);
    expect_refused(layer_chunk_to_bytes(broken), why);
  };
  const char* fan = "has a fan that cannot be";
  const auto line = [](LayerChunk& c, std::size_t k) -> LayerLine& {
    return c.lines.at(static_cast<std::size_t>(c.fans[0].lines[k])).line;
  };
  expect_broken("has a fan with a line that does not exist",
                [](LayerChunk& c) { c.fans[0].lines[2] = 1 << 30; });
  expect_broken("has a fan with a line that does not exist",
                [](LayerChunk& c) { c.fans[0].lines[3] = -1; });
  expect_broken(fan, [](LayerChunk& c) { c.fans[0].lines[1] = c.fans[0].lines[0]; });
  expect_broken(fan, [](LayerChunk& c) { std::swap(c.fans[0].lines[0], c.fans[0].lines[2]); });
  expect_broken(fan, [&](LayerChunk& c) { line(c, 0).stop = 0; });
  expect_broken(fan, [&](LayerChunk& c) { line(c, 1).early = !line(c, 1).early; });
  expect_broken(fan, [&](LayerChunk& c) {
    for (std::size_t k = 0; k < 4; ++k) line(c, k).stop = 0;
  });
  expect_broken(fan, [&](LayerChunk& c) {
    c.fans[0].lines[3] = c.fans[0].lines[2];
    for (std::size_t k = 0; k < 4; ++k) line(c, k).early = false;
  });
}

TEST(LayerChunkFile, refuses_ends_of_fans_that_cannot_be) {
  const test::LayeredPillar pillar;
  const LayerChunk chunk = chunks_of(pillar.plan, pillar.surface).at(0);
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
  const auto found = std::find_if(chunk.fans.begin(), chunk.fans.end(), [](const ChunkFan& fan) {
    return fan.ends[0].patch >= 0 || fan.ends[1].patch >= 0;
  });
  ASSERT_NE(found, chunk.fans.end());
  const auto number = static_cast<std::size_t>(found - chunk.fans.begin());
  const std::size_t at_plane = found->ends[0].patch >= 0 ? 0 : 1;
  const auto expect_broken = [&](const auto& break_it) {
    LayerChunk broken = chunk;
    break_it(broken, broken.fans[number].ends.at(at_plane));
    expect_refused(layer_chunk_to_bytes(broken), "has a fan that cannot be");
  };
  expect_broken([](LayerChunk&, FanEnd& end) { end.triangle = -1; });
  expect_broken([](LayerChunk&, FanEnd& end) { end.patch = -1; });
  expect_broken([](LayerChunk&, FanEnd& end) { end = {-2, -2}; });
  expect_broken([&](LayerChunk& c, FanEnd&) {
    const std::int32_t line = lines_at_end(c.fans[number].lines, at_plane)[0];
    c.lines.at(static_cast<std::size_t>(line)).line.low_vertex = -1;
  });
}

TEST(LayerChunkFile, refuses_sides_in_tets_that_cannot_be) {
  const test::LayeredBox box(2, true);
  int broken = 0;
  for (const LayerChunk& chunk : chunks_of(box.plan, box.surface, 200)) {
    EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
    if (chunk.sides.empty()) continue;
    const auto expect_broken = [&](const auto& break_it) {
      LayerChunk copy = chunk;
      break_it(copy);
      expect_refused(layer_chunk_to_bytes(copy), "has a side that cannot be");
      ++broken;
    };
    EXPECT_GE(chunk.sides[0].last, 0);
    expect_broken([](LayerChunk& c) { c.sides[0].last = -1; });
    expect_broken([](LayerChunk& c) {
      c.sides[0].last = std::numeric_limits<std::int32_t>::max() - 2 * most_layers + 1;
    });
    expect_broken([](LayerChunk& c) {
      for (const std::int32_t l : c.sides[0].lines) {
        LayerLine& line = c.lines.at(static_cast<std::size_t>(l)).line;
        if (line.vertices < 2) continue;
        --line.vertices;
        ++line.first_vertex;
        return;
      }
    });
  }
  EXPECT_GT(broken, 10);
}

TEST(LayerChunkFile, refuses_ends_of_fans_in_tets_that_cannot_be) {
  const test::LayeredPillar pillar(5, true);
  const LayerChunk chunk = chunks_of(pillar.plan, pillar.surface).at(0);
  EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
  const auto found = std::find_if(chunk.fans.begin(), chunk.fans.end(),
                                  [](const ChunkFan& fan) { return fan.ends[0].patch >= 0; });
  ASSERT_NE(found, chunk.fans.end());
  const auto number = static_cast<std::size_t>(found - chunk.fans.begin());
  LayerChunk far = chunk;
  far.fans[number].ends[0].triangle = std::numeric_limits<std::int32_t>::max();
  expect_refused(layer_chunk_to_bytes(far), "has a fan that cannot be");
  LayerChunk low = chunk;
  LayerLine& line = low.lines.at(static_cast<std::size_t>(found->lines[0])).line;
  --line.vertices;
  ++line.first_vertex;
  line.low_vertex = 3;
  expect_refused(layer_chunk_to_bytes(low), "has a fan that cannot be");
}

TEST(LayerChunkFile, refuses_any_byte_that_changed_and_any_cut) {
  const std::string bytes = layer_chunk_to_bytes(some_chunk());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_THROW(layer_chunk_from_bytes(changed, "chunk"), CorruptFile) << i;
  }
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_THROW(layer_chunk_from_bytes(bytes.substr(0, size), "chunk"), CorruptFile) << size;
  }
}

TEST(LayerChunkFile, refuses_lines_that_cannot_be) {
  const std::string bytes = layer_chunk_to_bytes(some_chunk());
  const char* what = "has a line that cannot be";
  expect_refused(forged(bytes, first_line_at, std::int32_t{-1}), what);
  expect_refused(forged(bytes, first_line_at + 4, std::int32_t{-1}), what);
  expect_refused(forged(bytes, first_line_at + 4, std::int32_t{most_layers + 1}), what);
  expect_refused(forged(bytes, first_line_at + 128, std::int32_t{0}), what);
  expect_refused(forged(bytes, first_line_at + 136, std::uint64_t{0}), what);
  expect_refused(forged(bytes, first_line_at + 136, std::uint64_t{1} << 63U), what);
  expect_refused(forged(bytes, first_line_at + 8, std::numeric_limits<double>::quiet_NaN()),
                 "has a number that is not finite");
}

TEST(LayerChunkFile, refuses_what_breaks_the_invariants_of_a_chunk) {
  const LayerChunk chunk = some_chunk();
  const auto expect_broken = [&](const std::string& why, const auto& break_it) {
    LayerChunk broken = chunk;
    break_it(broken);
    expect_refused(layer_chunk_to_bytes(broken), why);
  };
  expect_broken("has no place in a tree", [](LayerChunk& c) { c.path = {0}; });
  expect_broken("has a triangle with a line that does not exist",
                [](LayerChunk& c) { c.triangles[0][1] = std::ssize(c.lines) > 0 ? 1 << 30 : 0; });
  expect_broken("has a triangle without layers above it",
                [](LayerChunk& c) { c.triangles[0][1] = c.triangles[0][0]; });
  expect_broken("has a triangle without layers above it", [](LayerChunk& c) {
    for (ChunkLine& line : c.lines) line.line.stop = 0;
  });
  expect_broken("has a line of no triangle",
                [](LayerChunk& c) { c.lines.push_back(c.lines.front()); });
}

}  // namespace
}  // namespace tetfarm
