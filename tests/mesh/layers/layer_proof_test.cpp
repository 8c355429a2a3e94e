#include "mesh/layers/layer_proof.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// All lines of a surface with layers of the same height, whatever comes of it.
LayerPlan plan_with(const SurfaceMesh& surface, double height, int layers) {
  const LayerRequest request = test::request_of_all(surface, 1e-6, 1);
  LayerPlan plan = plan_layers(surface, std::span(&request, 1));
  for (LayerLine& line : plan.lines) {
    line.law = {.first = height, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
    line.stop = line.wanted = layers;
    line.later = line.along;
  }
  return plan;
}

WallPlanes planes_of(const LayerPlan& plan, const SurfaceMesh& surface) {
  return wall_planes(surface, wall_graph(surface, plan.wall));
}

TEST(LayerProof, holds_of_layers_that_tile) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const LayerPlan plan = plan_with(sphere, 0.1, 5);
  EXPECT_TRUE(prove_cells(plan, sphere).holds);
  EXPECT_TRUE(prove_top(plan, sphere, planes_of(plan, sphere)).holds);
}

TEST(LayerProof, lines_stop_below_the_first_cell_that_is_not_positive) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const ProofFindings found = prove_cells(plan_with(sphere, 0.1, 13), sphere);
  EXPECT_FALSE(found.holds);
  // Nine layers end before the centre; the tenth ends at it, or a little beyond.
  for (const int stop : found.stops) EXPECT_TRUE(stop == 9 || stop == 10) << stop;
}

TEST(LayerProof, lines_whose_top_meets_another_lose_a_third) {
  // Layers of both meet in the middle between the spheres.
  const SurfaceMesh spheres = shapes::nested_spheres(2);
  const LayerPlan plan = plan_with(spheres, 0.05, 6);
  ASSERT_TRUE(prove_cells(plan, spheres).holds);
  const LayerPlan lower = plan_with(spheres, 0.05, 4);
  EXPECT_TRUE(prove_top(lower, spheres, planes_of(lower, spheres)).holds);
  const ProofFindings found = prove_top(plan, spheres, planes_of(plan, spheres));
  EXPECT_FALSE(found.holds);
  EXPECT_EQ(*std::min_element(found.stops.begin(), found.stops.end()), 4);
}

TEST(LayerProof, a_top_that_went_through_itself_is_found_by_how_it_is_turned) {
  // Mirrored at the centre: embedded, but inside out; that its cells are negative is not asked.
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 1);
  LayerPlan plan = plan_with(sphere, 0.5, 3);
  for (LayerLine& line : plan.lines) line.along = line.later = -line.at;
  EXPECT_FALSE(prove_top(plan, sphere, planes_of(plan, sphere)).holds);
}

}  // namespace
}  // namespace tetfarm
