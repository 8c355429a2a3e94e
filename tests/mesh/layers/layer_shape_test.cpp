#include "mesh/layers/layer_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_sphere.h"

namespace tetfarm {
namespace {

double least_share(const GrownLayers& layers) {
  const std::vector<double> shares = jacobian_shares(layers);
  return *std::min_element(shares.begin(), shares.end());
}

/// One prism on a triangle with an angle of 45 degrees, whose top is moved along x.
GrownLayers one_prism(double moved) {
  GrownLayers layers;
  layers.mesh.nodes = {{0, 0, 0},     {1, 0, 0},         {0, 1, 0},
                       {moved, 0, 1}, {1 + moved, 0, 1}, {moved, 1, 1}};
  layers.blocks[ElementType::prism].nodes = {0, 1, 2, 3, 4, 5};
  layers.blocks[ElementType::prism].regions = {1};
  return layers;
}

TEST(LayerShape, a_straight_prism_has_all_that_its_triangle_lets_it_have) {
  EXPECT_NEAR(least_share(one_prism(0)), 1, 1e-15);
  EXPECT_TRUE(jacobian_shares(GrownLayers{}).empty());
}

TEST(LayerShape, a_leaning_prism_has_less_by_the_cosine_of_its_lean) {
  EXPECT_NEAR(least_share(one_prism(1)), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(least_share(one_prism(std::sqrt(3))), 0.5, 1e-15);
}

/// The second prism's own triangle is no measure: it is wider than that at the foot.
TEST(LayerShape, of_a_column_is_measured_by_the_triangle_at_its_foot) {
  GrownLayers layers = one_prism(0);
  layers.mesh.nodes.insert(layers.mesh.nodes.end(), {{1, 0, 2}, {2, 0, 2}, {1, 1, 2}});
  ElementBlock& prisms = layers.blocks[ElementType::prism];
  prisms.nodes.insert(prisms.nodes.end(), {3, 4, 5, 6, 7, 8});
  prisms.regions.push_back(1);
  EXPECT_NEAR(least_share(layers), std::sqrt(0.5), 1e-15);
  layers.mesh.nodes[4] = {3, 0, 1};  // its triangle is slender now, the wall's is not
  layers.mesh.nodes[7] = {4, 0, 2};
  EXPECT_LT(least_share(layers), 0.45);
}

TEST(LayerShape, has_no_part_in_what_absorbs) {
  GrownLayers layers = one_prism(1);
  layers.marks[CellMark::pml_depth] = {3};
  EXPECT_TRUE(jacobian_shares(layers).empty());
  layers.marks[CellMark::pml_depth] = {0};
  EXPECT_EQ(jacobian_shares(layers).size(), 1U);
}

/// At the edges of a cube one line at a foot leans by 45 degrees.
TEST(LayerShape, is_better_where_lines_fan) {
  const auto least_of = [](const LayerRequest& request) {
    const test::LayeredBody body(test::cube_in_box(3), request);
    return least_share(grow(chunks_of(body.plan, body.surface).at(0)));
  };
  EXPECT_LT(least_of(test::request_of({test::body_patch}, 0.02, 5)), 0.6);
  EXPECT_GT(least_of(test::fanned(0.02, 5, 60)), 0.8);
}

TEST(LayerShape, of_a_sphere_is_nearly_that_of_straight_prisms) {
  const test::LayeredSphere sphere;
  const GrownLayers layers = grow(chunks_of(sphere.plan, sphere.surface).at(0));
  EXPECT_GT(least_share(layers), 0.95);
}

}  // namespace
}  // namespace tetfarm
