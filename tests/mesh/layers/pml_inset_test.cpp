#include "mesh/layers/pml_inset.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "mesh/layers/layer_plan.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

constexpr std::array<std::int32_t, 1> first_patch = {0};

/// Edges of 1/4, far shorter than the layers of these tests are thick.
SurfaceMesh fine_box() { return shapes::box({-1, -1, -1}, {1, 1, 2}, 8); }

SurfaceMesh skewed(SurfaceMesh surface) {
  for (Vec3& p : surface.vertices) p = {p.x + 0.5 * p.y, p.y - 0.25 * p.z, p.z + 0.125 * p.x};
  return surface;
}

Vec3 normal_of(const SurfaceMesh& surface, const Triangle& t) {
  const auto corner = [&](std::size_t i) {
    return surface.vertices[static_cast<std::size_t>(t.at(i))];
  };
  return normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
}

LayerPlan inner_plan(const SurfaceMesh& surface, double height, int layers) {
  LayerRequest request;
  request.patches = {0};
  request.law = {.first = height, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
  request.count = layers;
  request.ways = pml_ways_inwards(surface, first_patch, height * layers);
  return plan_layers(surface, {&request, 1});
}

void expect_each_plane_moves_inwards_by_1(const SurfaceMesh& surface) {
  const std::vector<Vec3> ways = pml_ways_inwards(surface, first_patch, 0.1);
  for (const Triangle& t : surface.triangles) {
    for (const std::int32_t v : t) {
      ASSERT_NEAR(dot(ways[static_cast<std::size_t>(v)], normal_of(surface, t)), -1, 1e-12);
    }
  }
}

TEST(PmlInset, moves_every_vertex_of_each_side_of_a_box_inwards_by_the_same_height) {
  expect_each_plane_moves_inwards_by_1(fine_box());
}

TEST(PmlInset, moves_those_of_a_skew_box_likewise) {
  expect_each_plane_moves_inwards_by_1(skewed(fine_box()));
}

TEST(PmlInset, has_room_in_a_box_for_layers_far_thicker_than_edges_are_long) {
  for (const SurfaceMesh& surface : {fine_box(), skewed(fine_box())}) {
    const LayerPlan plan = inner_plan(surface, 0.16, 5);
    for (const LayerLine& line : plan.lines) EXPECT_EQ(line.stop, 5);
  }
}

TEST(PmlInset, leaves_a_smaller_box_within_a_box) {
  Box3 inner;
  for (const LayerLine& line : inner_plan(fine_box(), 0.125, 4).lines) {
    inner.add(point_of(line, line.stop));
  }
  EXPECT_EQ(inner.low, (Vec3{-0.5, -0.5, -0.5}));
  EXPECT_EQ(inner.high, (Vec3{0.5, 0.5, 1.5}));
}

TEST(PmlInset, moves_the_vertices_of_a_sphere_towards_its_centre) {
  const Vec3 centre = {3, -1, 2};
  const SurfaceMesh ball = shapes::sphere(centre, 2, 2);
  const std::vector<Vec3> ways = pml_ways_inwards(ball, first_patch, 0.1);
  for (std::size_t v = 0; v < ways.size(); ++v) {
    EXPECT_LT(distance(ways[v], normalized(centre - ball.vertices[v])), 1e-12);
  }
}

TEST(PmlInset, of_layers_that_are_thicker_than_half_the_box_is_refused_with_both_lengths) {
  EXPECT_THAT(error_text_of<UsageError>([] { inner_plan(fine_box(), 0.25, 4); }),
              HasSubstr("1 thick together, and the outer boundary is only 2 wide along x"));
}

TEST(PmlInset, takes_a_box_with_a_bevelled_edge_for_no_box) {
  SurfaceMesh bevelled = fine_box();
  for (Vec3& p : bevelled.vertices) {
    if (p.x == 1 && p.y == 1) p = {0.9, 0.9, p.z};
  }
  const auto found =
      std::find(bevelled.vertices.begin(), bevelled.vertices.end(), Vec3{0.5, -1, 0.125});
  ASSERT_NE(found, bevelled.vertices.end());
  const auto on_a_side = static_cast<std::size_t>(found - bevelled.vertices.begin());
  EXPECT_EQ(pml_ways_inwards(bevelled, first_patch, 0.1)[on_a_side], (Vec3{0, 1, 0}));
}

}  // namespace
}  // namespace tetfarm
