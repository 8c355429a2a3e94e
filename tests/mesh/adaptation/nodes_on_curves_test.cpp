#include "mesh/adaptation/nodes_on_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/adaptation/adapt_mesh.h"
#include "mesh/adaptation/circle_curve.h"
#include "mesh/adaptation/loop_domain.h"
#include "mesh/adaptation/naca_profile.h"
#include "mesh/adaptation/point_spline.h"
#include "tests/mesh/adaptation/plane_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

PatchCurve unit_circle() {
  return {{5}, "--curve 5=circle", {std::make_shared<const CircleCurve>(Circle{{0, 0}, 1})}};
}

NodesOnCurves placed(const PlaneMesh& mesh, const std::vector<PatchCurve>& curves) {
  return put_on_curves(mesh, checked_complex(mesh), curves, 30);
}

std::string refusal(const PlaneMesh& mesh, const std::vector<PatchCurve>& curves) {
  return error_text_of<InvalidInput>([&] { placed(mesh, curves); });
}

double off_circle(const PlaneMesh& mesh) {
  double off = 0;
  for (const auto& [a, b] : mesh.edges) {
    for (const std::int32_t v : {a, b}) {
      off = std::max(off, std::abs(std::hypot(mesh.points[at(v)].x, mesh.points[at(v)].y) - 1));
    }
  }
  return off;
}

double off_naca(const PlaneMesh& mesh, const NacaProfile& profile) {
  double off = 0;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    if (mesh.patches[k] != 1) continue;
    for (const std::int32_t v : mesh.edges[k]) {
      const Vec2& p = mesh.points[at(v)];
      const Vec2 foot = profile.at(profile.nearest(p));
      off = std::max(off, std::hypot(p.x - foot.x, p.y - foot.y));
    }
  }
  return off;
}

/// NACA 0012 as patch 1 in a square as patch 2.
PlaneMesh naca_in_a_square(const NacaProfile& profile, int n) {
  DomainLoop airfoil{{}, 1, "airfoil"};
  for (int i = 0; i < n; ++i) airfoil.points.push_back(profile.at(profile.length() * i / n));
  const DomainLoop square{{{-2, -2}, {3, -2}, {3, 2}, {-2, 2}}, 2, "square"};
  return sized_by_boundary(domain_of_loops({airfoil, square})).mesh;
}

TEST(NodesOnCurves, move_the_little_way_to_the_circle) {
  PlaneMesh disc = plane_test::disc(6);
  std::int32_t moved = disc.edges[3][0];
  disc.points[at(moved)].x *= 1 + 5e-5;
  disc.points[at(moved)].y *= 1 + 5e-5;
  const NodesOnCurves result = placed(disc, {unit_circle()});
  EXPECT_LE(off_circle(result.mesh), 1e-14);
  ASSERT_EQ(result.moved.size(), 1U);
  EXPECT_EQ(result.moved[0].nodes, 36);
  EXPECT_EQ(result.moved[0].moved, 1);
  EXPECT_EQ(result.moved[0].node, moved);
  EXPECT_NEAR(result.moved[0].farthest, 5e-5, 1e-12);
}

TEST(NodesOnCurves, that_lie_there_already_stay_bit_by_bit) {
  const PlaneMesh disc = plane_test::disc(6);
  const NodesOnCurves result = placed(disc, {unit_circle()});
  EXPECT_EQ(result.mesh.points, disc.points);
  EXPECT_EQ(result.moved[0].node, -1);
}

TEST(NodesOnCurves, that_lie_too_far_off_are_refused_with_place_and_distance) {
  PlaneMesh disc = plane_test::disc(6);
  const std::int32_t node = disc.edges[3][0];
  disc.points[at(node)] = {1.01 * disc.points[at(node)].x, 1.01 * disc.points[at(node)].y};
  const std::string text = refusal(disc, {unit_circle()});
  EXPECT_THAT(text, HasSubstr("--curve 5=circle: node " + std::to_string(node + 1) + " at (" +
                              place_text(disc.points[at(node)]).substr(1)));
  EXPECT_THAT(text, HasSubstr("lies 0.01 away from the curve"));
}

TEST(NodesOnCurves, of_a_patch_that_is_not_there_are_refused_with_those_that_are) {
  const PlaneMesh square = plane_test::square(3);
  EXPECT_EQ(error_text_of<InvalidInput>([&] {
              nodes_of_patches(square, checked_complex(square), {2, 9}, "--curve 2,9=line");
            }),
            "--curve 2,9=line: there is no patch 9; the mesh has 1, 2, 3, 4");
  EXPECT_EQ(nodes_of_patches(square, checked_complex(square), {2}, "").size(), 4U);
}

TEST(NodesOnCurves, at_a_trailing_edge_are_corners_whatever_the_angle) {
  const NacaProfile profile({});
  PlaneMesh mesh = naca_in_a_square(profile, 60);
  mesh.corners.clear();
  const PatchCurve naca{{1}, "naca", naca_parts({})};
  const NodesOnCurves result = put_on_curves(mesh, checked_complex(mesh), {{naca}}, 175);
  ASSERT_EQ(result.mesh.corners.size(), 1U);
  EXPECT_EQ(result.mesh.points[at(result.mesh.corners[0])], (Vec2{1, 0}));
}

TEST(NodesOnCurves, are_missed_at_a_corner_of_the_curve) {
  // The square has a node in the middle of each side of the curve, and none at its corners.
  PlaneMesh diamond = plane_test::disc(1);
  const auto sides = splines_of_loop({{2, 0}, {-1, std::sqrt(3)}, {-1, -std::sqrt(3)}}, 30);
  EXPECT_THAT(refusal(diamond, {{{5}, "loop", sides}}), HasSubstr("loop: node "));
}

TEST(NodesOnCurves, between_two_curves_that_do_not_meet_are_refused) {
  const PlaneMesh square = plane_test::square(4);
  const auto circle_of = [](double radius, const Vec2& centre) {
    return std::vector<std::shared_ptr<const TrueCurve>>{
        std::make_shared<const CircleCurve>(Circle{centre, radius})};
  };
  const double r = 2000;
  // Both nearly flat, and one of them a little beside the corner at (1, 0).
  EXPECT_EQ(refusal(square, {{{1}, "a", circle_of(r, {0.5, -std::sqrt(r * r - 0.25)})}}), "");
  EXPECT_THAT(refusal(square, {{{1}, "a", circle_of(r, {0.5, -std::sqrt(r * r - 0.25)})},
                               {{2}, "b", circle_of(r, {1 + r + 1e-3, 0.5})}}),
              HasSubstr("away from the curve"));
}

TEST(NodesOnCurves, refuse_a_line_that_comes_back) {
  EXPECT_THAT(refusal(plane_test::disc(3), {{{5}, "--curve 5=line", {}}}),
              HasSubstr("with no corner between: that is no line"));
}

TEST(NodesOnCurves, are_put_back_on_a_line) {
  PlaneMesh square = plane_test::square(4);
  for (std::int32_t v = 0; v < 25; ++v) {
    if (square.points[at(v)] == Vec2{0.5, 0}) square.points[at(v)].y = 1e-4;
  }
  const NodesOnCurves result = placed(square, {{{1}, "line", {}}});
  EXPECT_EQ(result.moved[0].moved, 1);
  for (std::size_t k = 0; k < square.edges.size(); ++k) {
    if (square.patches[k] != 1) continue;
    for (const std::int32_t v : square.edges[k]) EXPECT_EQ(result.mesh.points[at(v)].y, 0);
  }
}

TEST(NodesOnCurves, never_turn_a_triangle_over) {
  PlaneMesh mesh;
  // A triangle that is thinner than its node on the line would move.
  mesh.points = {{0, 0}, {1, -5e-4}, {2, 0}, {1, -2e-4}, {1, 1}};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {3, 2, 4}};
  mesh.regions = {0, 0, 0, 0};
  plane_test::add_border(mesh, [](const Vec2& p) { return p.y < 0.1 ? 1 : 2; });
  EXPECT_THAT(refusal(mesh, {{{1}, "line", {}}}), HasSubstr("would turn over"));
}

TEST(NodesOnCurves, stay_on_a_profile_over_many_adaptations) {
  const NacaProfile profile({});
  const PatchCurve naca{{1}, "naca", naca_parts({})};
  PlaneMesh mesh = naca_in_a_square(profile, 60);
  AdaptationOptions options;
  options.curves = {naca};
  options.sweeps = 2;
  for (int cycle = 0; cycle < 6; ++cycle) {
    mesh = placed(mesh, options.curves).mesh;
    const auto metrics = plane_test::metrics_of(mesh, [&](const Vec2& p) {
      const double off = std::hypot(p.x - 0.2 * cycle, p.y);
      return plane_test::round_metric(0.03 + 0.3 * off);
    });
    mesh = adapt_mesh(mesh, metrics, options).mesh;
    ASSERT_THAT(plane_test::whats_wrong(mesh), IsEmpty());
    ASSERT_LE(off_naca(mesh, profile), 1e-15) << cycle;
  }
}

}  // namespace
}  // namespace tetfarm
