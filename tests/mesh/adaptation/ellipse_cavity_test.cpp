#include "mesh/adaptation/ellipse_cavity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "mesh/adaptation/edge_swaps.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// The square with its inner nodes moved at random, Delaunay by the metric.
MetricMesh uneven_square(int n, const Metric2& metric, std::uint64_t seed) {
  PlaneMesh mesh = plane_test::square(n);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(-0.25 / n, 0.25 / n);
  for (Vec2& p : mesh.points) {
    if (p.x > 1e-9 && p.x < 1 - 1e-9 && p.y > 1e-9 && p.y < 1 - 1e-9) {
      p = {p.x + share(random), p.y + share(random)};
    }
  }
  MetricMesh out = plane_test::metric_mesh(mesh, plane_test::constant_metrics(mesh, metric));
  swap_edges(out, SwapCriterion::ellipse, false);
  return out;
}

NodePlace middle_of(const MetricMesh& mesh, EdgeHandle edge) {
  const Vec2& p = mesh.complex.point(mesh.complex.node(triangle_of(edge), next(edge_of(edge))));
  const Vec2& q = mesh.complex.point(mesh.complex.node(triangle_of(edge), previous(edge_of(edge))));
  return {{(p.x + q.x) / 2, (p.y + q.y) / 2}, mesh.metrics[0], 0};
}

/// The nodes of the two triangles of the edge and of all that hold the point in their circles.
std::set<std::int32_t> delaunay_nodes(const MetricMesh& mesh, EdgeHandle edge, const Vec2& point) {
  const TriangleComplex& complex = mesh.complex;
  std::set<std::int32_t> nodes;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const auto& [a, b, c] = complex.nodes(t);
    const bool is_first =
        t == triangle_of(edge) || complex.neighbour(triangle_of(edge), edge_of(edge)) >> 2 == t;
    if (is_first || incircle(complex.point(a), complex.point(b), complex.point(c), point) > 0) {
      nodes.insert({a, b, c});
    }
  }
  return nodes;
}

std::set<std::int32_t> rim_of(const EllipseCavity& cavity) {
  return {cavity.rim_nodes().begin(), cavity.rim_nodes().end()};
}

void fill_with_new_node(MetricMesh& mesh, EllipseCavity& cavity, const NodePlace& place) {
  cavity.fill(mesh, add_node(mesh, place));
}

/// The edge between two places.
EdgeHandle edge_at(const MetricMesh& mesh, const Vec2& from, const Vec2& to) {
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    for (int i = 0; mesh.is_used(t) && i < 3; ++i) {
      const Vec2& p = mesh.complex.point(mesh.complex.node(t, next(i)));
      const Vec2& q = mesh.complex.point(mesh.complex.node(t, previous(i)));
      if (std::hypot(p.x - from.x, p.y - from.y) + std::hypot(q.x - to.x, q.y - to.y) < 1e-9) {
        return edge_handle(t, i);
      }
    }
  }
  return no_edge;
}

TEST(EllipseCavity, of_identity_metrics_is_the_delaunay_cavity_by_all_three_approximations) {
  const MetricMesh mesh = uneven_square(8, {1, 0, 1}, 1);
  ASSERT_THAT(validate(mesh), IsEmpty());
  int larger = 0;
  for (const EllipseTest test :
       {EllipseTest::at_new_node, EllipseTest::at_apex_too, EllipseTest::at_all_corners}) {
    EllipseCavity cavity({test, 1000});
    for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (mesh.complex.neighbour(t, i) == no_edge) continue;
        const NodePlace place = middle_of(mesh, edge_handle(t, i));
        ASSERT_TRUE(cavity.find(mesh, place, edge_handle(t, i)));
        const auto expected = delaunay_nodes(mesh, edge_handle(t, i), place.point);
        ASSERT_EQ(rim_of(cavity), expected) << "triangle " << t << " edge " << i;
        ASSERT_EQ(cavity.rim_nodes().size(), expected.size());
        larger += expected.size() > 4 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(larger, 100);
}

TEST(EllipseCavity, of_a_stretched_metric_reaches_along_the_ellipse) {
  // Thesis, figure 17: of all nodes those that the ellipse reaches, far along and near across.
  const PlaneMesh plane = plane_test::square(20);
  for (const bool is_level : {true, false}) {
    const Metric2 metric = is_level ? Metric2{1, 0, 400} : Metric2{400, 0, 1};
    const MetricMesh mesh =
        plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, metric));
    for (const EllipseTest test :
         {EllipseTest::at_new_node, EllipseTest::at_apex_too, EllipseTest::at_all_corners}) {
      const EdgeHandle edge = is_level ? edge_at(mesh, {0.5, 0.5}, {0.5, 0.55})
                                       : edge_at(mesh, {0.5, 0.5}, {0.55, 0.5});
      ASSERT_NE(edge, no_edge);
      EllipseCavity cavity({test, 1000});
      ASSERT_TRUE(cavity.find(mesh, middle_of(mesh, edge), edge));
      double along = 0;
      double across = 0;
      for (const std::int32_t v : cavity.rim_nodes()) {
        const Vec2 from{mesh.complex.point(v).x - 0.5, mesh.complex.point(v).y - 0.5};
        along = std::max(along, std::abs(is_level ? from.x : from.y));
        across = std::max(across, std::abs(is_level ? from.y : from.x));
      }
      EXPECT_GE(along, 0.2 - 1e-9);
      EXPECT_LE(across, 0.1 + 1e-9);
    }
  }
}

TEST(EllipseCavity, tests_take_the_metrics_that_they_name) {
  // The point is outside the circle of the triangle, but in its ellipse where y counts little.
  PlaneMesh plane;
  plane.points = {{0, 0}, {1, 0}, {0.5, 0.5}};
  plane.triangles = {{0, 1, 2}};
  const Metric2 round{1, 0, 1};
  const Metric2 flat{100, 0, 1};
  const NodePlace outside{{0.5, -1.2}, round, 0};
  const auto is_in = [&](const Metric2& at_p, const Metric2& at_apex, const Metric2& elsewhere,
                         EllipseTest test) {
    const MetricMesh mesh = plane_test::metric_mesh(plane, {elsewhere, elsewhere, at_apex});
    return is_in_ellipse(mesh, mesh.complex.nodes(0), 2, {outside.point, at_p, 0}, test);
  };
  EXPECT_FALSE(is_in(round, flat, flat, EllipseTest::at_new_node));
  EXPECT_TRUE(is_in(flat, round, round, EllipseTest::at_new_node));
  EXPECT_TRUE(is_in(flat, flat, round, EllipseTest::at_apex_too));
  EXPECT_FALSE(is_in(round, round, flat, EllipseTest::at_apex_too));
  EXPECT_TRUE(is_in(flat, flat, flat, EllipseTest::at_all_corners));
  EXPECT_FALSE(is_in(round, round, round, EllipseTest::at_all_corners));
  EXPECT_FALSE(is_in(flat, flat, round, EllipseTest::at_all_corners));
}

TEST(EllipseCavity, ends_at_the_ellipse_through_the_corners) {
  // An equilateral triangle drawn out by 10 in x: the ellipse through its corners is known.
  PlaneMesh plane;
  const double height = std::sqrt(0.75);
  plane.points = {{0, 0}, {10, 0}, {5, height}};
  plane.triangles = {{0, 1, 2}};
  const Metric2 metric{0.01, 0, 1};
  const MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, metric));
  const double radius = std::sqrt(1.0 / 3);
  for (int i = 0; i < 36; ++i) {
    const double angle = 0.1 + i * 0.17;
    for (const EllipseTest test :
         {EllipseTest::at_new_node, EllipseTest::at_apex_too, EllipseTest::at_all_corners}) {
      const auto is_in = [&](double share) {
        const Vec2 p{5 + 10 * share * radius * std::cos(angle),
                     height / 3 + share * radius * std::sin(angle)};
        return is_in_ellipse(mesh, mesh.complex.nodes(0), 2, {p, metric, 0}, test);
      };
      EXPECT_TRUE(is_in(0.999)) << angle;
      EXPECT_FALSE(is_in(1.001)) << angle;
    }
  }
}

TEST(EllipseCavity, never_reaches_across_a_held_edge) {
  const PlaneMesh plane = plane_test::two_regions(10);
  MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 400}));
  const EdgeHandle edge = edge_at(mesh, {0.9, 0.5}, {0.9, 0.6});
  ASSERT_NE(edge, no_edge);
  EllipseCavity cavity;
  const NodePlace place = middle_of(mesh, edge);
  ASSERT_TRUE(cavity.find(mesh, place, edge));
  for (const std::int32_t v : cavity.rim_nodes()) EXPECT_LE(mesh.complex.point(v).x, 1);
  EXPECT_GT(cavity.rim_nodes().size(), 6U);
  fill_with_new_node(mesh, cavity, place);
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_NEAR(plane_test::area(mesh.complex), 2, 1e-13);
}

TEST(EllipseCavity, restricted_to_one_ring_holds_only_neighbours_of_the_two_triangles) {
  // Thesis, figures 36 and 37.
  const PlaneMesh plane = plane_test::square(20);
  const MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 2500}));
  const EdgeHandle edge = edge_at(mesh, {0.5, 0.5}, {0.5, 0.55});
  const NodePlace place = middle_of(mesh, edge);
  EllipseCavity free;
  EllipseCavity restricted({EllipseTest::at_apex_too, 1});
  EllipseCavity none({EllipseTest::at_apex_too, 0});
  ASSERT_TRUE(free.find(mesh, place, edge));
  ASSERT_TRUE(restricted.find(mesh, place, edge));
  ASSERT_TRUE(none.find(mesh, place, edge));
  std::set<std::int32_t> allowed;
  const EdgeHandle other = mesh.complex.neighbour(triangle_of(edge), edge_of(edge));
  for (const std::int32_t t : {triangle_of(edge), triangle_of(other)}) {
    for (const std::int32_t v : mesh.complex.nodes(t)) allowed.insert(v);
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle beyond = mesh.complex.neighbour(t, i);
      allowed.insert(mesh.complex.node(triangle_of(beyond), edge_of(beyond)));
    }
  }
  for (const std::int32_t v : restricted.rim_nodes()) EXPECT_TRUE(allowed.contains(v));
  EXPECT_EQ(none.rim_nodes().size(), 4U);
  EXPECT_GT(restricted.rim_nodes().size(), none.rim_nodes().size());
  EXPECT_GT(free.rim_nodes().size(), restricted.rim_nodes().size());
}

TEST(EllipseCavity, filled_leaves_a_valid_mesh_of_the_same_area_wherever_the_node_is) {
  for (const Metric2& metric :
       {Metric2{1, 0, 1}, Metric2{1, 0, 900}, metric_of_sizes({1, 0.01, 0.7})}) {
    MetricMesh mesh = uneven_square(6, metric, 2);
    EllipseCavity cavity;
    std::mt19937_64 random(3);
    for (int round = 0; round < 200; ++round) {
      const auto t = static_cast<std::int32_t>(random() % at(mesh.complex.size()));
      const int i = static_cast<int>(random() % 3);
      const EdgeHandle edge = edge_handle(t, i);
      if (!mesh.is_used(t) || mesh.complex.is_constrained(t, i)) continue;
      const NodePlace place = middle_of(mesh, edge);
      if (!cavity.find(mesh, place, edge)) continue;
      fill_with_new_node(mesh, cavity, place);
      ASSERT_THAT(validate(mesh), IsEmpty()) << round;
      ASSERT_NEAR(plane_test::area(mesh.complex), 1, 1e-13);
    }
    EXPECT_GT(mesh.nodes(), 150);
  }
}

TEST(EllipseCavity, filled_is_valid_where_the_metrics_of_the_nodes_are_at_odds) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const auto any_metric = [&] {
    return metric_of_sizes({1, std::pow(10, -3 * share(random)), 4 * share(random)});
  };
  for (const EllipseTest test :
       {EllipseTest::at_new_node, EllipseTest::at_apex_too, EllipseTest::at_all_corners}) {
    MetricMesh mesh = uneven_square(10, {1, 0, 400}, 6);
    for (Metric2& metric : mesh.metrics) metric = any_metric();
    for (std::int32_t t = 0; t < mesh.complex.size(); ++t) note_change(mesh, t);
    EllipseCavity cavity({test, 1000});
    for (int round = 0; round < 600; ++round) {
      const auto t = static_cast<std::int32_t>(random() % at(mesh.complex.size()));
      const int i = static_cast<int>(random() % 3);
      if (!mesh.is_used(t) || mesh.complex.is_constrained(t, i)) continue;
      NodePlace place = middle_of(mesh, edge_handle(t, i));
      place.metric = any_metric();
      if (!cavity.find(mesh, place, edge_handle(t, i))) continue;
      fill_with_new_node(mesh, cavity, place);
      ASSERT_THAT(validate(mesh), IsEmpty()) << round;
      ASSERT_NEAR(plane_test::area(mesh.complex), 1, 1e-12);
    }
  }
}

TEST(EllipseCavity, divides_an_edge_of_the_border) {
  const PlaneMesh plane = plane_test::square(4);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  const EdgeHandle edge = edge_at(mesh, {0.25, 0}, {0.5, 0});
  ASSERT_NE(edge, no_edge);
  const std::int32_t a = mesh.complex.node(triangle_of(edge), next(edge_of(edge)));
  const std::int32_t b = mesh.complex.node(triangle_of(edge), previous(edge_of(edge)));
  const std::int32_t curve = curve_of_edge(mesh, a, b);
  EllipseCavity cavity;
  const NodePlace place = middle_of(mesh, edge);
  ASSERT_TRUE(cavity.find(mesh, place, edge));
  fill_with_new_node(mesh, cavity, place);
  const std::int32_t node = mesh.nodes() - 1;
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_DOUBLE_EQ(plane_test::area(mesh.complex), 1);
  EXPECT_EQ(curve_of_edge(mesh, a, b), -1);
  EXPECT_EQ(curve_of_edge(mesh, a, node), curve);
  EXPECT_EQ(curve_of_edge(mesh, node, b), curve);
}

TEST(EllipseCavity, divides_a_held_edge_inside_and_keeps_both_halves_and_the_regions) {
  const PlaneMesh plane = plane_test::two_regions(4);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  const EdgeHandle edge = edge_at(mesh, {1, 0.25}, {1, 0.5});
  ASSERT_NE(edge, no_edge);
  const std::int32_t a = mesh.complex.node(triangle_of(edge), next(edge_of(edge)));
  const std::int32_t b = mesh.complex.node(triangle_of(edge), previous(edge_of(edge)));
  EllipseCavity cavity;
  const NodePlace place = middle_of(mesh, edge);
  ASSERT_TRUE(cavity.find(mesh, place, edge));
  fill_with_new_node(mesh, cavity, place);
  const std::int32_t node = mesh.nodes() - 1;
  EXPECT_THAT(validate(mesh), IsEmpty());
  for (const std::int32_t end : {a, b}) {
    EdgeHandle half = mesh.complex.find_edge(node, end);
    ASSERT_NE(half, no_edge);
    EXPECT_TRUE(mesh.complex.is_constrained(triangle_of(half), edge_of(half)));
    half = mesh.complex.find_edge(end, node);
    ASSERT_NE(half, no_edge);
    EXPECT_TRUE(mesh.complex.is_constrained(triangle_of(half), edge_of(half)));
    EXPECT_GE(curve_of_edge(mesh, node, end), 0);
  }
  const auto areas = plane_test::region_areas(plane_mesh_of(mesh).mesh);
  EXPECT_DOUBLE_EQ(areas.at(1), 1);
  EXPECT_DOUBLE_EQ(areas.at(2), 1);
}

TEST(EllipseCavity, takes_in_what_hides_a_node_beyond_its_edge) {
  // A node on a curve that bends into the domain, past the first triangles.
  const PlaneMesh plane = plane_test::square(8);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  const EdgeHandle edge = edge_at(mesh, {0.5, 0}, {0.625, 0});
  ASSERT_NE(edge, no_edge);
  NodePlace place = middle_of(mesh, edge);
  place.point.y = 0.14;
  EllipseCavity cavity;
  ASSERT_TRUE(cavity.find(mesh, place, edge));
  fill_with_new_node(mesh, cavity, place);
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_NEAR(plane_test::area(mesh.complex), 1 - 0.125 * 0.14 / 2, 1e-14);
}

TEST(EllipseCavity, refuses_a_node_that_the_border_hides) {
  const PlaneMesh plane = plane_test::square(4);
  const MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  const EdgeHandle edge = edge_at(mesh, {0.25, 0}, {0.5, 0});
  NodePlace place = middle_of(mesh, edge);
  place.point = {2, 0.5};
  EllipseCavity cavity;
  EXPECT_FALSE(cavity.find(mesh, place, edge));
}

}  // namespace
}  // namespace tetfarm
