#include "mesh/layers/column_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mesh/layers/layer_shape.h"
#include "tests/mesh/layers/layered_bodies.h"

namespace tetfarm {
namespace {

/// Layers in a cube, in whose edges and corners columns narrow on the way up.
test::LayeredBody layers_in_cube(int edges, double first) {
  SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, edges);
  cube.patch_of_triangle.assign(cube.triangles.size(), test::body_patch);
  cube.patch_names = {"body"};
  LayerRequest request = test::request_of({test::body_patch}, first, 15);
  request.law.growth = 1.2;
  return {std::move(cube), request};
}

TEST(ColumnShape, layers_below_the_first_prism_that_lost_its_shape_are_told) {
  const test::LayeredBody body = layers_in_cube(10, 2e-3);
  const std::vector<int> shaped = well_shaped_layers(body.plan, body.surface, 0.4);
  ASSERT_EQ(shaped.size(), body.plan.lines.size());
  int short_of = 0;
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    EXPECT_GE(shaped[i], 1);
    EXPECT_LE(shaped[i], body.plan.lines[i].stop);
    if (shaped[i] < body.plan.lines[i].stop) ++short_of;
  }
  EXPECT_GT(short_of, 0);
  EXPECT_LT(short_of, std::ssize(shaped)) << "columns amid the faces are straight";
}

TEST(ColumnShape, all_layers_keep_a_share_of_nothing) {
  const test::LayeredBody body = layers_in_cube(10, 2e-3);
  const std::vector<int> shaped = well_shaped_layers(body.plan, body.surface, 0);
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    EXPECT_EQ(shaped[i], body.plan.lines[i].stop);
  }
}

TEST(ColumnShape, lines_grow_less_where_prisms_would_lose_their_shape_and_lose_no_layer) {
  const test::LayeredBody body = layers_in_cube(20, 1e-3);
  for (const LayerLine& line : body.plan.lines) EXPECT_EQ(line.stop, 15);
  const std::vector<double> shares =
      jacobian_shares(grow(chunks_of(body.plan, body.surface).at(0)));
  EXPECT_EQ(shares.size(), 15 * body.surface.triangles.size());
  EXPECT_GE(*std::min_element(shares.begin(), shares.end()), 0.3);
}

}  // namespace
}  // namespace tetfarm
