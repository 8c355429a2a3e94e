#include "mesh/adaptation/adapt_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "mesh/adaptation/border_crossings.h"
#include "tests/mesh/adaptation/plane_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

template <class MetricAt>
PlaneMesh adapted(const PlaneMesh& mesh, const MetricAt& metric_at,
                  const AdaptationOptions& options = {}) {
  return adapt_mesh(mesh, plane_test::metrics_of(mesh, metric_at), options).mesh;
}

/// Valid, and at least this share of its edges has unit length.
template <class MetricAt>
void expect_unit_mesh(const PlaneMesh& mesh, const MetricAt& metric_at, double share = 0.99) {
  EXPECT_THAT(plane_test::whats_wrong(mesh), IsEmpty());
  EXPECT_GE(plane_test::share_of_unit_edges(mesh, metric_at), share);
}

void expect_whole_square(const PlaneMesh& mesh) {
  EXPECT_NEAR(plane_test::area(mesh), 1, 1e-12);
  const auto lengths = plane_test::patch_lengths(mesh);
  EXPECT_EQ(lengths.size(), 4U);
  for (std::int32_t side = 1; side <= 4; ++side) EXPECT_NEAR(lengths.at(side), 1, 1e-12) << side;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const Vec2& p = mesh.points[at(mesh.edges[k][0])];
    const Vec2& q = mesh.points[at(mesh.edges[k][1])];
    EXPECT_EQ(plane_test::side_of_square({(p.x + q.x) / 2, (p.y + q.y) / 2}), mesh.patches[k]);
  }
  std::set<std::pair<double, double>> corners;
  for (const std::int32_t v : mesh.corners) {
    corners.emplace(mesh.points[at(v)].x, mesh.points[at(v)].y);
  }
  EXPECT_EQ(corners, (std::set<std::pair<double, double>>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

/// The mean of |x| and of |y| over the edges.
Vec2 mean_edge(const PlaneMesh& mesh) {
  Vec2 sum;
  const auto edges = plane_test::edges_of(mesh);
  for (const auto& [a, b] : edges) {
    sum.x += std::abs(mesh.points[at(a)].x - mesh.points[at(b)].x);
    sum.y += std::abs(mesh.points[at(a)].y - mesh.points[at(b)].y);
  }
  return {sum.x / static_cast<double>(edges.size()), sum.y / static_cast<double>(edges.size())};
}

TEST(AdaptMesh, makes_an_even_mesh_of_a_size) {
  const auto metric = [](const Vec2&) { return plane_test::round_metric(0.1); };
  const PlaneMesh mesh = adapted(plane_test::square(3), metric);
  expect_unit_mesh(mesh, metric);
  expect_whole_square(mesh);
  // Equilateral triangles of side 0.1 have an area of 0.00433.
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 231, 25);
}

TEST(AdaptMesh, makes_stretched_triangles) {
  const auto metric = [](const Vec2&) { return metric_of_sizes({0.1, 0.001, 0}); };
  const PlaneMesh mesh = adapted(plane_test::square(4), metric);
  expect_unit_mesh(mesh, metric);
  expect_whole_square(mesh);
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 23100, 2500);
}

TEST(AdaptMesh, makes_the_discs_of_the_thesis) {
  // Figures 19, 21, 23, 24 and 25.
  const PlaneMesh disc = plane_test::disc(6);
  for (const Metric2& figure : {Metric2{1, 0, 1}, Metric2{1.9, 0, 1}, Metric2{10, 0, 1},
                                Metric2{1, 0, 10}, Metric2{1, 0.5, 1}}) {
    const auto metric = [&](const Vec2&) { return plane_test::scaled(figure, 0.1); };
    const PlaneMesh mesh = adapted(disc, metric);
    expect_unit_mesh(mesh, metric);
    EXPECT_NEAR(plane_test::area(mesh), std::numbers::pi, 0.02);
    EXPECT_NEAR(plane_test::patch_lengths(mesh).at(5), 2 * std::numbers::pi, 0.02);
    for (const auto& [a, b] : mesh.edges) {
      EXPECT_NEAR(std::hypot(mesh.points[at(a)].x, mesh.points[at(a)].y), 1, 1e-4);
      EXPECT_NE(a, b);
    }
    const double triangles =
        0.866 * 2.667 * std::numbers::pi * 100 * std::sqrt(determinant(figure));
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()) / triangles, 1, 0.12);
  }
}

TEST(AdaptMesh, follows_the_first_and_the_last_entry_of_the_metric) {
  const auto along = [](const Vec2&) { return Metric2{100, 0, 1000}; };
  const auto up = [](const Vec2&) { return Metric2{1000, 0, 100}; };
  const Vec2 wide = mean_edge(adapted(plane_test::disc(6), along));
  const Vec2 tall = mean_edge(adapted(plane_test::disc(6), up));
  EXPECT_NEAR(wide.x / wide.y, std::sqrt(10), 0.5);
  EXPECT_NEAR(tall.y / tall.x, std::sqrt(10), 0.5);
}

/// Thesis, figures 38 and 39: a ring of radius 0.5 in the square, short across it.
Metric2 ring_metric(const Vec2& p) {
  const double radius = std::hypot(p.x, p.y);
  const double off = std::abs(radius - 0.5);
  const double across = std::min(0.01 + 0.3 * off, 0.1);
  return metric_of_sizes({0.1, across, std::atan2(p.y, p.x) + std::numbers::pi / 2});
}

TEST(AdaptMesh, resolves_a_ring_in_a_square) {
  // The metric of the result's nodes comes from the background: a fine one here.
  const PlaneMesh mesh = adapted(plane_test::square(60), ring_metric);
  expect_unit_mesh(mesh, ring_metric, 0.98);
  expect_whole_square(mesh);
  double near_ring = 0;
  for (const Vec2& p : mesh.points) near_ring += std::abs(std::hypot(p.x, p.y) - 0.5) < 0.1 ? 1 : 0;
  EXPECT_GT(near_ring / static_cast<double>(mesh.points.size()), 0.39);
}

TEST(AdaptMesh, gives_the_same_result_twice) {
  const PlaneMesh square = plane_test::square(20);
  const auto metrics = plane_test::metrics_of(square, ring_metric);
  const AdaptationResult first = adapt_mesh(square, metrics);
  const AdaptationResult again = adapt_mesh(square, metrics);
  EXPECT_EQ(first.mesh.points, again.mesh.points);
  EXPECT_EQ(first.mesh.triangles, again.mesh.triangles);
  EXPECT_EQ(first.mesh.edges, again.mesh.edges);
  EXPECT_EQ(first.mesh.patches, again.mesh.patches);
  EXPECT_EQ(first.mesh.corners, again.mesh.corners);
  EXPECT_EQ(first.metrics, again.metrics);
}

TEST(AdaptMesh, leaves_its_own_result_nearly_as_it_is) {
  for (const bool is_ring : {false, true}) {
    const PlaneMesh square = plane_test::square(20);
    const auto metrics = is_ring
                             ? plane_test::metrics_of(square, ring_metric)
                             : plane_test::constant_metrics(square, plane_test::round_metric(0.05));
    const AdaptationResult first = adapt_mesh(square, metrics);
    const AdaptationResult second = adapt_mesh(first.mesh, first.metrics);
    const auto places = [](const PlaneMesh& mesh) {
      std::set<std::array<double, 4>> edges;
      for (const auto& [a, b] : plane_test::edges_of(mesh)) {
        std::array<double, 2> p{mesh.points[at(a)].x, mesh.points[at(a)].y};
        std::array<double, 2> q{mesh.points[at(b)].x, mesh.points[at(b)].y};
        if (q < p) std::swap(p, q);
        edges.insert({p[0], p[1], q[0], q[1]});
      }
      return edges;
    };
    const auto before = places(first.mesh);
    std::size_t changed = 0;
    for (const auto& edge : places(second.mesh)) changed += before.contains(edge) ? 0 : 1;
    EXPECT_LE(static_cast<double>(changed), 0.01 * static_cast<double>(before.size())) << is_ring;
  }
}

TEST(AdaptMesh, gives_each_node_the_metric_of_the_input_there) {
  const PlaneMesh square = plane_test::square(10);
  const auto metrics = plane_test::metrics_of(square, ring_metric);
  const AdaptationResult result = adapt_mesh(square, metrics);
  ASSERT_EQ(result.metrics.size(), result.mesh.points.size());
  const MetricField field = plane_test::field_of(square, metrics);
  std::int32_t home = 0;
  for (std::size_t v = 0; v < result.metrics.size(); ++v) {
    const Metric2 there = field.at(result.mesh.points[v], home);
    EXPECT_NEAR(result.metrics[v].xx / there.xx, 1, 1e-9);
    EXPECT_NEAR(result.metrics[v].yy / there.yy, 1, 1e-9);
  }
}

TEST(AdaptMesh, obeys_a_metric_ten_times_coarser_or_finer_at_once) {
  for (const double h : {1.0, 0.01}) {
    const auto metric = [&](const Vec2&) { return plane_test::round_metric(h); };
    const PlaneMesh mesh = adapted(plane_test::square(10), metric);
    // The coarse one has five edges, and its diagonal is sqrt(2) long.
    expect_unit_mesh(mesh, metric, h > 0.1 ? 0.8 : 0.99);
    expect_whole_square(mesh);
  }
}

TEST(AdaptMesh, keeps_the_edge_between_two_regions) {
  for (const double h : {0.5, 0.06}) {
    const auto metric = [&](const Vec2& p) { return metric_of_sizes({h, h / (1 + 2 * p.x), 0.6}); };
    const PlaneMesh mesh = adapted(plane_test::two_regions(8), metric);
    expect_unit_mesh(mesh, metric, 0.97);
    EXPECT_NEAR(plane_test::region_areas(mesh).at(1), 1, 1e-12);
    EXPECT_NEAR(plane_test::region_areas(mesh).at(2), 1, 1e-12);
    EXPECT_NEAR(plane_test::patch_lengths(mesh).at(0), 1, 1e-12);
    EXPECT_NEAR(plane_test::patch_lengths(mesh).at(7), 6, 1e-12);
    for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
      if (mesh.patches[k] != 0) continue;
      EXPECT_EQ(mesh.points[at(mesh.edges[k][0])].x, 1);
      EXPECT_EQ(mesh.points[at(mesh.edges[k][1])].x, 1);
    }
  }
}

TEST(AdaptMesh, keeps_a_reentrant_corner) {
  const auto metric = [](const Vec2& p) {
    return plane_test::round_metric(0.01 + 0.15 * std::hypot(p.x - 1, p.y - 1));
  };
  const PlaneMesh mesh = adapted(plane_test::ell(8), metric);
  expect_unit_mesh(mesh, metric, 0.98);
  EXPECT_NEAR(plane_test::area(mesh), 3, 1e-12);
  EXPECT_NEAR(plane_test::patch_lengths(mesh).at(1), 8, 1e-12);
  EXPECT_EQ(mesh.corners.size(), 6U);
  EXPECT_TRUE(std::any_of(mesh.corners.begin(), mesh.corners.end(), [&](std::int32_t v) {
    return mesh.points[at(v)] == Vec2{1, 1};
  }));
}

TEST(AdaptMesh, keeps_a_border_with_one_corner_on_its_curve) {
  PlaneMesh disc = plane_test::disc(5);
  disc.corners = {disc.edges[0][0]};
  const Vec2 corner = disc.points[at(disc.corners[0])];
  const auto metric = [](const Vec2&) { return plane_test::round_metric(0.08); };
  const PlaneMesh mesh = adapted(disc, metric);
  expect_unit_mesh(mesh, metric, 0.98);
  EXPECT_NEAR(plane_test::area(mesh), std::numbers::pi, 0.02);
  ASSERT_EQ(mesh.corners.size(), 1U);
  EXPECT_EQ(mesh.points[at(mesh.corners[0])], corner);
}

TEST(AdaptMesh, keeps_a_hole_that_is_far_smaller_than_the_size) {
  const auto metric = [](const Vec2&) { return plane_test::round_metric(0.5); };
  const PlaneMesh mesh = adapted(plane_test::square_with_hole(0.01, 4, 6), metric);
  EXPECT_THAT(plane_test::whats_wrong(mesh), IsEmpty());
  EXPECT_TRUE(plane_test::patch_lengths(mesh).contains(2));
  EXPECT_NEAR(plane_test::patch_lengths(mesh).at(1), 8, 1e-12);
}

TEST(AdaptMesh, goes_on_where_two_parts_meet_in_a_node) {
  PlaneMesh plane;
  plane.points = {{0, 0}, {1, 0}, {1, 1}, {-1, 0}, {-1, -1}};
  plane.triangles = {{0, 1, 2}, {0, 3, 4}};
  plane.regions = {0, 0};
  plane_test::add_border(plane, [](const Vec2&) { return 1; });
  const auto metric = [](const Vec2&) { return plane_test::round_metric(0.1); };
  const PlaneMesh mesh = adapted(plane, metric);
  expect_unit_mesh(mesh, metric, 0.97);
  EXPECT_NEAR(plane_test::area(mesh), 1, 1e-13);
}

TEST(AdaptMesh, by_every_test_and_the_restricted_cavity_gives_a_unit_mesh) {
  for (const EllipseTest test :
       {EllipseTest::at_new_node, EllipseTest::at_apex_too, EllipseTest::at_all_corners}) {
    for (const int rings : {1, 1000}) {
      AdaptationOptions options;
      options.cavity = {test, rings};
      const PlaneMesh mesh = adapted(plane_test::square(20), ring_metric, options);
      // Between the nodes of this background the metric is not quite ring_metric().
      expect_unit_mesh(mesh, ring_metric, 0.9);
      expect_whole_square(mesh);
    }
  }
}

TEST(AdaptMesh, ends_with_a_word_where_there_would_be_too_many_triangles) {
  AdaptationOptions options;
  options.max_triangles = 1000;
  const auto refusal_of_size = [&](double h) {
    return error_text_of<InvalidInput>([&] {
      adapted(
          plane_test::square(2), [&](const Vec2&) { return plane_test::round_metric(h); }, options);
    });
  };
  EXPECT_EQ(refusal_of_size(0.1), "");
  EXPECT_THAT(refusal_of_size(0.01), HasSubstr("triangles; the most that can be had are 1e+03"));
}

TEST(AdaptMesh, counts_the_triangles_of_the_result_against_their_limit) {
  AdaptationOptions options;
  options.max_triangles = 1000;
  const PlaneMesh mesh = adapted(
      plane_test::square(40), [](const Vec2&) { return plane_test::round_metric(0.07); }, options);
  EXPECT_LT(mesh.triangles.size(), 700U);
  expect_whole_square(mesh);
}

TEST(AdaptMesh, ends_with_a_word_at_once_where_the_border_alone_would_have_too_many_nodes) {
  AdaptationOptions options;
  options.max_triangles = 1000;
  EXPECT_THAT(error_text_of<InvalidInput>([&] {
                adapted(
                    plane_test::square(2),
                    [](const Vec2&) { return plane_test::round_metric(2e-4); }, options);
              }),
              HasSubstr("triangles; the most that can be had are 1e+03"));
}

TEST(AdaptMesh, keeps_the_walls_of_a_narrow_gap_apart) {
  const PlaneMesh plane = plane_test::disc_in_a_narrow_gap();
  ASSERT_EQ(plane_test::border_crossings(plane), 0);
  EXPECT_FALSE(find_border_crossing(plane).has_value());
  // The sizes ask for edges that would reach across.
  const PlaneMesh mesh = adapted(plane, [](const Vec2& p) {
    return plane_test::round_metric(std::hypot(p.x, p.y) < 1.01 ? 0.1 : 1.2);
  });
  EXPECT_EQ(plane_test::border_crossings(mesh), 0);
  EXPECT_THAT(plane_test::whats_wrong(mesh), IsEmpty());
  EXPECT_LT(mesh.triangles.size(), plane.triangles.size());
}

TEST(AdaptMesh, refuses_what_is_no_mesh_or_no_metric) {
  const PlaneMesh square = plane_test::square(2);
  EXPECT_THAT(error_text_of<InvalidInput>([&] { adapt_mesh(square, std::vector<Metric2>(3)); }),
              HasSubstr("3 metrics for 9 nodes"));
  EXPECT_THAT(error_text_of<InvalidInput>([&] {
                adapted(square, [](const Vec2&) { return Metric2{1, 2, 1}; });
              }),
              HasSubstr("not positive definite"));
  EXPECT_THAT(error_text_of<InvalidInput>([&] { adapt_mesh({}, {}); }), HasSubstr("no triangles"));
}

TEST(AdaptMesh, survives_hostile_metrics) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> share(0, 1);
  AdaptationOptions options;
  options.max_triangles = 1500;
  options.sweeps = 1;
  int meshes = 0;
  for (int round = 0; round < 200; ++round) {
    const PlaneMesh square = plane_test::square(2 + round % 3);
    const double steepest = 6 * share(random);
    const auto metric = [&](const Vec2&) {
      const double size = std::pow(10, -share(random));
      const double half_aspect = std::pow(10, steepest * share(random) / 2);
      return metric_of_sizes({size * half_aspect, size / half_aspect, 4 * share(random)});
    };
    try {
      const PlaneMesh mesh = adapted(square, metric, options);
      ++meshes;
      ASSERT_THAT(plane_test::whats_wrong(mesh), IsEmpty()) << round;
      ASSERT_NEAR(plane_test::area(mesh), 1, 1e-12) << round;
      ASSERT_EQ(mesh.corners.size(), 4U) << round;
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), HasSubstr("triangles"));
    }
  }
  EXPECT_GE(meshes, 100);
}

}  // namespace
}  // namespace tetfarm
