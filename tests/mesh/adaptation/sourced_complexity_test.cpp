#include "mesh/adaptation/sourced_complexity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

/// A source of a circle of the given radius, beyond which it ends.
MetricSource circle(const Vec2& centre, double radius, double size) {
  MetricSource source;
  source.from = source.to = centre;
  source.along = source.across = size;
  source.radius = radius;
  source.growth = 0;
  return source;
}

SourcedComplexity of_square(int n, double size, const std::vector<MetricSource>& sources) {
  const PlaneMesh mesh = plane_test::square(n);
  const auto metrics = plane_test::constant_metrics(mesh, plane_test::round_metric(size));
  return sourced_complexity(checked_complex(mesh), metrics, MetricSources(sources));
}

TEST(SourcedComplexity, of_a_small_circle_in_two_triangles_is_its_area_over_its_size) {
  for (const double radius : {0.2, 0.01, 0.0005}) {
    const double size = radius / 10;
    const double found = of_square(1, 1, {circle({0.31, 0.27}, radius, size)}).complexity;
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(found, area / (size * size) + 1 - area, 0.2 * found) << radius;
  }
}

TEST(SourcedComplexity, is_nearly_the_same_on_any_mesh) {
  MetricSource line = circle({0.2, 0.3}, 0.02, 0.01);
  line.to = {0.9, 0.8};
  line.along = 0.1;
  line.growth = 1.4;
  const double on_two = of_square(1, 0.2, {line}).complexity;
  EXPECT_NEAR(of_square(3, 0.2, {line}).complexity / on_two, 1, 0.05);
  EXPECT_NEAR(of_square(40, 0.2, {line}).complexity / on_two, 1, 0.05);
}

TEST(SourcedComplexity, without_effect_is_that_of_the_background) {
  const SourcedComplexity found = of_square(
      2, 0.1,
      {circle({0.5, 0.5}, 0.3, 0.2), circle({7, 0.5}, 0.3, 0.01), circle({0.5, 0.5}, 0.3, 0.05)});
  EXPECT_EQ(found.acts, (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_NEAR(of_square(2, 0.1, {circle({7, 7}, 1, 0.01)}).complexity, 100, 1e-9);
}

TEST(SourcedComplexity, of_a_source_that_is_too_thin_for_any_piece_ends_and_lets_it_act) {
  MetricSource line = circle({0, 0.123}, 1e-20, 1e-20);
  line.to = {1, 0.987};
  const SourcedComplexity found = of_square(1, 0.5, {line});
  EXPECT_EQ(found.acts, (std::vector<std::uint8_t>{1}));
}

}  // namespace
}  // namespace tetfarm
