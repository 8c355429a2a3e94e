#include "mesh/layers/layer_chunks.h"

#include <gmock/gmock.h>

#include <numeric>
#include <set>

#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

using test::LayeredSphere;
using testing::ElementsAre;
using testing::IsEmpty;

std::int64_t cells_of(const std::vector<LayerChunk>& chunks) {
  return std::accumulate(
      chunks.begin(), chunks.end(), std::int64_t{0},
      [](std::int64_t sum, const LayerChunk& chunk) { return sum + counts_of(chunk).cells(); });
}

std::vector<std::uint64_t> heaps_of(const std::vector<LayerChunk>& chunks) {
  std::vector<std::uint64_t> heaps;
  for (const LayerChunk& chunk : chunks) heaps.push_back(chunk.path.heap);
  return heaps;
}

TEST(LayerChunks, a_small_wall_is_one_chunk_right_of_the_root) {
  const LayeredSphere sphere;
  const std::vector<LayerChunk> chunks = chunks_of(sphere.plan, sphere.surface);
  ASSERT_THAT(heaps_of(chunks), ElementsAre(3));
  EXPECT_EQ(chunks[0].triangles.size(), sphere.surface.triangles.size());
  const std::int64_t triangles = std::ssize(sphere.surface.triangles);
  EXPECT_EQ(counts_of(chunks[0]), (ChunkCounts{.nodes = std::ssize(sphere.surface.vertices) * 4,
                                               .prisms = triangles * 5,
                                               .triangles = triangles}));
}

TEST(LayerChunks, are_as_many_as_the_cells_ask_for_and_about_even) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  const std::int64_t all = cells_of(chunks_of(sphere.plan, sphere.surface));
  for (const std::int64_t wanted : {2, 3, 5, 8}) {
    const std::vector<LayerChunk> chunks =
        chunks_of(sphere.plan, sphere.surface, (all + wanted - 1) / wanted);
    EXPECT_EQ(std::ssize(chunks), wanted);
    EXPECT_EQ(cells_of(chunks), all);
    for (const LayerChunk& chunk : chunks) {
      EXPECT_NEAR(static_cast<double>(counts_of(chunk).cells()),
                  static_cast<double>(all) / static_cast<double>(wanted), 6);
    }
  }
}

TEST(LayerChunks, none_is_empty_however_many_are_asked_for) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  const std::vector<LayerChunk> chunks = chunks_of(sphere.plan, sphere.surface, 1);
  EXPECT_GT(chunks.size(), 10U);
  EXPECT_LE(chunks.size(), sphere.surface.triangles.size());
  for (const LayerChunk& chunk : chunks) EXPECT_FALSE(chunk.triangles.empty());
}

TEST(LayerChunks, have_each_triangle_with_cells_once_and_no_other) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  std::multiset<std::uint32_t> found;
  for (const LayerChunk& chunk : chunks_of(sphere.plan, sphere.surface, 50)) {
    ASSERT_EQ(chunk.triangles.size(), chunk.surface_triangles.size());
    for (std::size_t t = 0; t < chunk.triangles.size(); ++t) {
      const std::uint32_t number = chunk.surface_triangles[t];
      found.insert(number);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(chunk.lines.at(static_cast<std::size_t>(chunk.triangles[t][k])).line.foot,
                  sphere.surface.triangles.at(number)[k]);
      }
    }
  }
  std::multiset<std::uint32_t> expected;
  for (const std::int32_t t : sphere.plan.wall) {
    for (const std::int32_t line : lines_of(sphere.plan, sphere.surface, t)) {
      if (sphere.plan.lines[static_cast<std::size_t>(line)].stop == 0) continue;
      expected.insert(static_cast<std::uint32_t>(t));
      break;
    }
  }
  EXPECT_LT(expected.size(), sphere.surface.triangles.size()) << "there are none at the pole";
  EXPECT_EQ(found, expected);
}

TEST(LayerChunks, a_line_belongs_to_the_first_that_has_it) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  std::map<std::int32_t, std::pair<std::uint64_t, std::uint32_t>> owners;
  std::map<std::uint64_t, std::set<std::uint32_t>> nodes;
  for (const LayerChunk& chunk : chunks_of(sphere.plan, sphere.surface, 50)) {
    for (const ChunkLine& line : chunk.lines) {
      const auto [known, is_new] =
          owners.emplace(line.line.foot, std::pair(line.owner, line.first_node));
      EXPECT_EQ(known->second, std::pair(line.owner, line.first_node));
      if (!is_new) continue;
      EXPECT_EQ(line.owner, chunk.path.heap);
      for (int level = 1; level < line.line.stop; ++level) {
        const auto number = line.first_node + static_cast<std::uint32_t>(level) - 1;
        EXPECT_TRUE(nodes[chunk.path.heap].insert(number).second) << "two nodes with one number";
      }
    }
    EXPECT_EQ(std::ssize(nodes[chunk.path.heap]), counts_of(chunk).nodes);
    EXPECT_TRUE(nodes[chunk.path.heap].empty() ||
                *nodes[chunk.path.heap].rbegin() + 1 == nodes[chunk.path.heap].size());
  }
}

TEST(LayerChunks, the_table_is_a_whole_tree_with_the_top_at_its_root) {
  const LayeredSphere sphere;
  const std::vector<LayerChunk> one = chunks_of(sphere.plan, sphere.surface);
  EXPECT_EQ(layer_table(one, 77), "cut 1 77\nleaf 3 648 0 320 0 1600\n");
  const std::vector<LayerChunk> three = chunks_of(sphere.plan, sphere.surface, 600);
  ASSERT_THAT(heaps_of(three), ElementsAre(12, 13, 7));
  EXPECT_THAT(layer_table(three, 9), testing::StartsWith("cut 1 9\ncut 3 0\ncut 6 0\nleaf 12 "));
}

TEST(LayerChunks, are_none_where_nothing_grows) {
  LayeredSphere sphere;
  for (LayerLine& line : sphere.plan.lines) line.stop = 0;
  EXPECT_THAT(chunks_of(sphere.plan, sphere.surface), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
