#include "mesh/adaptation/checked_plane_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/mesh/adaptation/plane_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string refusal_of_mesh(const PlaneMesh& mesh) {
  return error_text_of<InvalidInput>([&] { checked_complex(mesh); });
}

std::string refusal_of_metrics(const PlaneMesh& mesh, const std::vector<Metric2>& metrics) {
  return error_text_of<InvalidInput>([&] { check_metrics(mesh, metrics); });
}

MetricMesh unit_metric_mesh(const PlaneMesh& mesh, double corner_angle_deg = 30) {
  return make_metric_mesh(mesh, checked_complex(mesh),
                          plane_test::constant_metrics(mesh, {1, 0, 1}), corner_angle_deg);
}

std::vector<std::int32_t> corners_of(const MetricMesh& mesh) {
  std::vector<std::int32_t> corners;
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    if (mesh.curve_of_node[at(v)] == MetricMesh::corner) corners.push_back(v);
  }
  return corners;
}

TEST(CheckedPlaneMesh, turns_clockwise_triangles_round) {
  PlaneMesh mesh = plane_test::square(3);
  const double whole = plane_test::area(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 2) {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  }
  const TriangleComplex complex = checked_complex(mesh);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_DOUBLE_EQ(plane_test::area(complex), whole);
  EXPECT_THAT(validate(unit_metric_mesh(mesh)), IsEmpty());
}

TEST(CheckedPlaneMesh, refuses_a_mesh_without_triangles) {
  EXPECT_THAT(refusal_of_mesh({}), HasSubstr("no triangles"));
}

TEST(CheckedPlaneMesh, refuses_a_triangle_without_area_with_number_and_place) {
  PlaneMesh mesh = plane_test::square(3);
  mesh.points[at(mesh.triangles[4][1])] = mesh.points[at(mesh.triangles[4][0])];
  EXPECT_THAT(refusal_of_mesh(mesh), AllOf(HasSubstr("no area"), HasSubstr("triangle "),
                                           HasSubstr("nodes "), HasSubstr("at (")));
  PlaneMesh flat;
  flat.points = {{0, 0}, {1, 1}, {3, 3}, {0, 5}};
  flat.triangles = {{0, 2, 3}, {1, 2, 0}};
  EXPECT_EQ(refusal_of_mesh(flat), "triangle 2, nodes 2 3 1 at (1, 1): the triangle has no area");
}

TEST(CheckedPlaneMesh, refuses_a_node_number_out_of_range) {
  for (const std::int32_t wrong : {-1, 16, std::numeric_limits<std::int32_t>::max() - 1}) {
    PlaneMesh mesh = plane_test::square(3);
    mesh.triangles[7][1] = wrong;
    EXPECT_THAT(refusal_of_mesh(mesh),
                AllOf(HasSubstr("triangle 8"), HasSubstr("node " + std::to_string(wrong + 1)),
                      HasSubstr("the mesh has 16")));
  }
}

TEST(CheckedPlaneMesh, refuses_an_edge_of_three_triangles) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.4, 2}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_THAT(refusal_of_mesh(mesh), AllOf(HasSubstr("triangle 1,"), HasSubstr("triangle 3"),
                                           HasSubstr("at (0, 0)"), HasSubstr("same side")));
}

TEST(CheckedPlaneMesh, refuses_two_triangles_on_the_same_side_of_an_edge) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0.5, 1}, {0.4, 2}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_THAT(refusal_of_mesh(mesh), HasSubstr("same side"));
}

TEST(CheckedPlaneMesh, refuses_coordinates_that_are_no_numbers) {
  for (const double wrong : {not_a_number, HUGE_VAL, -HUGE_VAL, 1e61}) {
    PlaneMesh mesh = plane_test::square(2);
    mesh.points[3].y = wrong;
    EXPECT_THAT(refusal_of_mesh(mesh), AllOf(HasSubstr("node 4"), HasSubstr("coordinates")));
    mesh.points[3].y = 0;
    mesh.points[0].x = wrong;
    EXPECT_THAT(refusal_of_mesh(mesh), AllOf(HasSubstr("node 1"), HasSubstr("coordinates")));
  }
}

TEST(CheckedPlaneMesh, refuses_an_edge_that_no_triangle_has) {
  const auto refusal = [](const std::array<std::int32_t, 2>& edge) {
    PlaneMesh mesh = plane_test::square(2);
    mesh.edges.push_back(edge);
    mesh.patches.push_back(1);
    return error_text_of<InvalidInput>([&] { unit_metric_mesh(mesh); });
  };
  EXPECT_THAT(refusal({0, 8}),
              AllOf(HasSubstr("edge 9"), HasSubstr("nodes 1 and 9"), HasSubstr("at (0, 0)")));
  EXPECT_THAT(refusal({2, 2}), HasSubstr("edge 9"));
  EXPECT_THAT(refusal({0, 9}), HasSubstr("edge 9"));
  EXPECT_THAT(refusal({-1, 0}), HasSubstr("edge 9"));
  EXPECT_EQ(refusal({2, 0}), "");
}

TEST(CheckedPlaneMesh, refuses_metrics_that_are_none_with_number_and_place) {
  const PlaneMesh mesh = plane_test::square(2);
  const auto refusal = [&](const Metric2& wrong) {
    auto metrics = plane_test::constant_metrics(mesh, {1, 0, 1});
    metrics[8] = wrong;
    return refusal_of_metrics(mesh, metrics);
  };
  EXPECT_EQ(refusal({2, 1, 3}), "");
  for (const Metric2& wrong :
       {Metric2{not_a_number, 0, 1}, Metric2{1, not_a_number, 1}, Metric2{1, 0, HUGE_VAL},
        Metric2{0, 0, 0}, Metric2{-1, 0, -1}, Metric2{1, 2, 1}, Metric2{1, 0, 0}}) {
    EXPECT_THAT(refusal(wrong),
                AllOf(HasSubstr("node 9 at (1, 1)"), HasSubstr("not positive definite")));
  }
}

TEST(CheckedPlaneMesh, refuses_another_number_of_metrics_than_of_nodes) {
  const PlaneMesh mesh = plane_test::square(2);
  EXPECT_THAT(refusal_of_metrics(mesh, std::vector<Metric2>(8)),
              AllOf(HasSubstr("8 metrics"), HasSubstr("9 nodes")));
  EXPECT_THAT(refusal_of_metrics(mesh, std::vector<Metric2>(10)), HasSubstr("10 metrics"));
  EXPECT_EQ(refusal_of_metrics(mesh, std::vector<Metric2>(9)), "");
}

TEST(CheckedPlaneMesh, names_the_file_where_it_has_one) {
  PlaneMesh mesh = plane_test::square(2);
  mesh.name = "wing.mesh";
  mesh.points[3].y = not_a_number;
  EXPECT_THAT(refusal_of_mesh(mesh), testing::StartsWith("wing.mesh: node 4"));
}

TEST(CheckedPlaneMesh, makes_corners_where_the_border_turns) {
  const MetricMesh mesh = unit_metric_mesh(plane_test::ell(2));
  std::vector<std::pair<double, double>> places;
  for (const std::int32_t v : corners_of(mesh)) {
    places.emplace_back(mesh.complex.point(v).x, mesh.complex.point(v).y);
  }
  using Place = std::pair<double, double>;
  EXPECT_THAT(places, UnorderedElementsAre(Place{0, 0}, Place{2, 0}, Place{2, 1}, Place{1, 1},
                                           Place{1, 2}, Place{0, 2}));
  EXPECT_EQ(mesh.curves.size(), 6U);
  EXPECT_THAT(validate(mesh), IsEmpty());
}

TEST(CheckedPlaneMesh, makes_corners_where_patches_meet) {
  PlaneMesh mesh = plane_test::disc(4);
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const Vec2& p = mesh.points[at(mesh.edges[k][0])];
    const Vec2& q = mesh.points[at(mesh.edges[k][1])];
    mesh.patches[k] = p.y + q.y > 0 ? 1 : 2;
  }
  const MetricMesh halves = unit_metric_mesh(mesh);
  ASSERT_EQ(corners_of(halves).size(), 2U);
  for (const std::int32_t v : corners_of(halves)) EXPECT_NEAR(halves.complex.point(v).y, 0, 1e-12);
  ASSERT_EQ(halves.curves.size(), 2U);
  EXPECT_NE(halves.curves[0].patch, halves.curves[1].patch);
}

TEST(CheckedPlaneMesh, makes_no_corners_on_a_smooth_border_but_one_closed_curve) {
  const MetricMesh mesh = unit_metric_mesh(plane_test::disc(4));
  EXPECT_THAT(corners_of(mesh), IsEmpty());
  ASSERT_EQ(mesh.curves.size(), 1U);
  EXPECT_TRUE(mesh.curves[0].shape.is_closed());
  EXPECT_EQ(mesh.curves[0].patch, 5);
  EXPECT_EQ(plane_test::distance_from_curves(mesh), 0);
  EXPECT_EQ(mesh.curve_of_edge.size(), 24U);
}

TEST(CheckedPlaneMesh, measures_turns_against_the_corner_angle) {
  // Twelve edges turn by 30 degrees each.
  EXPECT_EQ(corners_of(unit_metric_mesh(plane_test::disc(2), 31)).size(), 0U);
  EXPECT_EQ(corners_of(unit_metric_mesh(plane_test::disc(2), 29)).size(), 12U);
}

TEST(CheckedPlaneMesh, keeps_the_corners_of_the_mesh_even_inside) {
  PlaneMesh mesh = plane_test::disc(4);
  mesh.corners = {0, mesh.edges[3][0]};
  EXPECT_THAT(corners_of(unit_metric_mesh(mesh)), UnorderedElementsAre(0, mesh.edges[3][0]));
}

TEST(CheckedPlaneMesh, holds_edges_between_regions) {
  const MetricMesh mesh = unit_metric_mesh(plane_test::two_regions(3));
  EXPECT_THAT(validate(mesh), IsEmpty());
  std::size_t held = 0;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.complex.neighbour(t, i) == no_edge || !mesh.complex.is_constrained(t, i)) continue;
      EXPECT_EQ(mesh.complex.point(mesh.complex.node(t, next(i))).x, 1);
      EXPECT_EQ(mesh.complex.point(mesh.complex.node(t, previous(i))).x, 1);
      ++held;
    }
  }
  EXPECT_EQ(held, 6U) << "three, from both sides";
  EXPECT_EQ(mesh.curve_of_edge.size(), 18U + 3U);
}

TEST(CheckedPlaneMesh, takes_two_parts_that_meet_in_a_node) {
  PlaneMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  mesh.regions = {0, 0};
  plane_test::add_border(mesh, [](const Vec2&) { return 1; });
  EXPECT_EQ(error_text_of<InvalidInput>([&] {
              const MetricMesh both = unit_metric_mesh(mesh);
              EXPECT_THAT(validate(both), IsEmpty());
              EXPECT_EQ(both.curve_of_node[0], MetricMesh::corner);
            }),
            "");
}

TEST(CheckedPlaneMesh, comes_back_as_it_was_but_for_the_order) {
  const PlaneMesh mesh = plane_test::two_regions(4);
  const auto metrics = plane_test::metrics_of(mesh, [](const Vec2& p) {
    return Metric2{1 + p.x, 0.1, 2 + p.y};
  });
  const MeshWithMetrics back = plane_mesh_of(plane_test::metric_mesh(mesh, metrics));
  EXPECT_THAT(plane_test::whats_wrong(back.mesh), IsEmpty());
  EXPECT_EQ(back.mesh.points.size(), mesh.points.size());
  EXPECT_EQ(back.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(back.mesh.edges.size(), mesh.edges.size() + 4) << "those between the regions";
  EXPECT_EQ(plane_test::region_areas(back.mesh), plane_test::region_areas(mesh));
  auto lengths = plane_test::patch_lengths(back.mesh);
  EXPECT_DOUBLE_EQ(lengths[7], 6);
  EXPECT_DOUBLE_EQ(lengths[0], 1);
  for (std::size_t v = 0; v < back.mesh.points.size(); ++v) {
    const Vec2& p = back.mesh.points[v];
    EXPECT_EQ(back.metrics[v], (Metric2{1 + p.x, 0.1, 2 + p.y}));
  }
  std::size_t corners = 0;
  for (const std::int32_t v : back.mesh.corners) {
    const Vec2& p = back.mesh.points[at(v)];
    EXPECT_TRUE(p.y == 0 || p.y == 1);
    ++corners;
  }
  EXPECT_EQ(corners, 6U);
}

}  // namespace
}  // namespace tetfarm
