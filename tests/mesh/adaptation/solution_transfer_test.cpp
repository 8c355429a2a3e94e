#include "mesh/adaptation/solution_transfer.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/adaptation/transfer_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Field = std::vector<double>;

TransferredSolution brought(const PlaneMesh& from, const std::vector<Field>& fields,
                            const PlaneMesh& to, TransferMethod method) {
  return transfer_solution(from, fields, {}, to, method);
}

TEST(SolutionTransfer, tells_figures_before_and_after) {
  const PlaneMesh from = plane_test::shaken_square(10, 1);
  const PlaneMesh to = plane_test::shaken_square(14, 2);
  const auto linear = [](const Vec2& p) { return 1 + 2 * p.x; };
  const std::vector<Field> fields{plane_test::field_of_points(from, linear)};
  for (const TransferMethod method : {TransferMethod::linear, TransferMethod::conservative}) {
    const TransferredSolution result = brought(from, fields, to, method);
    ASSERT_EQ(result.fields.size(), 1U);
    for (const FieldFigures& figures : {result.fields[0].before, result.fields[0].after}) {
      EXPECT_NEAR(figures.min, 1, 1e-12);
      EXPECT_NEAR(figures.max, 3, 1e-12);
      EXPECT_NEAR(figures.integral, 2, 1e-12);
    }
    EXPECT_NEAR(result.fields[0].gain, 0, 1e-13);
    EXPECT_EQ(result.nodes_outside, 0);
    EXPECT_EQ(result.farthest_outside, 0);
  }
}

TEST(SolutionTransfer, measures_the_gain_by_the_absolute_values) {
  // The integral is zero, that of the absolute values a half.
  const PlaneMesh from = plane_test::square(4);
  PlaneMesh to = plane_test::square(4);
  for (Vec2& p : to.points) p.x = p.x * 0.75 + 0.25;
  const auto odd = [](const Vec2& p) { return 2 * p.x - 1; };
  const TransferredSolution result =
      brought(from, {plane_test::field_of_points(from, odd)}, to, TransferMethod::linear);
  EXPECT_NEAR(result.fields[0].before.integral, 0, 1e-15);
  EXPECT_NEAR(result.fields[0].after.integral, 0.1875, 1e-15);
  EXPECT_NEAR(result.fields[0].gain, 0.375, 1e-14);
}

TEST(SolutionTransfer, tells_how_much_of_the_new_mesh_is_outside) {
  const PlaneMesh from = plane_test::square(4);
  PlaneMesh to = plane_test::square(4);
  for (Vec2& p : to.points) p = {p.x * 1.25, p.y};
  const std::vector<Field> fields{plane_test::field_of_points(from, [](const Vec2&) { return 1; })};
  const TransferredSolution result = brought(from, fields, to, TransferMethod::conservative);
  EXPECT_EQ(result.nodes_outside, 5);
  EXPECT_DOUBLE_EQ(result.farthest_outside, 0.25);
  EXPECT_DOUBLE_EQ(result.farthest_at.x, 1.25);
  EXPECT_NEAR(result.covered_percent, 80, 1e-12);
}

TEST(SolutionTransfer, interpolates_metrics_by_their_logarithms) {
  const PlaneMesh from = plane_test::square(4);
  PlaneMesh to;
  to.points = {{0.125, 0}, {1, 0}, {0, 1}};
  to.triangles = {{0, 1, 2}};
  const std::vector<std::vector<Metric2>> metrics{plane_test::metrics_of(from, [](const Vec2& p) {
    return Metric2{std::pow(100, 4 * p.x), 0, 1};
  })};
  const TransferredSolution result =
      transfer_solution(from, {}, metrics, to, TransferMethod::conservative);
  EXPECT_TRUE(result.fields.empty());
  ASSERT_EQ(result.metrics.size(), 1U);
  EXPECT_NEAR(result.metrics[0][0].xx, 10, 1e-12);
  EXPECT_NEAR(result.metrics[0][1].xx, 1e8, 1e-4);
  EXPECT_NEAR(result.metrics[0][2].xx, 1, 1e-12);
}

TEST(SolutionTransfer, refuses_meshes_apart_with_the_boxes_of_both) {
  PlaneMesh from = plane_test::square(30);
  from.name = "old.mesh";
  PlaneMesh to = plane_test::square(30);
  to.name = "new.mesh";
  for (Vec2& p : to.points) p = {p.x + 7, p.y};
  const std::vector<Field> fields{Field(from.points.size(), 1)};
  for (const TransferMethod method : {TransferMethod::linear, TransferMethod::conservative}) {
    const std::string text =
        error_text_of<InvalidInput>([&] { brought(from, fields, to, method); });
    EXPECT_THAT(text, AllOf(HasSubstr("new.mesh: does not overlap"),
                            HasSubstr("x from 7 to 8, y from 0 to 1"),
                            HasSubstr("old.mesh has x from 0 to 1, y from 0 to 1")));
  }
}

TEST(SolutionTransfer, refuses_a_mesh_in_the_hole_of_the_other) {
  const PlaneMesh from = plane_test::square_with_hole(0.5, 20, 5);
  PlaneMesh to = plane_test::disc(10);
  for (Vec2& p : to.points) p = {p.x * 0.4, p.y * 0.4};
  EXPECT_THROW(brought(from, {Field(from.points.size(), 1)}, to, TransferMethod::linear),
               InvalidInput);
}

TEST(SolutionTransfer, takes_a_small_mesh_within_one_triangle_of_the_other_either_way) {
  PlaneMesh small = plane_test::square(3);
  for (Vec2& p : small.points) p = {p.x * 1e-3 + 0.1, p.y * 1e-3 + 0.1};
  PlaneMesh large;
  large.points = {{0, 0}, {1, 0}, {0, 1}};
  large.triangles = {{0, 1, 2}};
  const Field of_large{0, 1, 0};
  const auto down = brought(large, {of_large}, small, TransferMethod::conservative);
  EXPECT_LT(
      plane_test::greatest_error(small, down.fields[0].values, [](const Vec2& p) { return p.x; }),
      1e-14);
  const auto up =
      brought(small, {Field(small.points.size(), 3)}, large, TransferMethod::conservative);
  for (const double value : up.fields[0].values) EXPECT_EQ(value, 3);
  EXPECT_EQ(up.nodes_outside, 3);
}

TEST(SolutionTransfer, gives_the_same_bits_each_time) {
  const PlaneMesh from = plane_test::disc(9);
  const PlaneMesh to = plane_test::disc(14);
  const std::vector<Field> fields{plane_test::random_field(from, 1)};
  const auto once = brought(from, fields, to, TransferMethod::conservative);
  const auto again = brought(from, fields, to, TransferMethod::conservative);
  EXPECT_EQ(once.fields[0].values, again.fields[0].values);
}

}  // namespace
}  // namespace tetfarm
