#include "mesh/adaptation/edge_refinement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

struct RefinedShape {
  RefinedShape(const PlaneMesh& plane, const Metric2& metric)
      : mesh(plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, metric))),
        field(plane_test::field_of(plane, plane_test::constant_metrics(plane, metric))) {}

  std::int64_t refine(EdgesToVisit which, bool only_on_curves = false) {
    const std::int64_t nodes = refine_edges(mesh, field, cavity, limits, which, only_on_curves);
    EXPECT_THAT(validate(mesh), IsEmpty());
    return nodes;
  }
  double longest_edge(bool only_held) const {
    double longest = 0;
    for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
      for (int i = 0; mesh.is_used(t) && i < 3; ++i) {
        if (only_held && !mesh.complex.is_constrained(t, i)) continue;
        longest = std::max(longest, edge_length(mesh, mesh.complex.node(t, next(i)),
                                                mesh.complex.node(t, previous(i))));
      }
    }
    return longest;
  }

  MetricMesh mesh;
  MetricField field;
  EllipseCavity cavity;
  RefinementLimits limits;
};

/// An edge inside, or on the border.
EdgeHandle some_edge(const MetricMesh& mesh, bool on_border) {
  for (std::int32_t t = mesh.complex.size() / 2; t < mesh.complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (on_border == (mesh.complex.neighbour(t, i) == no_edge)) return edge_handle(t, i);
    }
  }
  return no_edge;
}

TEST(EdgeRefinement, divides_an_edge_inside_where_it_is_told) {
  // Thesis, figure 32.
  RefinedShape shape(plane_test::square(3), {1, 0, 1});
  const EdgeHandle edge = some_edge(shape.mesh, false);
  const Vec2 from =
      shape.mesh.complex.point(shape.mesh.complex.node(triangle_of(edge), next(edge_of(edge))));
  const Vec2 to =
      shape.mesh.complex.point(shape.mesh.complex.node(triangle_of(edge), previous(edge_of(edge))));
  ASSERT_TRUE(divide_edge(shape.mesh, shape.field, shape.cavity, edge, 0.25, 0));
  EXPECT_THAT(validate(shape.mesh), IsEmpty());
  EXPECT_DOUBLE_EQ(plane_test::area(shape.mesh.complex), 1);
  EXPECT_NEAR(shape.mesh.complex.points.back().x, from.x + 0.25 * (to.x - from.x), 1e-15);
  EXPECT_NEAR(shape.mesh.complex.points.back().y, from.y + 0.25 * (to.y - from.y), 1e-15);
  EXPECT_TRUE(shape.mesh.is_inside(shape.mesh.nodes() - 1));
}

TEST(EdgeRefinement, changes_nothing_where_a_new_edge_would_be_too_short) {
  RefinedShape shape(plane_test::square(3), plane_test::round_metric(1.0 / 3));
  for (const bool on_border : {false, true}) {
    const EdgeHandle edge = some_edge(shape.mesh, on_border);
    EXPECT_FALSE(divide_edge(shape.mesh, shape.field, shape.cavity, edge, 0.5, 0.72));
    EXPECT_EQ(shape.mesh.nodes(), 16);
    EXPECT_EQ(shape.mesh.complex.size(), 18);
    EXPECT_THAT(validate(shape.mesh), IsEmpty());
  }
  EXPECT_EQ(shape.refine(EdgesToVisit::all, true), 0);
  EXPECT_FALSE(
      divide_edge(shape.mesh, shape.field, shape.cavity, some_edge(shape.mesh, true), 0.5, 0.51));
  EXPECT_TRUE(
      divide_edge(shape.mesh, shape.field, shape.cavity, some_edge(shape.mesh, true), 0.5, 0.49));
}

TEST(EdgeRefinement, at_middles_gives_every_long_edge_one_node) {
  // Thesis, figures 32 and 34.
  RefinedShape shape(plane_test::square(1), plane_test::round_metric(0.1));
  shape.limits.at_middles = true;
  shape.limits.shortest = 0;
  // A side whose triangle was made anew meanwhile has its turn the next time.
  const std::int64_t first = shape.refine(EdgesToVisit::all, true);
  EXPECT_GE(first, 2);
  EXPECT_LE(first, 4);
  for (std::int32_t v = 4; v < shape.mesh.nodes(); ++v) {
    const Vec2& p = shape.mesh.complex.point(v);
    EXPECT_TRUE((p.x == 0.5) != (p.y == 0.5)) << p.x << " " << p.y;
    EXPECT_GE(shape.mesh.curve_of_node[at(v)], 0);
  }
  EXPECT_DOUBLE_EQ(plane_test::area(shape.mesh.complex), 1);
}

TEST(EdgeRefinement, puts_nodes_of_a_border_on_its_curve) {
  // Thesis, figure 34, leaves them on the chord.
  RefinedShape shape(plane_test::disc(4), plane_test::round_metric(0.05));
  while (shape.refine(EdgesToVisit::all, true) > 0) {
  }
  EXPECT_LE(shape.longest_edge(true), shape.limits.longest);
  EXPECT_EQ(plane_test::distance_from_curves(shape.mesh), 0);
  int on_curve = 0;
  for (std::int32_t v = 0; v < shape.mesh.nodes(); ++v) {
    if (shape.mesh.is_inside(v) || shape.mesh.complex.node2triangle[at(v)] < 0) continue;
    const Vec2& p = shape.mesh.complex.point(v);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 2e-4);
    ++on_curve;
  }
  EXPECT_GT(on_curve, 85);
  EXPECT_GT(plane_test::area(shape.mesh.complex), 3.13);
}

TEST(EdgeRefinement, joins_nodes_inside_that_a_new_one_of_the_border_came_too_near_to) {
  PlaneMesh plane;
  plane.points = {{0, 0}, {1, 0}, {0.5, 0.08}, {0, 1}, {1, 1}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 4}, {2, 4, 3}};
  for (const bool has_room : {false, true}) {
    RefinedShape shape(plane, plane_test::round_metric(has_room ? 0.1 : 0.5));
    const EdgeHandle edge = shape.mesh.complex.find_edge(0, 1);
    ASSERT_TRUE(divide_edge(shape.mesh, shape.field, shape.cavity, edge, 0.5, 0.7));
    EXPECT_THAT(validate(shape.mesh), IsEmpty());
    EXPECT_DOUBLE_EQ(plane_test::area(shape.mesh.complex), 1);
    EXPECT_EQ(shape.mesh.complex.points.back(), (Vec2{0.5, 0}));
    EXPECT_EQ(shape.mesh.complex.node2triangle[2] >= 0, has_room);
  }
}

TEST(EdgeRefinement, gives_a_long_edge_all_its_nodes_at_even_metric_lengths) {
  PlaneMesh plane = plane_test::square(1);
  RefinedShape shape(plane, plane_test::round_metric(0.1));
  std::int64_t nodes = 0;
  while (const std::int64_t more = shape.refine(EdgesToVisit::all, true)) nodes += more;
  EXPECT_EQ(nodes, 36);
  for (std::int32_t v = 0; v < shape.mesh.nodes(); ++v) {
    const Vec2& p = shape.mesh.complex.point(v);
    EXPECT_NEAR(10 * p.x, std::round(10 * p.x), 1e-9);
    EXPECT_NEAR(10 * p.y, std::round(10 * p.y), 1e-9);
  }
}

TEST(EdgeRefinement, spaces_nodes_by_a_metric_that_varies) {
  PlaneMesh plane = plane_test::square(1);
  const auto metrics = plane_test::metrics_of(
      plane, [](const Vec2& p) { return plane_test::round_metric(p.x < 0.5 ? 0.01 : 0.16); });
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  EllipseCavity cavity;
  while (refine_edges(mesh, field, cavity, {}, EdgesToVisit::all, true) > 0) {
  }
  EXPECT_THAT(validate(mesh), IsEmpty());
  for (const auto& [key, curve] : mesh.curve_of_edge) {
    const double length = edge_length(mesh, static_cast<std::int32_t>(key >> 32U),
                                      static_cast<std::int32_t>(key & 0xffffffffU));
    EXPECT_GT(length, 0.7071);
    EXPECT_LT(length, 1.4143);
  }
}

TEST(EdgeRefinement, of_all_edges_ends_with_no_long_edge_on_the_border) {
  for (const Metric2& metric :
       {plane_test::round_metric(0.08), metric_of_sizes({0.5, 0.02, 0.6})}) {
    RefinedShape shape(plane_test::square(2), metric);
    for (int pass = 0; pass < 60; ++pass) {
      while (shape.refine(EdgesToVisit::all, true) > 0) {
      }
      if (shape.refine(EdgesToVisit::all) == 0) break;
    }
    EXPECT_EQ(shape.refine(EdgesToVisit::all), 0);
    EXPECT_DOUBLE_EQ(plane_test::area(shape.mesh.complex), 1);
    EXPECT_LE(shape.longest_edge(true), shape.limits.longest);
  }
}

TEST(EdgeRefinement, of_active_edges_divides_none_where_no_node_is_active) {
  RefinedShape shape(plane_test::square(8), plane_test::round_metric(0.09));
  EXPECT_EQ(shape.refine(EdgesToVisit::active), 0);
  for (std::int32_t v = 0; v < shape.mesh.nodes(); ++v) {
    shape.mesh.active[at(v)] = shape.mesh.complex.point(v).x < 0.1 ? 1 : 0;
  }
  EXPECT_GT(shape.refine(EdgesToVisit::active), 0);
}

TEST(EdgeRefinement, of_touched_edges_comes_to_what_that_of_all_comes_to) {
  for (const Metric2& metric :
       {plane_test::round_metric(0.05), metric_of_sizes({0.3, 0.02, 0.6})}) {
    RefinedShape shape(plane_test::square(3), metric);
    RefinedShape of_all = shape;
    shape.mesh.touched.assign(shape.mesh.touched.size(), TouchedBits::now);
    for (;;) {
      begin_round(shape.mesh);
      const std::int64_t nodes = shape.refine(EdgesToVisit::touched);
      EXPECT_EQ(of_all.refine(EdgesToVisit::all), nodes);
      if (nodes == 0) break;
    }
    EXPECT_EQ(shape.mesh.complex.points, of_all.mesh.complex.points);
    EXPECT_EQ(shape.mesh.complex.triangles, of_all.mesh.complex.triangles);
    begin_round(shape.mesh);
    EXPECT_EQ(std::count(shape.mesh.touched.begin(), shape.mesh.touched.end(), 0),
              shape.mesh.nodes());
  }
}

TEST(EdgeRefinement, keeps_the_edge_between_regions) {
  RefinedShape shape(plane_test::two_regions(2), plane_test::round_metric(0.06));
  shape.refine(EdgesToVisit::all, true);
  shape.refine(EdgesToVisit::all);
  const PlaneMesh mesh = plane_mesh_of(shape.mesh).mesh;
  EXPECT_NEAR(plane_test::region_areas(mesh).at(1), 1, 1e-13);
  EXPECT_NEAR(plane_test::region_areas(mesh).at(2), 1, 1e-13);
  EXPECT_NEAR(plane_test::patch_lengths(mesh).at(0), 1, 1e-13);
  EXPECT_NEAR(plane_test::patch_lengths(mesh).at(7), 6, 1e-13);
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    if (mesh.patches[k] != 0) continue;
    EXPECT_EQ(mesh.points[at(mesh.edges[k][0])].x, 1);
    EXPECT_EQ(mesh.points[at(mesh.edges[k][1])].x, 1);
  }
}

TEST(EdgeRefinement, divides_the_border_at_a_node_where_two_parts_meet) {
  PlaneMesh plane;
  plane.points = {{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}};
  plane.triangles = {{0, 1, 2}, {0, 3, 4}};
  RefinedShape shape(plane, plane_test::round_metric(0.2));
  while (shape.refine(EdgesToVisit::all, true) > 0) {
  }
  EXPECT_LE(shape.longest_edge(true), shape.limits.longest);
  EXPECT_NEAR(plane_test::area(shape.mesh.complex), 1, 1e-14);
}

}  // namespace
}  // namespace tetfarm
