#include "mesh/layers/pml_blocks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "mesh/core/cell_marks.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_chunk_file.h"
#include "mesh/layers/plane_retreat.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_sphere.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using test::box_with_patches;
using test::grown_whole;
using testing::HasSubstr;

constexpr Vec3 low{-0.1, 0.2, 0.3};
constexpr Vec3 high{0.9, 1.5, 1.1};
constexpr double height = 0.13;

HeightLaw equal_heights(double of_each) {
  return {.first = of_each, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
}

LayerPlan plan_without_layers(const SurfaceMesh& surface) {
  LayerPlan none;
  none.vertex2line.assign(surface.vertices.size(), -1);
  return none;
}

/// A box that is not symmetric in any way, with layers beyond some of its sides.
struct BlockedBox {
  SurfaceMesh given;
  std::vector<std::int32_t> patches;
  int layers = 3;
  PmlBlocks blocks;

  explicit BlockedBox(std::vector<std::int32_t> sides = {0, 1, 2, 3, 4, 5}, int count = 3)
      : given(box_with_patches(low, high, 3)), patches(std::move(sides)), layers(count) {
    blocks = with_pml_blocks(given, plan_without_layers(given), request());
  }

  PmlBlocksRequest request() const { return {patches, equal_heights(height), layers}; }

  Box3 outside() const { return bounding_box(blocks.surface.vertices); }
  double volume_of_layers() const {
    const Vec3 size = outside().size();
    const Vec3 inner = high - low;
    return size.x * size.y * size.z - inner.x * inner.y * inner.z;
  }
};

/// Of all sides, of five, of four that leave a corridor, of two that meet, and of one.
std::vector<std::vector<std::int32_t>> choices_of_sides() {
  return {{0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 5}, {2, 3, 4, 5}, {1, 3}, {2}};
}

TEST(PmlBlocks, fill_a_larger_box_without_a_gap_in_however_many_chunks) {
  for (const int layers : {1, 2, 3}) {
    const BlockedBox box({0, 1, 2, 3, 4, 5}, layers);
    std::size_t nodes = 0;
    for (const std::int64_t cells : {1'000'000, 500, 60}) {
      const test::GrownWhole whole = grown_whole(box.blocks.plan, box.blocks.surface, cells);
      EXPECT_EQ(whole.open_faces(), 0U);
      EXPECT_NEAR(whole.volume(), box.volume_of_layers(), 1e-12);
      if (nodes == 0) nodes = whole.nodes();
      EXPECT_EQ(whole.nodes(), nodes);
    }
    const double thickness = layers * height;
    EXPECT_LT(distance(box.outside().low, low - thickness * Vec3{1, 1, 1}), 1e-15);
    EXPECT_LT(distance(box.outside().high, high + thickness * Vec3{1, 1, 1}), 1e-15);
  }
}

TEST(PmlBlocks, of_some_sides_carry_on_the_planes_that_these_end_at) {
  for (const std::vector<std::int32_t>& sides : choices_of_sides()) {
    const BlockedBox box(sides);
    const SurfaceMesh& surface = box.blocks.surface;
    const test::GrownWhole whole = grown_whole(box.blocks.plan, surface, 100);
    EXPECT_EQ(whole.open_faces(), 0U);
    EXPECT_TRUE(check_surface(surface).report.defects.empty());
    EXPECT_NEAR(whole.volume(), domain_volume(surface) - domain_volume(box.given), 1e-12);
    const Box3 outside = box.outside();
    const auto has = [&](std::int32_t side) {
      return std::find(sides.begin(), sides.end(), side) != sides.end();
    };
    EXPECT_EQ(outside.low.y == low.y, !has(4));
    EXPECT_EQ(outside.low.z == low.z, !has(0));
    EXPECT_EQ(outside.high.x == high.x, !has(3));
  }
}

TEST(PmlBlocks, give_each_triangle_of_the_outside_the_patch_of_its_side) {
  const BlockedBox box({0, 1, 2, 3, 5});
  const Box3 outside = box.outside();
  const SurfaceMesh& surface = box.blocks.surface;
  ASSERT_EQ(surface.patch_of_triangle.size(), surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto all_at = [&](int axis, double place) {
      return std::all_of(surface.triangles[t].begin(), surface.triangles[t].end(),
                         [&](std::int32_t v) { return surface.vertices[at(v)][axis] == place; });
    };
    const std::array<bool, 6> is_at = {all_at(2, outside.low.z), all_at(2, outside.high.z),
                                       all_at(0, outside.low.x), all_at(0, outside.high.x),
                                       all_at(1, outside.low.y), all_at(1, outside.high.y)};
    EXPECT_EQ(std::count(is_at.begin(), is_at.end(), true), 1);
    EXPECT_TRUE(is_at.at(at(surface.patch_of_triangle[t])));
  }
}

/// So many layers out along an axis as the point is, from 1; 0: it is not outside.
int depth_along(double p, double from, double to, double of_each) {
  if (p < from) return 1 + static_cast<int>((from - p) / of_each);
  return p > to ? 1 + static_cast<int>((p - to) / of_each) : 0;
}

TEST(PmlBlocks, tell_of_every_cell_the_axes_along_which_all_of_it_is_outside_and_how_deep) {
  for (const std::vector<std::int32_t>& sides : choices_of_sides()) {
    const BlockedBox box(sides);
    std::map<int, int> cells_of_axes;
    for (const LayerChunk& chunk : chunks_of(box.blocks.plan, box.blocks.surface, 200)) {
      const GrownLayers layers = grow(chunk);
      for (std::size_t i = 0; i < layers.mesh.tets.size(); ++i) {
        Box3 round;
        Vec3 middle;
        for (const std::int32_t v : layers.mesh.tets[i]) {
          round.add(layers.mesh.nodes[at(v)]);
          middle += 0.25 * layers.mesh.nodes[at(v)];
        }
        int axes = 0;
        int depth = 0;
        for (int axis = 0; axis < 3; ++axis) {
          const int along = depth_along(middle[axis], low[axis], high[axis], height);
          axes |= along > 0 ? 1 << axis : 0;
          depth = std::max(depth, along);
          EXPECT_TRUE(
              round.high[axis] <= low[axis] + 1e-15 || round.low[axis] >= high[axis] - 1e-15 ||
              (round.low[axis] >= low[axis] - 1e-15 && round.high[axis] <= high[axis] + 1e-15))
              << "a cell of two blocks";
        }
        ASSERT_EQ(layers.marks[CellMark::pml_axes][i], axes);
        ASSERT_EQ(layers.marks[CellMark::pml_depth][i], depth);
        ++cells_of_axes[axes];
      }
    }
    if (sides.size() < 6) continue;
    const int n = 3;  // squares of a side, and layers
    for (const int axis : {1, 2, 4}) EXPECT_EQ(cells_of_axes[axis], 2 * (2 * n * n) * 3 * n);
    for (const int axes : {3, 5, 6}) EXPECT_EQ(cells_of_axes[axes], 4 * n * 6 * n * n);
    EXPECT_EQ(cells_of_axes[7], 8 * 6 * n * n * n);
  }
}

TEST(PmlBlocks, are_as_many_as_was_said) {
  for (const std::vector<std::int32_t>& sides : choices_of_sides()) {
    const BlockedBox box(sides);
    const PmlBlockCounts counts = counts_of_pml_blocks(box.given, box.request());
    std::int64_t tets = 0;
    for (const LayerChunk& chunk : chunks_of(box.blocks.plan, box.blocks.surface)) {
      tets += counts_of(chunk).tets;
    }
    EXPECT_EQ(counts.tets, tets);
    const std::vector<std::int32_t>& patch = box.blocks.surface.patch_of_triangle;
    EXPECT_EQ(counts.outer_triangles, std::count_if(patch.begin(), patch.end(), [&](auto p) {
                return std::find(sides.begin(), sides.end(), p) != sides.end();
              }));
  }
}

TEST(PmlBlocks, count_each_node_from_the_nearest_node_of_the_inner_side) {
  for (const std::vector<std::int32_t>& sides : choices_of_sides()) {
    const BlockedBox box(sides);
    std::map<Origin, Vec3> places;
    std::map<Origin, std::pair<Origin, int>> feet;
    for (const LayerChunk& chunk : chunks_of(box.blocks.plan, box.blocks.surface, 60)) {
      const GrownLayers layers = grow(chunk);
      const std::vector<Origin>& origins = layers.subdomain.node_origin;
      EXPECT_EQ(std::set<Origin>(origins.begin(), origins.end()).size(), origins.size());
      std::map<std::int32_t, Origin> far;
      for (const FarFoot& foot : layers.far_feet) far[foot.node] = foot.foot;
      for (std::size_t v = 0; v < origins.size(); ++v) {
        places[origins[v]] = layers.mesh.nodes[v];
        const auto node = static_cast<std::int32_t>(v);
        ASSERT_EQ(layers.feet.foot[v] == no_foot, far.contains(node));
        const Origin foot = far.contains(node) ? far[node] : origins[at(layers.feet.foot[v])];
        const std::pair on{foot, layers.feet.depth[v]};
        EXPECT_EQ(feet.emplace(origins[v], on).first->second, on) << "two copies of a node";
      }
    }
    for (const auto& [node, on] : feet) {
      const Vec3 p = places.at(node);
      const Vec3 nearest{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y),
                         std::clamp(p.z, low.z, high.z)};
      EXPECT_LT(distance(places.at(on.first), nearest), 1e-14);
      const Vec3 way = p - nearest;
      const double most = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
      EXPECT_NEAR(most, on.second * height, 1e-14);
    }
  }
}

TEST(PmlBlocks, survive_their_file) {
  const BlockedBox box({0, 1, 2, 3, 5});
  const std::vector<LayerChunk> chunks = chunks_of(box.blocks.plan, box.blocks.surface, 200);
  ASSERT_GT(chunks.size(), 2U);
  for (const LayerChunk& chunk : chunks) {
    EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
  }
}

TEST(PmlBlocks, leave_the_numbers_of_all_else_as_they_were) {
  SurfaceMesh hollow = box_with_patches(low, high, 3);
  const SurfaceMesh ball = shapes::sphere({0.4, 0.8, 0.7}, 0.2, 1);
  const auto first = static_cast<std::int32_t>(hollow.vertices.size());
  const std::size_t first_triangle = hollow.triangles.size();
  hollow.vertices.insert(hollow.vertices.end(), ball.vertices.begin(), ball.vertices.end());
  hollow.patch_names.emplace_back("ball");
  for (const auto& [a, b, c] : ball.triangles) {
    hollow.triangles.push_back({first + a, first + c, first + b});
    hollow.patch_of_triangle.push_back(6);
  }
  LayerRequest request = test::request_of({6}, 0.01, 4);
  const LayerPlan plan = plan_layers(hollow, {&request, 1});
  const PmlBlocks blocks =
      with_pml_blocks(hollow, plan, {{0, 1, 2, 3, 4, 5}, equal_heights(height), 2});
  for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
    EXPECT_EQ(blocks.surface.vertices[at(first) + v], ball.vertices[v]);
  }
  for (std::size_t t = first_triangle; t < hollow.triangles.size(); ++t) {
    EXPECT_EQ(blocks.surface.triangles[t], hollow.triangles[t]);
    const auto now = lines_of(blocks.plan, blocks.surface, static_cast<std::int32_t>(t));
    const auto was = lines_of(plan, hollow, static_cast<std::int32_t>(t));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(blocks.plan.lines[at(now[k])], plan.lines[at(was[k])]);
    }
  }
  EXPECT_EQ(grown_whole(blocks.plan, blocks.surface, 300).open_faces(), 0U);
}

std::string refusal_of_blocks(const SurfaceMesh& surface, std::vector<std::int32_t> patches,
                              const std::vector<LayerRequest>& others = {}) {
  return error_text_of<UsageError>([&] {
    require_pml_blocks(surface, {std::move(patches), equal_heights(height), 2}, others);
  });
}

TEST(PmlBlocks, are_refused_with_the_place_and_a_way_out_where_a_patch_is_no_side_of_the_box) {
  EXPECT_THAT(refusal_of_blocks(shapes::sphere({0, 0, 0}, 1, 1), {0}),
              AllOf(HasSubstr("triangle 0 at ("), HasSubstr("corners = \"mitre\"")));
  EXPECT_THAT(refusal_of_blocks(test::turned(box_with_patches(low, high, 2)), {0, 1, 2, 3, 4, 5}),
              AllOf(HasSubstr("lies in none of them"), HasSubstr("corners = \"mitre\"")));
}

TEST(PmlBlocks, stand_on_parts_of_sides_even_where_these_meet_in_a_point) {
  SurfaceMesh box = box_with_patches(low, high, 2);
  box.patch_names.emplace_back("checkered");
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    Vec3 middle;
    for (const std::int32_t v : box.triangles[t]) middle += box.vertices[at(v)] / 3.0;
    const bool is_west = middle.x < (low.x + high.x) / 2;
    const bool is_south = middle.y < (low.y + high.y) / 2;
    if (box.patch_of_triangle[t] == test::floor_patch && is_west == is_south) {
      box.patch_of_triangle[t] = 6;
    }
  }
  const PmlBlocksRequest request{{3, 6}, equal_heights(height), 2};
  require_pml_blocks(box, request, {});
  const PmlBlocks blocks = with_pml_blocks(box, plan_without_layers(box), request);
  const test::GrownWhole whole = grown_whole(blocks.plan, blocks.surface, 50);
  EXPECT_EQ(whole.open_faces(), 0U);
  EXPECT_NEAR(whole.volume(), domain_volume(blocks.surface) - domain_volume(box), 1e-12);
}

TEST(PmlBlocks, are_refused_where_numbers_cannot_tell_their_layers_apart) {
  SurfaceMesh far = box_with_patches(low, high, 2);
  for (Vec3& p : far.vertices) p += Vec3{1e6, 0, 0};
  EXPECT_THAT(error_text_of<UsageError>([&] {
                with_pml_blocks(far, plan_without_layers(far), {{3}, equal_heights(1e-12), 2});
              }),
              HasSubstr("1e-12"));
}

TEST(PmlBlocks, are_refused_where_boundary_layers_meet_them) {
  EXPECT_THAT(
      refusal_of_blocks(box_with_patches(low, high, 3), {3}, {test::request_of({0}, 0.01, 4)}),
      HasSubstr("boundary layers meet them at ("));
}

TEST(PmlBlocks, leave_sides_of_other_layers_that_run_in_planes) {
  const SurfaceMesh box = box_with_patches(low, high, 4);
  const LayerRequest request = test::request_of({4}, 0.01, 3);  // from the south
  const PmlBlocksRequest of_blocks{{5}, equal_heights(height), 2};
  require_pml_blocks(box, of_blocks, {&request, 1});
  std::optional<PlaneRetreat> retreat =
      retreat_planes(box, plan_layers(box, {&request, 1}),
                     [](const SurfaceMesh&) { return [](const Vec3&) { return 0.25; }; });
  ASSERT_TRUE(retreat.has_value());
  const std::size_t sides = retreat->plan.sides.size();
  const PmlBlocks blocks = with_pml_blocks(retreat->surface, std::move(retreat->plan), of_blocks);
  EXPECT_EQ(blocks.plan.sides.size(), 2 * sides);  // as many to the north, where all are alike
  EXPECT_EQ(grown_whole(blocks.plan, blocks.surface, 50).open_faces(), 0U);
}

TEST(PmlBlocks, share_chunks_with_fans_of_other_layers) {
  const SurfaceMesh box = test::cube_in_box(3);
  const LayerRequest request = test::fanned(0.02, 3, 60);
  const PmlBlocksRequest of_blocks{{1}, equal_heights(height), 2};
  ASSERT_EQ(request.patches, std::vector<std::int32_t>{0});
  require_pml_blocks(box, of_blocks, {&request, 1});
  const LayerPlan plan = plan_layers(box, {&request, 1});
  ASSERT_FALSE(plan.fans.empty());
  const PmlBlocks blocks = with_pml_blocks(box, plan, of_blocks);
  for (const std::int64_t cells : {1'000'000, 100}) {
    EXPECT_EQ(grown_whole(blocks.plan, blocks.surface, cells).open_faces(), 0U);
  }
}

}  // namespace
}  // namespace tetfarm
