#include "mesh/planar/planar_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/mesh/planar/regions.h"

namespace tetfarm {
namespace {

using planar_test::add_loop;
using planar_test::circle_loop;
using planar_test::rectangle;
using planar_test::whats_wrong;
using ::testing::IsEmpty;

PlanarSpacing uniform(double h) {
  return [h](const Vec2&) { return h; };
}

double distance(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

struct Shape {
  double radius_ratio;
  double least_angle_deg;
};

Shape shape(const PlanarMesh& mesh, const std::array<std::int32_t, 3>& nodes) {
  const auto at = [&](std::size_t i) {
    return mesh.points[static_cast<std::size_t>(nodes[i % 3])];
  };
  std::array<double, 3> side{distance(at(1), at(2)), distance(at(2), at(0)),
                             distance(at(0), at(1))};
  std::ranges::sort(side);
  const auto [a, b, c] = side;
  const double cosine = (b * b + c * c - a * a) / (2 * b * c);
  return {(b + c - a) * (a + c - b) * (a + b - c) / (a * b * c),
          std::acos(cosine) * 180 / std::numbers::pi};
}

double mean_radius_ratio(const PlanarMesh& mesh) {
  double sum = 0;
  for (const auto& nodes : mesh.triangles) sum += shape(mesh, nodes).radius_ratio;
  return sum / static_cast<double>(mesh.triangles.size());
}

/// The least angle of the triangles without a point of the region.
double least_inner_angle(const PlanarMesh& mesh, const PlanarRegion& region) {
  double least = 180;
  const auto first_inner = static_cast<std::int32_t>(region.points.size());
  for (const auto& nodes : mesh.triangles)
    if (std::ranges::all_of(nodes, [&](std::int32_t v) { return v >= first_inner; }))
      least = std::min(least, shape(mesh, nodes).least_angle_deg);
  return least;
}

/// A square with a round hole of its own spacing: grows by 0.2 per unit length.
PlanarRegion graded_region() {
  PlanarRegion region = rectangle({-10, -10}, {10, 10}, 10);
  add_loop(region, circle_loop({0, 0}, -0.3, 60));
  return region;
}
double graded_spacing(const Vec2& p) {
  return std::min(2.0, 0.0314 + 0.2 * std::max(0.0, distance(p, {0, 0}) - 0.3));
}

TEST(PlanarMesh, is_right_in_regions_of_every_kind) {
  std::vector<std::pair<PlanarRegion, double>> cases;
  for (const int n : {1, 2, 5, 10, 40}) cases.emplace_back(rectangle({0, 0}, {1, 1}, n), 1.0 / n);
  PlanarRegion hole = rectangle({-1, -1}, {1, 1}, 10);
  add_loop(hole, circle_loop({0, 0}, -0.4, 14));
  cases.emplace_back(hole, 0.2);
  PlanarRegion annulus;
  add_loop(annulus, circle_loop({0, 0}, 1, 400));
  add_loop(annulus, circle_loop({0, 0}, -0.97, 400));
  cases.emplace_back(annulus, 0.0155);
  PlanarRegion island;
  add_loop(island, circle_loop({0, 0}, 3, 90));
  add_loop(island, circle_loop({0, 0}, -2, 60));
  add_loop(island, circle_loop({0.3, 0.2}, 1, 30));
  cases.emplace_back(island, 0.2);
  PlanarRegion disc;
  add_loop(disc, circle_loop({0, 0}, 1, 1000));
  cases.emplace_back(disc, 0.05);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    SCOPED_TRACE(k);
    const auto& [region, h] = cases[k];
    const PlanarResult result = mesh_region(region, uniform(h));
    ASSERT_FALSE(result.failure) << result.failure->reason;
    EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
  }
}

TEST(PlanarMesh, is_right_in_random_stars_of_any_spacing) {
  std::mt19937 random(11);
  const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    PlanarRegion region;
    std::vector<Vec2> loop = circle_loop({0, 0}, 1, 4 + round);
    for (Vec2& p : loop) {
      const double stretch = 0.1 + fraction();
      p = {p.x * stretch, p.y * stretch};
    }
    add_loop(region, loop);
    const PlanarResult result = mesh_region(region, uniform(0.03 + 0.3 * fraction()));
    ASSERT_FALSE(result.failure) << result.failure->reason;
    EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
  }
}

/// The union of random cells of a grid: right angles, collinear points, and loops that touch.
PlanarRegion random_cells(int n, std::mt19937& random) {
  const auto size = static_cast<std::size_t>(n) + 2;
  std::vector<std::vector<bool>> is_full(size, std::vector<bool>(size, false));
  for (std::size_t i = 1; i + 1 < size; ++i)
    for (std::size_t j = 1; j + 1 < size; ++j) is_full[i][j] = random() % 5 < 3;
  PlanarRegion region;
  std::map<std::pair<std::size_t, std::size_t>, std::int32_t> numbers;
  const auto number = [&](std::size_t i, std::size_t j) {
    const auto [at, is_new] =
        numbers.try_emplace({i, j}, static_cast<std::int32_t>(region.points.size()));
    if (is_new)
      region.points.push_back({0.1 * static_cast<double>(i), 0.1 * static_cast<double>(j)});
    return at->second;
  };
  for (std::size_t i = 1; i + 1 < size; ++i)
    for (std::size_t j = 1; j + 1 < size; ++j) {
      if (!is_full[i][j]) continue;
      if (!is_full[i][j - 1]) region.edges.push_back({number(i, j), number(i + 1, j)});
      if (!is_full[i + 1][j]) region.edges.push_back({number(i + 1, j), number(i + 1, j + 1)});
      if (!is_full[i][j + 1]) region.edges.push_back({number(i + 1, j + 1), number(i, j + 1)});
      if (!is_full[i - 1][j]) region.edges.push_back({number(i, j + 1), number(i, j)});
    }
  return region;
}

/// The inner edges that join the given pairs.
int count_chords(const PlanarMesh& mesh, const PlanarRegion& region, const PlanarOptions& options) {
  std::set<std::array<std::int32_t, 2>> chords;
  for (const auto& [a, b] : options.forbidden_chords) chords.insert({{a, b}, {b, a}});
  for (const auto& [a, b] : region.edges) {
    chords.erase({a, b});
    chords.erase({b, a});
  }
  int found = 0;
  for (const auto& nodes : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (chords.contains({nodes[i], nodes[(i + 1) % 3]})) ++found;
  return found;
}

TEST(PlanarMesh, is_right_in_unions_of_grid_cells_with_forbidden_chords) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const PlanarRegion region = random_cells(2 + round % 9, random);
    if (region.edges.empty()) continue;
    PlanarOptions options;
    const auto n = static_cast<std::uint32_t>(region.points.size());
    for (std::uint32_t k = 0; k < 4 * n; ++k)
      options.forbidden_chords.push_back(
          {static_cast<std::int32_t>(random() % n), static_cast<std::int32_t>(random() % n)});
    const double h = 0.03 * static_cast<double>(1 + random() % 5);
    const PlanarResult result = mesh_region(region, uniform(h), options);
    ASSERT_FALSE(result.failure) << result.failure->reason;
    EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
    EXPECT_EQ(count_chords(result.mesh, region, options), 0);
  }
}

TEST(PlanarMesh, has_good_triangles_for_a_uniform_spacing) {
  PlanarRegion disc;
  add_loop(disc, circle_loop({0, 0}, 1, 126));
  for (const PlanarRegion& region : {disc, rectangle({0, 0}, {1, 1}, 20)}) {
    const PlanarMesh mesh = mesh_region(region, uniform(0.05)).mesh;
    EXPECT_GT(mean_radius_ratio(mesh), 0.95);
    EXPECT_GT(least_inner_angle(mesh, region), 30);
  }
}

TEST(PlanarMesh, has_good_triangles_for_a_graded_spacing) {
  const PlanarRegion region = graded_region();
  const PlanarMesh mesh = mesh_region(region, graded_spacing).mesh;
  EXPECT_THAT(whats_wrong(region, mesh), IsEmpty());
  EXPECT_GT(mean_radius_ratio(mesh), 0.93);
  EXPECT_GT(least_inner_angle(mesh, region), 30);
}

TEST(PlanarMesh, has_edges_as_long_as_the_spacing) {
  const PlanarRegion region = graded_region();
  const PlanarMesh mesh = mesh_region(region, graded_spacing).mesh;
  double sum = 0;
  for (const auto& nodes : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& a = mesh.points[static_cast<std::size_t>(nodes[i])];
      const Vec2& b = mesh.points[static_cast<std::size_t>(nodes[(i + 1) % 3])];
      const double ratio = distance(a, b) / graded_spacing({(a.x + b.x) / 2, (a.y + b.y) / 2});
      EXPECT_GT(ratio, 0.4);
      EXPECT_LT(ratio, 2);
      sum += ratio;
    }
  EXPECT_NEAR(sum / (3 * static_cast<double>(mesh.triangles.size())), 1, 0.15);
}

TEST(PlanarMesh, is_the_same_at_every_scale_by_a_power_of_two) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 8);
  const PlanarMesh first = mesh_region(region, uniform(0.125)).mesh;
  for (Vec2& p : region.points) p = {p.x * 1048576, p.y * 1048576};
  const PlanarMesh large = mesh_region(region, uniform(0.125 * 1048576)).mesh;
  EXPECT_EQ(large.triangles, first.triangles);
}

TEST(PlanarMesh, works_tiny_huge_and_far_away) {
  struct Place {
    double scale, shift;
  };
  for (const auto& [scale, shift] :
       {Place{1e-6, 0}, Place{1e6, 0}, Place{1, 1e6}, Place{1e-3, 1e6}, Place{1e6, -1e6}}) {
    PlanarRegion region = rectangle({0, 0}, {1, 1}, 8);
    add_loop(region, circle_loop({0.5, 0.5}, -0.2, 10));
    for (Vec2& p : region.points) p = {p.x * scale + shift, p.y * scale - shift};
    const PlanarResult result = mesh_region(region, uniform(0.125 * scale));
    SCOPED_TRACE(scale);
    ASSERT_FALSE(result.failure) << result.failure->reason;
    EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
    EXPECT_GT(mean_radius_ratio(result.mesh), 0.9);
  }
}

TEST(PlanarMesh, is_the_same_twice_and_for_any_order_of_the_edges) {
  PlanarRegion region = graded_region();
  const PlanarMesh first = mesh_region(region, graded_spacing).mesh;
  std::mt19937 random(3);
  for (int round = 0; round < 3; ++round) {
    const PlanarMesh again = mesh_region(region, graded_spacing).mesh;
    EXPECT_EQ(again.points, first.points);
    EXPECT_EQ(again.triangles, first.triangles);
    std::shuffle(region.edges.begin(), region.edges.end(), random);
  }
}

TEST(PlanarMesh, lets_two_loops_touch_in_a_vertex) {
  PlanarRegion region;
  region.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  region.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 6}, {6, 2}};
  const PlanarResult result = mesh_region(region, uniform(0.2));
  ASSERT_FALSE(result.failure);
  EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
}

TEST(PlanarMesh, keeps_given_inner_points_where_they_are) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 4);
  region.points.push_back({0.41, 0.52});
  const PlanarMesh mesh = mesh_region(region, uniform(0.25)).mesh;
  EXPECT_THAT(whats_wrong(region, mesh), IsEmpty());
  const bool is_used = std::ranges::any_of(
      mesh.triangles, [](const auto& nodes) { return std::ranges::count(nodes, 16) > 0; });
  EXPECT_TRUE(is_used);
}

TEST(PlanarMesh, splits_forbidden_chords) {
  const PlanarRegion region = rectangle({0, 0}, {1, 1}, 1);
  ASSERT_EQ(mesh_region(region, uniform(9)).mesh.triangles.size(), 2U);
  const PlanarMesh split =
      mesh_region(region, uniform(9), {.forbidden_chords = {{0, 2}, {3, 1}}}).mesh;
  EXPECT_THAT(whats_wrong(region, split), IsEmpty());
  EXPECT_EQ(split.points.size(), 5U);
  EXPECT_EQ(split.triangles.size(), 4U);
}

TEST(PlanarMesh, splits_all_chords_of_a_strip_when_all_are_forbidden) {
  PlanarRegion region;
  std::vector<Vec2> loop;
  for (int i = 0; i <= 30; ++i) loop.push_back({static_cast<double>(i), 0});
  for (int i = 30; i >= 0; --i) loop.push_back({static_cast<double>(i), 1});
  add_loop(region, loop);
  PlanarOptions options;
  const auto n = static_cast<std::int32_t>(loop.size());
  for (std::int32_t a = 0; a < n; ++a)
    for (std::int32_t b = 0; b < a; ++b) options.forbidden_chords.push_back({a, b});
  const PlanarMesh mesh = mesh_region(region, uniform(1), options).mesh;
  EXPECT_THAT(whats_wrong(region, mesh), IsEmpty());
  EXPECT_EQ(count_chords(mesh, region, options), 0);
}

TEST(PlanarMesh, keeps_forbidden_chords_out_of_stars_after_smoothing_too) {
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    std::vector<Vec2> loop = circle_loop({0, 0}, 1, 8 + round);
    for (Vec2& p : loop) {
      const double stretch = 0.02 + static_cast<double>(random()) / 4294967296.0;
      p = {p.x * stretch, p.y * stretch};
    }
    PlanarRegion region;
    add_loop(region, loop);
    PlanarOptions options;
    for (std::int32_t a = 0; a < 8 + round; ++a)
      for (std::int32_t b = 0; b < a; ++b) options.forbidden_chords.push_back({a, b});
    const PlanarResult result = mesh_region(region, uniform(0.05 * (1 + round % 6)), options);
    ASSERT_FALSE(result.failure) << result.failure->reason;
    EXPECT_THAT(whats_wrong(region, result.mesh), IsEmpty());
    EXPECT_EQ(count_chords(result.mesh, region, options), 0);
  }
}

TEST(PlanarMesh, passes_on_what_is_wrong_with_the_region) {
  PlanarRegion region = rectangle({0, 0}, {1, 1}, 2);
  region.edges.pop_back();
  PlanarResult result = mesh_region(region, uniform(0.5));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->reason, "a loop does not close");
  EXPECT_THAT(result.failure->where, ::testing::UnorderedElementsAre(Vec2{0, 0}, Vec2{0, 0.5}));

  region = {};
  add_loop(region, {{0, 0}, {2, 0}, {0, 2}, {2, 2}});
  result = mesh_region(region, uniform(0.5));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->reason, "two edges cross");
  EXPECT_THAT(result.failure->where, ::testing::ElementsAre(Vec2{1, 1}));
}

TEST(PlanarMesh, refuses_a_spacing_that_asks_for_too_many_triangles) {
  const PlanarResult result = mesh_region(rectangle({0, 0}, {1, 1}, 1), uniform(1e-6));
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->reason, "the spacing asks for too many triangles");
}

TEST(PlanarMesh, refuses_a_spacing_that_is_not_positive) {
  for (const double h : {0.0, -1.0, HUGE_VAL}) {
    const PlanarResult result = mesh_region(rectangle({0, 0}, {1, 1}, 1), uniform(h));
    ASSERT_TRUE(result.failure);
    EXPECT_EQ(result.failure->reason, "the spacing is not positive and finite");
  }
}

}  // namespace
}  // namespace tetfarm
