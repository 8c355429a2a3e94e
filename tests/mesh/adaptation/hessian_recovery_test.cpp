#include "mesh/adaptation/hessian_recovery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mesh/adaptation/checked_plane_mesh.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

/// A grid whose inner nodes are moved about, stretched in y.
TriangleComplex stretched_grid(double stretch) {
  PlaneMesh mesh = plane_test::square(8);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.03, 0.03);
  for (Vec2& p : mesh.points) {
    const bool is_inside = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    if (is_inside) p = {p.x + shift(random), p.y + shift(random)};
    p.y *= stretch;
  }
  return checked_complex(mesh);
}

template <class Field>
std::vector<double> values_of(const TriangleComplex& complex, const Field& field) {
  std::vector<double> values;
  for (const Vec2& p : complex.points) values.push_back(field(p));
  return values;
}

TEST(HessianRecovery, fits_are_exact_for_quadratics_at_the_boundary_too) {
  for (const double stretch : {1.0, 1e-3}) {
    const TriangleComplex complex = stretched_grid(stretch);
    const double yy = 1 / (stretch * stretch);
    const std::vector<double> values = values_of(complex, [&](const Vec2& p) {
      return 3 + p.x - 2 * p.y + 1.5 * p.x * p.x - p.x * p.y / stretch + 2 * yy * p.y * p.y;
    });
    for (const Metric2& h : recover_hessians(complex, values, HessianRecovery::quadratic_fit)) {
      EXPECT_NEAR(h.xx, 3, 1e-9);
      EXPECT_NEAR(h.xy * stretch, -1, 1e-9);
      EXPECT_NEAR(h.yy / yy, 4, 1e-9);
    }
  }
}

TEST(HessianRecovery, double_projection_is_right_inside_an_even_grid_alone) {
  const TriangleComplex complex = checked_complex(plane_test::square(8));
  const std::vector<double> values =
      values_of(complex, [](const Vec2& p) { return p.x * p.x + p.x * p.y; });
  const std::vector<Metric2> hessians =
      recover_hessians(complex, values, HessianRecovery::double_projection);
  bool is_wrong_at_the_boundary = false;
  for (std::size_t v = 0; v < complex.points.size(); ++v) {
    const Vec2& p = complex.points[v];
    const bool is_deep = p.x > 0.2 && p.x < 0.8 && p.y > 0.2 && p.y < 0.8;
    if (is_deep) {
      EXPECT_NEAR(hessians[v].xx, 2, 1e-9);
      EXPECT_NEAR(hessians[v].xy, 1, 1e-9);
      EXPECT_NEAR(hessians[v].yy, 0, 1e-9);
    } else {
      is_wrong_at_the_boundary |= std::abs(hessians[v].xx - 2) > 0.1;
    }
  }
  EXPECT_TRUE(is_wrong_at_the_boundary);
}

TEST(HessianRecovery, of_two_triangles_has_too_few_nodes_to_fit) {
  const TriangleComplex complex = checked_complex(plane_test::square(1));
  const std::vector<double> values{0, 1, 2, 5};
  for (const Metric2& h : recover_hessians(complex, values, HessianRecovery::quadratic_fit)) {
    EXPECT_EQ(h, (Metric2{0, 0, 0}));
  }
}

}  // namespace
}  // namespace tetfarm
