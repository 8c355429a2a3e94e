#include "mesh/adaptation/metric_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

MetricMesh unit_square_mesh(int n) {
  const PlaneMesh plane = plane_test::square(n);
  return plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
}

TEST(MetricMesh, edge_key_does_not_mind_the_direction) {
  EXPECT_EQ(edge_key(3, 70000), edge_key(70000, 3));
  EXPECT_NE(edge_key(3, 4), edge_key(4, 5));
  EXPECT_NE(edge_key(0, 1), edge_key(1, 1));
}

TEST(MetricMesh, measures_an_edge_by_the_metrics_of_its_two_ends) {
  const PlaneMesh plane = plane_test::square(1);
  auto metrics = plane_test::constant_metrics(plane, {1, 0, 1});
  metrics[1] = plane_test::round_metric(1 / std::exp(1));
  const MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  // From 1 to e: e - 1.
  EXPECT_NEAR(edge_length(mesh, 0, 1), std::exp(1) - 1, 1e-14);
  EXPECT_EQ(edge_length(mesh, 1, 0), edge_length(mesh, 0, 1));
  EXPECT_EQ(edge_length(mesh, place_of(mesh, 0), 1), edge_length(mesh, 0, 1));
  EXPECT_NEAR(edge_length(mesh, 0, 3), 1, 1e-15);
}

TEST(MetricMesh, ball_of_a_node_inside_is_all_its_triangles_anticlockwise) {
  const MetricMesh mesh = unit_square_mesh(4);
  Ball ball;
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    collect_ball(mesh.complex, v, ball);
    EXPECT_EQ(ball.is_closed, mesh.is_inside(v));
    std::set<std::int32_t> found;
    for (std::size_t k = 0; k < ball.corners.size(); ++k) {
      const std::int32_t t = triangle_of(ball.corners[k]);
      EXPECT_EQ(mesh.complex.node(t, edge_of(ball.corners[k])), v);
      EXPECT_TRUE(found.insert(t).second);
      if (k == 0) continue;
      const EdgeHandle before = ball.corners[k - 1];
      EXPECT_EQ(mesh.complex.node(triangle_of(before), previous(edge_of(before))),
                mesh.complex.node(t, next(edge_of(ball.corners[k]))));
    }
    std::set<std::int32_t> expected;
    for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
      for (const std::int32_t w : mesh.complex.nodes(t)) {
        if (w == v) expected.insert(t);
      }
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(MetricMesh, gives_dropped_triangles_again) {
  MetricMesh mesh = unit_square_mesh(2);
  drop_triangle(mesh, 3);
  EXPECT_FALSE(mesh.is_used(3));
  EXPECT_EQ(take_triangle(mesh), 3);
  EXPECT_EQ(take_triangle(mesh), 8);
  EXPECT_EQ(mesh.regions.size(), 9U);
}

TEST(MetricMesh, parameter_of_a_corner_is_that_of_the_end_where_it_is) {
  const MetricMesh mesh = unit_square_mesh(4);
  ASSERT_EQ(mesh.curves.size(), 4U);
  for (std::int32_t c = 0; c < 4; ++c) {
    const BoundaryCurve& shape = mesh.curves[at(c)].shape;
    int ends = 0;
    for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
      if (mesh.curve_of_node[at(v)] != MetricMesh::corner) continue;
      for (const double end : {0.0, shape.length()}) {
        if (shape.at(end) != mesh.complex.point(v)) continue;
        EXPECT_EQ(parameter_on(mesh, c, v, 0.5), end);
        ++ends;
      }
    }
    EXPECT_EQ(ends, 2);
  }
}

TEST(MetricMesh, parameter_of_the_only_corner_is_that_of_the_nearer_end) {
  PlaneMesh plane = plane_test::disc(4);
  plane.corners = {plane.edges[0][0]};
  const MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  ASSERT_EQ(mesh.curves.size(), 1U);
  const double length = mesh.curves[0].shape.length();
  EXPECT_NEAR(length, 6.26, 0.01);
  EXPECT_EQ(parameter_on(mesh, 0, plane.corners[0], 0.1), 0);
  EXPECT_EQ(parameter_on(mesh, 0, plane.corners[0], length - 0.1), length);
  EXPECT_LE(plane_test::distance_from_curves(mesh), 1e-15);
}

TEST(MetricMesh, moved_node_has_the_metric_of_its_new_place) {
  MetricMesh mesh = unit_square_mesh(2);
  move_node(mesh, 2, {{0.6, 0.4}, {9, 0, 4}, 5});
  EXPECT_EQ(mesh.complex.point(2), (Vec2{0.6, 0.4}));
  EXPECT_EQ(mesh.metrics[2], (Metric2{9, 0, 4}));
  EXPECT_EQ(place_of(mesh, 2).home, 5);
  EXPECT_EQ(add_node(mesh, {{0.1, 0.1}, {16, 0, 1}, 2}), 9);
  EXPECT_EQ(mesh.metrics.back(), (Metric2{16, 0, 1}));
  EXPECT_TRUE(mesh.is_inside(9));
  EXPECT_EQ(mesh.active.back(), 1);
}

TEST(MetricMesh, longer_and_shorter_agree_with_the_length_itself) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-2, 2);
  int longer = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = std::exp(exponent(random));
    const double b = i % 3 == 0 ? a * (1 + 1e-9 * exponent(random)) : std::exp(exponent(random));
    const double length = length_between(std::sqrt(a), std::sqrt(b));
    for (const double limit : {0.7, 1.0, 1.4, length * (1 + 1e-9), length * (1 - 1e-9)}) {
      ASSERT_EQ(is_longer(a, b, limit), length > limit) << a << " " << b << " " << limit;
      ASSERT_EQ(is_shorter(a, b, limit), length < limit) << a << " " << b << " " << limit;
      longer += length > limit ? 1 : 0;
    }
  }
  EXPECT_GT(longer, 20000);
}

TEST(MetricMesh, a_round_visits_what_the_one_before_touched) {
  MetricMesh mesh = unit_square_mesh(2);
  EXPECT_FALSE(is_to_visit(mesh, EdgesToVisit::touched, 0, 1));
  EXPECT_TRUE(is_to_visit(mesh, EdgesToVisit::all, 0, 1));
  mesh.touched[0] = TouchedBits::now;
  EXPECT_TRUE(is_to_visit(mesh, EdgesToVisit::touched, 0, 1));
  begin_round(mesh);
  EXPECT_TRUE(is_to_visit(mesh, EdgesToVisit::touched, 1, 0));
  begin_round(mesh);
  EXPECT_FALSE(is_to_visit(mesh, EdgesToVisit::touched, 0, 1));
  mesh.active[1] = 1;
  EXPECT_TRUE(is_to_visit(mesh, EdgesToVisit::active, 0, 1));
}

TEST(MetricMesh, validate_finds_an_energy_that_is_no_longer_that_of_its_triangle) {
  MetricMesh mesh = unit_square_mesh(3);
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) known_energy(mesh, t);
  EXPECT_THAT(validate(mesh), IsEmpty());
  const std::int32_t inside = 5;
  ASSERT_TRUE(mesh.is_inside(inside));
  NodePlace place = place_of(mesh, inside);
  place.point = {place.point.x + 0.03, place.point.y - 0.02};
  move_node(mesh, inside, place);
  EXPECT_THAT(validate(mesh), Contains(HasSubstr("another energy")));
  Ball ball;
  collect_ball(mesh.complex, inside, ball);
  for (const EdgeHandle corner : ball.corners) note_change(mesh, triangle_of(corner));
  EXPECT_THAT(validate(mesh), IsEmpty());
}

TEST(MetricMesh, validate_says_what_is_broken) {
  EXPECT_THAT(validate(unit_square_mesh(3)), IsEmpty());
  MetricMesh mesh = unit_square_mesh(3);
  mesh.complex.points[2] = {-1, -1};
  EXPECT_THAT(validate(mesh), Contains(HasSubstr("does not turn anticlockwise")));
  mesh = unit_square_mesh(3);
  mesh.complex.constrained[0] = 0;
  EXPECT_THAT(validate(mesh), Contains("a border edge is not constrained"));
  mesh = unit_square_mesh(3);
  mesh.complex.constrain(mesh.complex.find_edge(0, 2), true);
  EXPECT_THAT(validate(mesh), Contains("a constrained edge is on no curve"));
  mesh = unit_square_mesh(3);
  mesh.curve_of_edge[edge_key(0, 2)] = 0;
  EXPECT_THAT(validate(mesh), Contains("an edge of a curve is missing"));
  mesh = unit_square_mesh(3);
  const EdgeHandle shared = mesh.complex.find_edge(0, 2);
  mesh.complex.neighbours[at(triangle_of(shared))][at(edge_of(shared))] = edge_handle(9, 0);
  EXPECT_THAT(validate(mesh), Contains(HasSubstr("do not agree about their edge")));
}

}  // namespace
}  // namespace tetfarm
