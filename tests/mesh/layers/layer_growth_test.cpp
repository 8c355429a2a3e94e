#include "mesh/layers/layer_growth.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/array_index.h"
#include "mesh/core/surface_mesh.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_box.h"
#include "tests/mesh/layers/layered_sphere.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {
namespace {

using test::GrownWhole;
using test::LayeredBox;
using test::LayeredSphere;
using testing::IsEmpty;
using testing::SizeIs;

template <class Layered>
GrownWhole whole_of(const Layered& layered, std::int64_t cells) {
  return test::grown_whole(layered.plan, layered.surface, cells);
}

template <class Layered>
double volume_between(const Layered& sphere) {
  const Subdomain rest =
      unlayered_domain(sphere.plan, sphere.surface, unlayered_path, top_of_layers).root;
  return enclosed_volume(sphere.surface.vertices, sphere.surface.triangles) -
         enclosed_volume(rest.vertices, rest.triangles);
}

TEST(LayerGrowth, fills_what_lies_between_wall_and_top_in_however_many_chunks) {
  for (const LayeredSphere& sphere : {LayeredSphere(), LayeredSphere::uneven()}) {
    const std::size_t nodes = whole_of(sphere, 1'000'000).nodes();
    for (const std::int64_t cells : {1'000'000, 300, 20}) {
      const GrownWhole whole = whole_of(sphere, cells);
      EXPECT_EQ(whole.open_faces(), 0U);
      EXPECT_EQ(whole.nodes(), nodes);
      EXPECT_NEAR(whole.volume(), volume_between(sphere), 1e-12);
    }
  }
}

TEST(LayerGrowth, closes_its_sides_in_planes_with_quads_and_triangles) {
  for (const int step : {1, 3}) {
    const LayeredBox box(step);
    const std::size_t nodes = whole_of(box, 1'000'000).nodes();
    for (const std::int64_t cells : {1'000'000, 100, 10}) {
      const GrownWhole whole = whole_of(box, cells);
      EXPECT_EQ(whole.open_faces(), 0U);
      EXPECT_EQ(whole.nodes(), nodes);
    }
  }
}

/// Bodies with fans all over their edges, with fans that end, and with some lines that stop early.
std::vector<test::LayeredBody> fanned_bodies(bool in_tets = false) {
  std::vector<test::LayeredBody> bodies;
  const auto fanned = [in_tets](double first, int count, double degrees) {
    LayerRequest request = test::fanned(first, count, degrees);
    request.in_tets = in_tets;
    return request;
  };
  bodies.emplace_back(test::cube_in_box(3), fanned(0.02, 6, 60));
  bodies.emplace_back(test::lens_in_box(6, 5, 5), fanned(0.002, 10, 45));
  bodies.emplace_back(test::lens_in_box(6, 20, 150), fanned(0.01, 6, 60));
  LayerRequest rough = fanned(0.05, 8, 60);
  rough.step = 3;
  bodies.emplace_back(test::lens_in_box(6, 40, 40), rough);
  bodies.emplace_back(test::cube_in_box(3), rough);
  // Down to none at one corner.
  LayerPlan& plan = bodies.back().plan;
  for (LayerLine& line : plan.lines) {
    const Vec3 from_corner = line.at - Vec3{1, 1, 1};
    const int most = static_cast<int>(std::floor(2 * norm(from_corner)));
    line.stop = std::min(line.stop, most);
  }
  return bodies;
}

TEST(LayerGrowth, closes_fans_in_however_many_chunks) {
  std::int64_t early = 0;
  for (const test::LayeredBody& body : fanned_bodies()) {
    EXPECT_FALSE(body.plan.fans.empty());
    for (const LayerLine& line : body.plan.lines) early += line.early ? 1 : 0;
    const std::size_t nodes = whole_of(body, 1'000'000).nodes();
    for (const std::int64_t cells : {1'000'000, 500, 30}) {
      const GrownWhole whole = whole_of(body, cells);
      EXPECT_EQ(whole.open_faces(), 0U);
      EXPECT_EQ(whole.nodes(), nodes);
      EXPECT_NEAR(whole.volume(), volume_between(body), 1e-10);
    }
  }
  EXPECT_GT(early, 0);
}

TEST(LayerGrowth, makes_what_the_chunk_counts_also_in_fans) {
  for (const test::LayeredBody& body : fanned_bodies()) {
    for (const LayerChunk& chunk : chunks_of(body.plan, body.surface, 200)) {
      const GrownLayers layers = grow(chunk);
      const ChunkCounts counts = counts_of(chunk);
      EXPECT_EQ(std::ssize(layers.mesh.tets), counts.tets);
      EXPECT_EQ(std::ssize(layers.blocks[ElementType::pyramid].regions), counts.pyramids);
      EXPECT_EQ(std::ssize(layers.blocks[ElementType::prism].regions), counts.prisms);
      EXPECT_EQ(std::ssize(layers.marks[CellMark::layer]), counts.cells());
      std::set<std::uint32_t> own;
      for (const Origin& origin : layers.subdomain.node_origin) {
        if (origin.owner == chunk.path.heap) own.insert(origin.index);
      }
      EXPECT_EQ(std::ssize(own), counts.nodes);
      EXPECT_TRUE(own.empty() || *own.rbegin() + 1 == own.size());
    }
  }
}

TEST(LayerGrowth, closes_fans_that_end_in_planes) {
  const test::LayeredPillar pillar;
  const std::size_t nodes = whole_of(pillar, 1'000'000).nodes();
  for (const std::int64_t cells : {1'000'000, 200, 20}) {
    const GrownWhole whole = whole_of(pillar, cells);
    EXPECT_EQ(whole.open_faces(), 0U);
    EXPECT_EQ(whole.nodes(), nodes);
  }
  std::int64_t quads = 0;
  for (const LayerChunk& chunk : chunks_of(pillar.plan, pillar.surface, 300)) {
    const GrownLayers layers = grow(chunk);
    const ChunkCounts counts = counts_of(chunk);
    EXPECT_EQ(std::ssize(layers.blocks[ElementType::quad].regions), counts.quads);
    EXPECT_EQ(std::ssize(layers.subdomain.triangles), counts.triangles);
    quads += counts.quads;
  }
  // Five layers on the 16 edges of the pillar's foot, and four on the two pieces at its corners.
  EXPECT_EQ(quads, 5 * 16 + 4 * 4 * 2);
}

/// Seen from the plane, an early line goes on before its neighbour there.
TEST(LayerGrowth, closes_its_sides_in_planes_also_between_an_early_line_and_one_that_is_not) {
  const auto generators = shapes::surface_generators();
  const auto voxels = std::find_if(generators.begin(), generators.end(), [](const auto& generator) {
    return std::string_view(generator.name) == "voxels";
  });
  ASSERT_NE(voxels, generators.end());
  int divided = 0;
  for (std::uint64_t seed = 100; seed < 150; ++seed) {
    const CheckedSurface checked =
        check_surface(test::with_flat_patches(voxels->make(seed, 1), seed));
    if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
    LayerRequest request = test::request_of({0}, 0.02 * checked.report.median_edge, 3);
    request.fan_cosine = 0.5;
    for (const bool in_tets : {false, true}) {
      request.in_tets = in_tets;
      const auto retreat =
          retreat_planes(checked.surface, plan_layers(checked.surface, std::span(&request, 1)),
                         [](const SurfaceMesh&) { return [](const Vec3&) { return 1.0; }; });
      if (!retreat) continue;
      EXPECT_EQ(test::grown_whole(retreat->plan, retreat->surface, 100).open_faces(), 0U) << seed;
      for (const LayerSide& side : retreat->plan.sides) {
        const auto lines = lines_of(retreat->plan, retreat->surface, side.triangle);
        divided += retreat->plan.lines[at(lines[at(side.corner)])].early !=
                           retreat->plan.lines[at(lines[at((side.corner + 1) % 3)])].early
                       ? 1
                       : 0;
      }
    }
  }
  EXPECT_GT(divided, 10);
}

/// Of each node how many layers it is above the wall: a line's nodes follow its foot.
std::vector<std::int32_t> levels_of_nodes(const GrownLayers& layers) {
  std::vector<std::int32_t> levels;
  for (const Origin& origin : layers.subdomain.node_origin) {
    levels.push_back(origin.owner == 0 ? 0 : levels.back() + 1);
  }
  return levels;
}

/// What chunks of layers in tets come to, beside the same layers in prisms and pyramids.
template <class Layered>
void expect_tets_of(const Layered& in_tets, const Layered& undivided, std::int64_t most_cells) {
  const GrownWhole divided = whole_of(in_tets, most_cells);
  const GrownWhole whole = whole_of(undivided, 1'000'000);
  EXPECT_EQ(divided.open_faces(), 0U);
  EXPECT_EQ(divided.nodes(), whole.nodes());
  std::int64_t tets = 0;
  for (const LayerChunk& chunk : chunks_of(in_tets.plan, in_tets.surface, most_cells)) {
    const GrownLayers layers = grow(chunk);
    const ChunkCounts counts = counts_of(chunk);
    EXPECT_EQ(std::ssize(layers.mesh.tets), counts.tets);
    EXPECT_EQ(counts.cells(), counts.tets);
    EXPECT_EQ(counts.quads, 0);
    for (const ElementType type : all_element_types) {
      EXPECT_THAT(layers.blocks[type].regions, IsEmpty());
    }
    EXPECT_EQ(std::ssize(layers.subdomain.triangles), counts.triangles);
    EXPECT_EQ(std::ssize(layers.marks[CellMark::layer]), counts.tets);
    const auto own =
        std::count_if(layers.subdomain.node_origin.begin(), layers.subdomain.node_origin.end(),
                      [&chunk](const Origin& origin) { return origin.owner == chunk.path.heap; });
    EXPECT_LE(own, counts.nodes);
    tets += counts.tets;
  }
  std::int64_t expected = 0;
  for (const LayerChunk& chunk : chunks_of(undivided.plan, undivided.surface)) {
    const ChunkCounts counts = counts_of(chunk);
    expected += 3 * counts.prisms + 2 * counts.pyramids + counts.tets;
  }
  EXPECT_EQ(tets, expected);
}

TEST(LayerGrowth, in_tets_closes_in_however_many_chunks_where_lines_end_at_different_levels) {
  const LayeredSphere undivided = LayeredSphere::uneven();
  LayeredSphere in_tets = LayeredSphere::uneven();
  for (LayerLine& line : in_tets.plan.lines) line.in_tets = true;
  for (const std::int64_t cells : {1'000'000, 300, 20}) expect_tets_of(in_tets, undivided, cells);
}

TEST(LayerGrowth, in_tets_closes_fans_in_however_many_chunks) {
  const std::vector<test::LayeredBody> undivided = fanned_bodies();
  const std::vector<test::LayeredBody> in_tets = fanned_bodies(true);
  for (std::size_t i = 0; i < undivided.size(); ++i) {
    EXPECT_FALSE(in_tets[i].plan.fans.empty());
    for (const std::int64_t cells : {1'000'000, 500, 30}) {
      expect_tets_of(in_tets[i], undivided[i], cells);
    }
  }
}

TEST(LayerGrowth, in_tets_closes_its_sides_in_planes_with_triangles_of_the_surface) {
  for (const int step : {1, 3}) {
    for (const std::int64_t cells : {1'000'000, 100, 10}) {
      expect_tets_of(LayeredBox(step, true), LayeredBox(step), cells);
    }
  }
  for (const std::int64_t cells : {1'000'000, 200, 20}) {
    expect_tets_of(test::LayeredPillar(5, true), test::LayeredPillar(5), cells);
  }
}

TEST(LayerGrowth, in_tets_marks_each_tet_with_its_layer) {
  LayeredSphere sphere = LayeredSphere::uneven();
  const ChunkCounts undivided = counts_of(chunks_of(sphere.plan, sphere.surface).at(0));
  for (LayerLine& line : sphere.plan.lines) line.in_tets = true;
  const GrownLayers layers = grow(chunks_of(sphere.plan, sphere.surface).at(0));
  EXPECT_GT(undivided.pyramids, 0);
  const std::vector<std::int32_t> levels = levels_of_nodes(layers);
  for (std::size_t t = 0; t < layers.mesh.tets.size(); ++t) {
    std::int32_t highest = 0;
    for (const std::int32_t v : layers.mesh.tets[t]) highest = std::max(highest, levels[at(v)]);
    EXPECT_EQ(layers.marks[CellMark::layer].at(t), highest);
  }
}

/// Places in the surface and in the chunks that share it.
TEST(LayerGrowth, has_nodes_and_triangles_of_the_surface_where_the_surface_has_them) {
  for (const bool in_tets : {false, true}) {
    const LayeredBox box(3, in_tets);
    std::int64_t above_the_wall = 0;
    for (const LayerChunk& chunk : chunks_of(box.plan, box.surface, 100)) {
      const GrownLayers layers = grow(chunk);
      const Subdomain& grown = layers.subdomain;
      for (std::size_t v = 0; v < grown.vertices.size(); ++v) {
        if (grown.node_origin[v].owner != 0) continue;
        EXPECT_EQ(grown.vertices[v], box.surface.vertices.at(grown.node_origin[v].index));
      }
      for (std::size_t t = 0; t < grown.triangles.size(); ++t) {
        Triangle nodes{};
        for (std::size_t k = 0; k < 3; ++k) {
          const Origin& origin = grown.node_origin[at(grown.triangles[t][k])];
          EXPECT_EQ(origin.owner, 0U);
          nodes[k] = static_cast<std::int32_t>(origin.index);
        }
        EXPECT_EQ(nodes, box.surface.triangles.at(grown.triangle_origin[t].index));
        above_the_wall += t >= chunk.triangles.size() ? 1 : 0;
      }
    }
    EXPECT_GT(above_the_wall, in_tets ? 100 : 0);
  }
}

TEST(LayerGrowth, makes_what_the_chunk_counts_also_beside_planes) {
  const LayeredBox box;
  std::int64_t quads = 0;
  for (const LayerChunk& chunk : chunks_of(box.plan, box.surface, 100)) {
    const GrownLayers layers = grow(chunk);
    const ChunkCounts counts = counts_of(chunk);
    EXPECT_EQ(std::ssize(layers.blocks[ElementType::quad].regions), counts.quads);
    EXPECT_EQ(std::ssize(layers.subdomain.triangles), counts.triangles);
    const auto own =
        std::count_if(layers.subdomain.node_origin.begin(), layers.subdomain.node_origin.end(),
                      [&chunk](const Origin& origin) { return origin.owner == chunk.path.heap; });
    EXPECT_EQ(own, counts.nodes);
    quads += counts.quads;
  }
  EXPECT_GT(quads, 0);
}

TEST(LayerGrowth, makes_what_the_chunk_counts) {
  for (const LayerChunk& chunk :
       chunks_of(LayeredSphere::uneven().plan, LayeredSphere::uneven().surface, 200)) {
    const GrownLayers layers = grow(chunk);
    const ChunkCounts counts = counts_of(chunk);
    EXPECT_EQ(std::ssize(layers.mesh.tets), counts.tets);
    EXPECT_EQ(std::ssize(layers.blocks[ElementType::pyramid].regions), counts.pyramids);
    EXPECT_EQ(std::ssize(layers.blocks[ElementType::prism].regions), counts.prisms);
    EXPECT_EQ(layers.mesh.boundary_nodes, std::ssize(layers.mesh.nodes));
    const auto own =
        std::count_if(layers.subdomain.node_origin.begin(), layers.subdomain.node_origin.end(),
                      [&chunk](const Origin& origin) { return origin.owner == chunk.path.heap; });
    EXPECT_LE(own, counts.nodes) << "nodes of lines that it does not own are another's";
  }
}

TEST(LayerGrowth, marks_each_cell_with_the_layer_that_its_highest_node_is_on) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  const GrownLayers layers = grow(chunks_of(sphere.plan, sphere.surface).at(0));
  const std::vector<std::int32_t> levels = levels_of_nodes(layers);
  std::vector<std::int32_t> highest;
  const auto add = [&](std::span<const std::int32_t> nodes) {
    std::int32_t level = 0;
    for (const std::int32_t v : nodes)
      level = std::max(level, levels.at(static_cast<std::size_t>(v)));
    highest.push_back(level);
  };
  for (const Tet& tet : layers.mesh.tets) add(tet);
  for_each_block_cell(layers.blocks, [&](ElementType, std::span<const std::int32_t> nodes,
                                         std::int32_t) { add(nodes); });
  EXPECT_EQ(layers.marks[CellMark::layer], highest);
  EXPECT_EQ(*std::max_element(highest.begin(), highest.end()), 5);
}

TEST(LayerGrowth, has_cells_of_every_kind_where_lines_end_at_different_levels) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  const ChunkCounts counts = counts_of(chunks_of(sphere.plan, sphere.surface).at(0));
  EXPECT_GT(counts.tets, 0);
  EXPECT_GT(counts.pyramids, 0);
  EXPECT_GT(counts.prisms, 0);
}

TEST(LayerGrowth, names_cells_that_are_flat_or_turned) {
  const LayeredSphere sphere;
  LayerChunk chunk = chunks_of(sphere.plan, sphere.surface).at(0);
  Vec3& along = chunk.lines.at(7).line.along;
  along = -1.0 * along;
  const std::vector<std::string> complaints = validate(grow(chunk));
  ASSERT_THAT(complaints, testing::Not(IsEmpty()));
  EXPECT_THAT(complaints[0], testing::MatchesRegex("the prism near \\(.*\\) is flat or turned"));
  EXPECT_THAT(complaints, SizeIs(testing::Le(20)));
}

TEST(LayerGrowth, tells_of_each_node_the_foot_and_the_level_of_its_line) {
  const LayeredSphere sphere = LayeredSphere::uneven();
  for (const LayerChunk& chunk : chunks_of(sphere.plan, sphere.surface, 200)) {
    const GrownLayers layers = grow(chunk);
    const std::vector<Origin>& origins = layers.subdomain.node_origin;
    ASSERT_EQ(layers.feet.foot.size(), origins.size());
    std::vector<std::int32_t> levels = levels_of_nodes(layers);
    EXPECT_EQ(layers.feet.depth, levels);
    for (std::size_t v = 0; v < origins.size(); ++v) {
      const auto foot = static_cast<std::size_t>(layers.feet.foot[v]);
      EXPECT_EQ(origins.at(foot).owner, 0U) << "a vertex of the surface";
      const LayerLine& line = sphere.plan.lines.at(
          static_cast<std::size_t>(sphere.plan.vertex2line.at(origins[foot].index)));
      EXPECT_EQ(layers.mesh.nodes[v], point_of(line, layers.feet.depth[v]));
    }
  }
}

TEST(LayerGrowth, has_a_node_in_the_middle_of_a_fan_on_the_first_layer_of_one_of_its_feet) {
  for (const test::LayeredBody& body : fanned_bodies()) {
    for (const LayerChunk& chunk : chunks_of(body.plan, body.surface, 300)) {
      const GrownLayers layers = grow(chunk);
      const auto first = static_cast<std::size_t>(std::ssize(layers.mesh.nodes) -
                                                  counts_of(chunk).nodes + nodes_of_lines(chunk));
      std::size_t centre = first;
      for (const ChunkFan& fan : chunk.fans) {
        if (!has_centre(lines_of(chunk, fan))) continue;
        const auto foot = static_cast<std::size_t>(layers.feet.foot.at(centre));
        EXPECT_EQ(layers.feet.depth.at(centre++), 1);
        EXPECT_EQ(layers.mesh.nodes.at(foot), chunk.lines.at(at(fan.lines[0])).line.at);
      }
      EXPECT_EQ(centre, layers.mesh.nodes.size());
    }
  }
}

}  // namespace
}  // namespace tetfarm
