#include "mesh/layers/pml_offset.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "mesh/layers/layer_chunks.h"
#include "mesh/layers/layer_growth.h"
#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::array<std::int32_t, 1> first_patch = {0};

SurfaceMesh moved(const SurfaceMesh& surface, double thickness) {
  return moved_outwards(surface, pml_directions(surface, first_patch), thickness);
}

/// A ball, patch 1, in a box, patch 0.
SurfaceMesh ball_in_box() {
  SurfaceMesh surface = shapes::box({-2, -2, -2}, {2, 2, 2}, 2);
  const auto offset = static_cast<std::int32_t>(surface.vertices.size());
  surface.patch_of_triangle.assign(surface.triangles.size(), 0);
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  surface.vertices.insert(surface.vertices.end(), ball.vertices.begin(), ball.vertices.end());
  for (const auto& [a, b, c] : ball.triangles) {
    surface.triangles.push_back({a + offset, c + offset, b + offset});
  }
  surface.patch_of_triangle.resize(surface.triangles.size(), 1);
  surface.patch_names = {"outer", "body"};
  return surface;
}

LayerPlan pml_plan(const SurfaceMesh& surface, SurfaceMesh& outside, double height, int layers,
                   bool in_tets = true) {
  LayerRequest request;
  request.patches = {0};
  request.law = {.first = height, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
  request.count = layers;
  request.in_tets = in_tets;
  const std::vector<Vec3> outwards = pml_directions(surface, first_patch);
  for (const Vec3& way : outwards) request.ways.push_back(-way);
  outside = moved_outwards(surface, outwards, height * layers);
  return plan_layers(outside, {&request, 1});
}

TEST(PmlOffset, keeps_a_box_a_box_to_the_last_bit) {
  const SurfaceMesh box = shapes::box({-0.3, 0.1, 0.7}, {1.1, 2.3, 3.9}, 3);
  const SurfaceMesh outside = moved(box, 0.7);
  const Box3 before = bounding_box(box.vertices);
  const Box3 after = bounding_box(outside.vertices);
  for (std::size_t v = 0; v < box.vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = box.vertices[v][axis];
      const double expected = x == before.low[axis]    ? after.low[axis]
                              : x == before.high[axis] ? after.high[axis]
                                                       : x;
      EXPECT_EQ(outside.vertices[v][axis], expected);
    }
  }
  EXPECT_EQ(after.low, (before.low + 0.7 * Vec3{-1, -1, -1}));
  EXPECT_EQ(after.high, (before.high + 0.7 * Vec3{1, 1, 1}));
}

TEST(PmlOffset, keeps_a_sphere_a_sphere_round_its_centre) {
  const Vec3 centre{10, -20, 30};
  const SurfaceMesh outside = moved(shapes::sphere(centre, 2, 3), 0.75);
  for (const Vec3& p : outside.vertices) {
    EXPECT_NEAR(distance(p, centre), 2.75, 2.75e-12);
  }
}

TEST(PmlOffset, moves_the_planes_of_the_faces_by_the_same_where_there_are_no_more_than_three) {
  SurfaceMesh skew = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
  for (Vec3& p : skew.vertices) p.x += 0.4 * p.y + 0.2 * p.z;
  const std::vector<Vec3> directions = pml_directions(skew, first_patch);
  for (const Triangle& t : skew.triangles) {
    const Vec3 a = skew.vertices.at(static_cast<std::size_t>(t[0]));
    const Vec3 normal = normalized(cross(skew.vertices.at(static_cast<std::size_t>(t[1])) - a,
                                         skew.vertices.at(static_cast<std::size_t>(t[2])) - a));
    for (const std::int32_t v : t) {
      EXPECT_NEAR(dot(directions.at(static_cast<std::size_t>(v)), normal), 1, 1e-12);
    }
  }
}

TEST(PmlOffset, leaves_what_is_inside_alone) {
  const SurfaceMesh surface = ball_in_box();
  const SurfaceMesh outside = moved(surface, 0.5);
  EXPECT_EQ(outside.triangles, surface.triangles);
  EXPECT_NEAR(domain_volume(outside) - domain_volume(surface), 125 - 64, 1e-12);
}

TEST(PmlOffset, refuses_patches_that_do_not_close_naming_their_neighbour) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
  box.patch_of_triangle.assign(box.triangles.size(), 0);
  box.patch_of_triangle.back() = 1;
  box.patch_names = {"walls", "lid"};
  EXPECT_THAT(error_text_of<UsageError>([&] { pml_directions(box, first_patch); }),
              AllOf(HasSubstr("do not close"), HasSubstr("\"lid\"")));
}

TEST(PmlOffset, refuses_the_boundary_of_a_hole) {
  constexpr std::array<std::int32_t, 1> body = {1};
  EXPECT_THAT(error_text_of<UsageError>([&] { pml_directions(ball_in_box(), body); }),
              HasSubstr("bounds a hole in the domain"));
}

TEST(PmlOffset, refuses_to_move_a_boundary_into_itself_and_tells_the_triangles) {
  SurfaceMesh two = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
  const SurfaceMesh other = shapes::box({1.5, 0, 0}, {2.5, 1, 1}, 1);
  const auto offset = static_cast<std::int32_t>(two.vertices.size());
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) {
    two.triangles.push_back({a + offset, b + offset, c + offset});
  }
  two.patch_of_triangle.resize(two.triangles.size(), 0);
  EXPECT_NO_THROW(moved(two, 0.2));
  EXPECT_THAT(error_text_of<UsageError>([&] { moved(two, 0.3); }),
              AllOf(HasSubstr("cannot be moved outwards by 0.3"), HasSubstr("triangle")));
}

TEST(PmlOffset, leads_to_whole_layers_of_one_height_that_end_where_the_boundary_was) {
  const SurfaceMesh surface = ball_in_box();
  SurfaceMesh outside;
  const LayerPlan plan = pml_plan(surface, outside, 0.125, 6);
  const test::LayerFigures figures = test::expect_valid_layers(plan, outside);
  EXPECT_EQ(figures.full, 48);
  for (const LayerLine& line : plan.lines) {
    EXPECT_EQ(line.stop, 6);
    EXPECT_EQ(point_of(line, 6), surface.vertices.at(static_cast<std::size_t>(line.foot)));
  }
}

TEST(PmlOffset, gives_three_tets_for_each_prism_in_whatever_chunk) {
  SurfaceMesh outside;
  const LayerPlan plan = pml_plan(ball_in_box(), outside, 0.125, 6);
  for (const std::int64_t most_cells : {100'000, 90}) {
    double volume = 0;
    for (const LayerChunk& chunk : chunks_of(plan, outside, most_cells)) {
      const GrownLayers layers = grow(chunk);
      EXPECT_THAT(validate(layers), testing::IsEmpty());
      EXPECT_EQ(std::ssize(layers.mesh.tets), 18 * std::ssize(chunk.triangles));
      EXPECT_EQ(counts_of(chunk).tets, std::ssize(layers.mesh.tets));
      EXPECT_EQ(counts_of(chunk).prisms, 0);
      for (const auto& [a, b, c, d] : layers.mesh.tets) {
        const auto at = [&](std::int32_t v) {
          return layers.mesh.nodes.at(static_cast<std::size_t>(v));
        };
        volume += tet_volume(at(a), at(b), at(c), at(d));
      }
    }
    EXPECT_NEAR(volume, std::pow(5.5, 3) - 64, 1e-9);
  }
}

TEST(PmlOffset, is_refused_by_the_plan_where_lines_could_not_have_all_layers) {
  const SurfaceMesh surface = shapes::sphere({0, 0, 0}, 1, 2);
  LayerRequest request;
  request.patches = {0};
  request.law = {.first = 0.3, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
  request.count = 4;
  for (const Vec3& p : surface.vertices) request.ways.push_back(-p);
  EXPECT_THAT(error_text_of<UsageError>([&] {
                plan_layers(surface, {&request, 1});
              }),
              AllOf(HasSubstr("would turn over"), HasSubstr("fewer or lower layers")));
}

TEST(PmlOffset, cells_are_marked_by_their_depth_from_the_inside) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  SurfaceMesh outside;
  const LayerPlan plan = pml_plan(ball, outside, 0.25, 3);
  const GrownLayers grown = grow(chunks_of(plan, outside).at(0));
  EXPECT_TRUE(grown.marks[CellMark::layer].empty());
  const std::vector<std::int32_t>& depths = grown.marks[CellMark::pml_depth];
  ASSERT_EQ(depths.size(), grown.mesh.tets.size());
  for (std::size_t t = 0; t < depths.size(); ++t) {
    double furthest = 0;
    for (const std::int32_t v : grown.mesh.tets[t]) {
      furthest = std::max(furthest, norm(grown.mesh.nodes[static_cast<std::size_t>(v)]));
    }
    EXPECT_NEAR(furthest, 1 + 0.25 * depths[t], 1e-12);
  }
}

int bits_of(std::int32_t axes) { return std::popcount(static_cast<std::uint32_t>(axes)); }

TEST(PmlOffset, cells_round_a_box_have_the_axes_along_which_they_are_outside) {
  // A triangle with an edge on one of the box's has two of three lines that lean over it: its
  // cells are beyond where they are more than half an edge away, which the last 2 of 6 are.
  constexpr int squares = 3;
  constexpr int layers = 6;
  constexpr int layers_beyond = 2;
  const SurfaceMesh box = shapes::box({0, 0, 0}, {squares, squares, squares}, squares);
  SurfaceMesh outside;
  const LayerPlan plan = pml_plan(box, outside, 0.125, layers, false);
  const GrownLayers grown = grow(chunks_of(plan, outside).at(0));
  const std::vector<std::int32_t>& axes = grown.marks[CellMark::pml_axes];
  ASSERT_EQ(std::ssize(axes), std::ssize(box.triangles) * layers);
  int bits = 0;
  int most = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool is_beyond = grown.marks[CellMark::pml_depth][i] > layers - layers_beyond;
    bits += bits_of(axes[i]);
    most = std::max(most, bits_of(axes[i]));
    EXPECT_GE(bits_of(axes[i]), 1);
    EXPECT_TRUE(is_beyond || bits_of(axes[i]) == 1) << i;
  }
  EXPECT_EQ(bits, 6 * 2 * squares * squares * layers + 6 * 4 * squares * layers_beyond);
  EXPECT_EQ(most, 3) << "at corners";
}

TEST(PmlOffset, cells_have_axes_by_their_centroids_in_whatever_chunk) {
  const SurfaceMesh ball = shapes::sphere({0.5, -0.25, 3}, 1, 2);
  const Box3 box = bounding_box(ball.vertices);
  SurfaceMesh outside;
  const LayerPlan plan = pml_plan(ball, outside, 0.25, 3);
  std::array<int, 4> cells_with{};
  for (const LayerChunk& chunk : chunks_of(plan, outside, 500)) {
    const GrownLayers grown = grow(chunk);
    const std::vector<std::int32_t>& axes = grown.marks[CellMark::pml_axes];
    ASSERT_EQ(axes.size(), grown.mesh.tets.size());
    for (std::size_t i = 0; i < axes.size(); ++i) {
      Vec3 centroid;
      for (const std::int32_t v : grown.mesh.tets[i]) {
        centroid += grown.mesh.nodes[static_cast<std::size_t>(v)] / 4;
      }
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_outside =
            std::abs(centroid[axis] - box.centre()[axis]) > box.size()[axis] / 2;
        EXPECT_EQ((axes[i] >> axis & 1) != 0, is_outside) << i;
      }
      ++cells_with.at(static_cast<std::size_t>(bits_of(axes[i])));
    }
  }
  EXPECT_GT(cells_with[0], 0) << "the corners of the box are outside of the ball";
  EXPECT_GT(cells_with[1], 0);
  EXPECT_EQ(cells_with[3], 0);
}

}  // namespace
}  // namespace tetfarm
