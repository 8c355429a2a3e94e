#include "mesh/adaptation/solution_interpolation.h"

#include <gtest/gtest.h>

#include "tests/mesh/adaptation/transfer_shapes.h"

namespace tetfarm {
namespace {

std::vector<double> brought(const PlaneMesh& from, const std::vector<double>& values,
                            const PlaneMesh& to) {
  const TriangleComplex complex = checked_complex(from);
  return interpolated(complex, values, locate_nodes(MeshLocation(complex), checked_complex(to)));
}

TEST(SolutionInterpolation, is_exact_for_linear_fields) {
  const PlaneMesh from = plane_test::shaken_square(11, 1);
  const PlaneMesh to = plane_test::thin_square(17, 2, 0.4, 1e-3);
  const auto linear = [](const Vec2& p) { return 1e3 + 5 * p.x - 7 * p.y; };
  const auto values = brought(from, plane_test::field_of_points(from, linear), to);
  EXPECT_LT(plane_test::greatest_error(to, values, linear), 1e-12);
}

TEST(SolutionInterpolation, stays_within_the_values_there_were) {
  const PlaneMesh from = plane_test::disc(7);
  const PlaneMesh to = plane_test::disc(12);
  const std::vector<double> before = plane_test::random_field(from, 1);
  const std::vector<double> after = brought(from, before, to);
  EXPECT_GE(plane_test::least(after), plane_test::least(before));
  EXPECT_LE(plane_test::greatest(after), plane_test::greatest(before));
}

TEST(SolutionInterpolation, gives_constants_back_bit_by_bit) {
  const PlaneMesh from = plane_test::disc(7);
  const PlaneMesh to = plane_test::disc(12);
  for (const double value : brought(from, std::vector<double>(from.points.size(), 0.1), to)) {
    EXPECT_EQ(value, 0.1);
  }
}

TEST(SolutionInterpolation, is_of_second_order) {
  const auto smooth = [](const Vec2& p) { return std::sin(3 * p.x) * std::cos(2 * p.y); };
  std::array<double, 2> errors{};
  for (std::size_t k = 0; k < 2; ++k) {
    const int n = k == 0 ? 20 : 40;
    const PlaneMesh from = plane_test::shaken_square(n, 1);
    const PlaneMesh to = plane_test::shaken_square(n + 3, 2);
    const auto values = brought(from, plane_test::field_of_points(from, smooth), to);
    errors[k] = plane_test::greatest_error(to, values, smooth);
  }
  EXPECT_LT(errors[1], errors[0] / 3);
}

}  // namespace
}  // namespace tetfarm
