#include "mesh/adaptation/edge_swaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// The square with its inner nodes moved at random by up to a third of a cell.
PlaneMesh shaken_square(int n, std::uint64_t seed) {
  PlaneMesh mesh = plane_test::square(n);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(-0.3 / n, 0.3 / n);
  for (Vec2& p : mesh.points) {
    if (p.x > 1e-9 && p.x < 1 - 1e-9 && p.y > 1e-9 && p.y < 1 - 1e-9) {
      p = {p.x + share(random), p.y + share(random)};
    }
  }
  return mesh;
}

std::vector<double> energies_of(const MetricMesh& mesh) {
  std::vector<double> energies;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) {
    if (mesh.is_used(t)) energies.push_back(triangle_energy(mesh, mesh.complex.nodes(t)));
  }
  std::sort(energies.rbegin(), energies.rend());
  return energies;
}

/// Edges that are not Delaunay once the plane is drawn out by the factors; those of nearly
/// cocircular nodes do not count.
int violations(const MetricMesh& mesh, double x_factor, double y_factor) {
  const TriangleComplex& complex = mesh.complex;
  const auto drawn = [&](std::int32_t v) {
    return Vec2{complex.point(v).x * x_factor, complex.point(v).y * y_factor};
  };
  int count = 0;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other == no_edge || complex.is_constrained(t, i)) continue;
      const Vec2 apex = drawn(complex.node(triangle_of(other), edge_of(other)));
      const Vec2 inward{apex.x + 1e-7 * (apex.x - drawn(complex.node(t, i)).x),
                        apex.y + 1e-7 * (apex.y - drawn(complex.node(t, i)).y)};
      const auto& [a, b, c] = complex.nodes(t);
      count += incircle(drawn(a), drawn(b), drawn(c), inward) > 0 ? 1 : 0;
    }
  }
  return count;
}

TEST(EdgeSwaps, by_ellipses_of_identity_metrics_make_the_delaunay_triangulation) {
  const PlaneMesh plane = shaken_square(12, 1);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  EXPECT_GT(violations(mesh, 1, 1), 20);
  EXPECT_GT(swap_edges(mesh, SwapCriterion::ellipse, false), 0);
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_NEAR(plane_test::area(mesh.complex), 1, 1e-14);
  EXPECT_EQ(violations(mesh, 1, 1), 0);
  EXPECT_EQ(swap_edges(mesh, SwapCriterion::ellipse, false), 0);
}

TEST(EdgeSwaps, by_ellipses_of_one_metric_make_the_delaunay_triangulation_of_the_drawn_plane) {
  const PlaneMesh plane = shaken_square(12, 2);
  MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 100}));
  EXPECT_GT(swap_edges(mesh, SwapCriterion::ellipse, false), 100);
  EXPECT_THAT(validate(mesh), IsEmpty());
  EXPECT_EQ(violations(mesh, 1, 10), 0);
  EXPECT_GT(violations(mesh, 1, 1), 100);
}

TEST(EdgeSwaps, by_ellipses_take_the_metrics_of_all_four_nodes) {
  PlaneMesh plane;
  plane.points = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  plane.triangles = {{0, 1, 3}, {2, 3, 1}};
  const auto swaps = [&](const Metric2& of_apexes, const Metric2& of_ends) {
    MetricMesh mesh = plane_test::metric_mesh(plane, {of_apexes, of_ends, of_apexes, of_ends});
    return swap_edges(mesh, SwapCriterion::ellipse, false);
  };
  // The edge lies along x: it goes where x counts for more than y.
  EXPECT_EQ(swaps({1, 0, 4}, {100, 0, 1}), 1);
  EXPECT_EQ(swaps({100, 0, 1}, {1, 0, 400}), 0);
  EXPECT_EQ(swaps({100, 0, 1}, {1, 0, 4}), 1);
  EXPECT_EQ(swaps({1, 0, 1}, {1, 0, 1}), 0);
}

TEST(EdgeSwaps, by_energy_never_raise_the_worst_energies) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const PlaneMesh plane = shaken_square(8, seed);
    const auto metrics = plane_test::metrics_of(plane, [](const Vec2& p) {
      return metric_of_sizes({0.3, 0.02 + 0.1 * p.x, 2 * p.y});
    });
    MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
    const std::vector<double> before = energies_of(mesh);
    EXPECT_GT(swap_edges(mesh, SwapCriterion::energy, false), 0);
    const std::vector<double> after = energies_of(mesh);
    EXPECT_THAT(validate(mesh), IsEmpty());
    EXPECT_LE(after.front(), before.front());
    EXPECT_TRUE(
        std::lexicographical_compare(after.begin(), after.end(), before.begin(), before.end()));
    EXPECT_EQ(swap_edges(mesh, SwapCriterion::energy, false), 0) << "it ended";
  }
}

TEST(EdgeSwaps, end_where_metrics_are_at_odds) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  const PlaneMesh plane = shaken_square(10, 3);
  for (int round = 0; round < 20; ++round) {
    const auto metrics = plane_test::metrics_of(plane, [&](const Vec2&) {
      return metric_of_sizes({1, std::pow(10, -5 * share(random)), 4 * share(random)});
    });
    MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
    for (const SwapCriterion criterion : {SwapCriterion::ellipse, SwapCriterion::energy}) {
      swap_edges(mesh, criterion, false);
      EXPECT_THAT(validate(mesh), IsEmpty());
      EXPECT_NEAR(plane_test::area(mesh.complex), 1, 1e-13);
    }
  }
}

TEST(EdgeSwaps, leave_held_edges) {
  const PlaneMesh plane = plane_test::two_regions(6);
  MetricMesh mesh =
      plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 2500}));
  for (const SwapCriterion criterion : {SwapCriterion::ellipse, SwapCriterion::energy}) {
    swap_edges(mesh, criterion, false);
    EXPECT_THAT(validate(mesh), IsEmpty());
  }
  const PlaneMesh swapped = plane_mesh_of(mesh).mesh;
  EXPECT_NEAR(plane_test::region_areas(swapped).at(1), 1, 1e-14);
  EXPECT_NEAR(plane_test::patch_lengths(swapped).at(0), 1, 1e-14);
}

TEST(EdgeSwaps, by_ellipses_that_go_round_in_a_circle_do_not_keep_others_from_being_swapped) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> share(0, 1);
  PlaneMesh plane = shaken_square(16, 5);
  auto metrics = plane_test::constant_metrics(plane, {1, 0, 100});
  // Metrics at odds in a corner.
  for (std::size_t v = 0; v < metrics.size(); ++v) {
    const Vec2& p = plane.points[v];
    if (p.x > 0.3 || p.y > 0.3) continue;
    metrics[v] = metric_of_sizes({1, std::pow(10, -3 * share(random)), 4 * share(random)});
  }
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  EXPECT_GT(swap_edges(mesh, SwapCriterion::ellipse, false), 100);
  EXPECT_THAT(validate(mesh), IsEmpty());
  const TriangleComplex& complex = mesh.complex;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const auto is_far = [&](std::int32_t v) { return complex.point(v).x > 0.5; };
    const TriangleComplex::Nodes& n = complex.nodes(t);
    for (int i = 0; i < 3 && std::all_of(n.begin(), n.end(), is_far); ++i) {
      const EdgeHandle other = complex.neighbour(t, i);
      if (other == no_edge || !is_far(complex.node(triangle_of(other), edge_of(other)))) continue;
      const auto drawn = [&](std::int32_t v) {
        return Vec2{complex.point(v).x, 10 * complex.point(v).y};
      };
      const std::int32_t apex = complex.node(triangle_of(other), edge_of(other));
      EXPECT_LT(incircle(drawn(n[0]), drawn(n[1]), drawn(n[2]), drawn(apex)), 1e-9);
    }
  }
}

TEST(EdgeSwaps, of_unchecked_triangles_leave_the_others) {
  const PlaneMesh plane = shaken_square(12, 4);
  MetricMesh mesh = plane_test::metric_mesh(plane, plane_test::constant_metrics(plane, {1, 0, 1}));
  EXPECT_EQ(swap_edges(mesh, SwapCriterion::ellipse, true), 0);
  EXPECT_EQ(swap_edges(mesh, SwapCriterion::energy, true), 0);
  MetricMesh of_all = mesh;
  for (std::int32_t t = 0; t < mesh.complex.size(); ++t) note_change(mesh, t);
  const std::int64_t swaps = swap_edges(mesh, SwapCriterion::energy, true);
  EXPECT_GT(swaps, 0);
  EXPECT_EQ(swap_edges(of_all, SwapCriterion::energy, false), swaps);
  EXPECT_EQ(mesh.complex.triangles, of_all.complex.triangles);
  EXPECT_EQ(swap_edges(mesh, SwapCriterion::energy, true), 0) << "they are checked";
}

TEST(EdgeSwaps, of_what_changed_find_all_that_there_is_to_swap) {
  const PlaneMesh plane = plane_test::square(14);
  MetricMesh mesh = plane_test::metric_mesh(
      plane, plane_test::constant_metrics(plane, plane_test::round_metric(1.0 / 14)));
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> share(-0.6 / 14, 0.6 / 14);
  swap_edges(mesh, SwapCriterion::energy, false);
  Ball ball;
  int swapped = 0;
  for (int round = 0; round < 200; ++round) {
    const auto node = static_cast<std::int32_t>(random() % at(mesh.nodes()));
    if (!mesh.is_inside(node)) continue;
    NodePlace place = place_of(mesh, node);
    place.point = {place.point.x + share(random), place.point.y + share(random)};
    collect_ball(mesh.complex, node, ball);
    if (!sees_ball(mesh.complex, ball, place.point)) continue;
    move_node(mesh, node, place);
    for (const EdgeHandle corner : ball.corners) note_change(mesh, triangle_of(corner));
    swapped += static_cast<int>(swap_edges(mesh, SwapCriterion::energy, true));
    ASSERT_EQ(swap_edges(mesh, SwapCriterion::energy, false), 0) << round;
    ASSERT_THAT(validate(mesh), IsEmpty());
  }
  EXPECT_GT(swapped, 50);
}

}  // namespace
}  // namespace tetfarm
