#include "mesh/inspect/outer_boundary.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "base/error.h"
#include "mesh/inspect/surface_check.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using Kind = OuterBoundary::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const SurfaceMesh body = shapes::box({1, 2, 3}, {5, 4, 4}, 3);

/// The report of body plus boundary, which must need no repair.
SurfaceReport report_of(const SurfaceMesh& mesh) {
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(checked.report.remarks, IsEmpty());
  EXPECT_EQ(checked.surface.triangles, mesh.triangles);
  return checked.report;
}

TEST(OuterBoundary, of_kind_none_changes_nothing) {
  EXPECT_EQ(add_outer_boundary(body, {}, 0.3).triangles, body.triangles);
}

TEST(OuterBoundary, is_a_cube_as_large_as_asked) {
  const SurfaceMesh mesh = add_outer_boundary(body, {Kind::box, 5, 0}, 0.3);
  const Box3 box = bounding_box(mesh.vertices);
  EXPECT_EQ(box.low, (Vec3{-7, -7, -6.5}));
  EXPECT_EQ(box.high, (Vec3{13, 13, 13.5}));
  const SurfaceReport report = report_of(mesh);
  EXPECT_EQ(report.shells.size(), 2U);
  EXPECT_EQ(report.shells[0].depth, 1);
  EXPECT_NEAR(report.volume, 8000 - 8, 1e-8);
}

TEST(OuterBoundary, is_a_sphere_as_large_as_asked) {
  const SurfaceMesh mesh = add_outer_boundary(body, {Kind::sphere, 4, 0.5}, 0.3);
  const double radius = 4 * 0.5 * std::sqrt(16.0 + 4 + 1);
  const double volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius - 8;
  EXPECT_NEAR(report_of(mesh).volume, volume, 0.01 * volume);
}

TEST(OuterBoundary, has_a_patch_of_its_own_behind_those_of_the_body) {
  SurfaceMesh two = body;
  two.patch_names = {"wing", "tail"};
  two.patch_of_triangle[3] = 1;
  const SurfaceMesh mesh = add_outer_boundary(two, {Kind::sphere, 3, 0}, 0.3);
  EXPECT_THAT(mesh.patch_names, ElementsAre("wing", "tail", "outer_sphere"));
  ASSERT_EQ(mesh.patch_of_triangle.size(), mesh.triangles.size());
  EXPECT_EQ(mesh.patch_of_triangle[3], 1);
  EXPECT_EQ(mesh.patch_of_triangle[two.triangles.size()], 2);
  two.patch_of_triangle.clear();
  two.patch_names.clear();
  EXPECT_THAT(add_outer_boundary(two, {Kind::box, 3, 0}, 0.3).patch_names,
              ElementsAre("surface", "outer_box"));
}

TEST(OuterBoundary, follows_the_spacing_asked_for) {
  for (const Kind kind : {Kind::box, Kind::sphere}) {
    const SurfaceMesh mesh = add_outer_boundary(body, {kind, 4, 1.0}, 0.3);
    SurfaceMesh outer = mesh;
    outer.triangles.erase(
        outer.triangles.begin(),
        outer.triangles.begin() + static_cast<std::ptrdiff_t>(body.triangles.size()));
    const SurfaceReport report = check_surface(outer).report;
    EXPECT_NEAR(report.median_edge, 1.0, 0.2);
  }
}

TEST(OuterBoundary, is_coarser_by_itself_with_growth_but_never_too_coarse) {
  const auto triangles = [](double factor, double growth) {
    return add_outer_boundary(body, {Kind::box, factor, 0}, growth).triangles.size() -
           body.triangles.size();
  };
  EXPECT_GT(triangles(5, 0.1), triangles(5, 0.2));
  EXPECT_EQ(triangles(5, 10), 12U * 36U);
  EXPECT_LE(triangles(500, 0), 200'000U);
  EXPECT_GT(triangles(500, 0), 150'000U);
}

double longest_edge(const SurfaceMesh& mesh, const std::string& patch) {
  double longest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.patch_names[static_cast<std::size_t>(mesh.patch_of_triangle[t])] != patch) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::pair{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]};
      longest = std::max(longest, distance(mesh.vertices[static_cast<std::size_t>(a)],
                                           mesh.vertices[static_cast<std::size_t>(b)]));
    }
  }
  return longest;
}

TEST(OuterBoundary, is_no_coarser_than_the_job_asks_for_everywhere) {
  OuterBoundary outer{Kind::box, 1.3, 0};
  const double by_itself = longest_edge(add_outer_boundary(body, outer, 0.3), "outer_box");
  for (const double size : {0.04, 0.2, 0.5}) {
    outer.default_spacing = size;
    // A square's diagonal is the longest edge of its two triangles.
    EXPECT_LE(longest_edge(add_outer_boundary(body, outer, 0.3), "outer_box"), 1.4143 * size);
  }
  outer.default_spacing = 100;
  EXPECT_EQ(longest_edge(add_outer_boundary(body, outer, 0.3), "outer_box"), by_itself);
  outer.default_spacing = 0.2;
  outer.spacing = 0.9;
  EXPECT_GT(longest_edge(add_outer_boundary(body, outer, 0.3), "outer_box"), 0.9)
      << "a size of its own wins";
}

TEST(OuterBoundary, is_sketched_with_few_triangles_whatever_is_asked_for) {
  for (const Kind kind : {Kind::box, Kind::sphere}) {
    OuterBoundary outer{kind, 2, 0};
    outer.default_spacing = 1e-9;
    outer.is_sketch = true;
    EXPECT_LE(add_outer_boundary(body, outer, 0.3).triangles.size(),
              few_triangles + static_cast<double>(body.triangles.size()));
    outer.is_sketch = false;
    EXPECT_THROW(add_outer_boundary(body, outer, 0.3), UsageError);
  }
}

TEST(OuterBoundary, refuses_what_would_touch_the_body) {
  for (const double factor : {0.0, -3.0, 0.9, 1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
    for (const Kind kind : {Kind::box, Kind::sphere}) {
      EXPECT_THROW(add_outer_boundary(body, {kind, factor, 0}, 0.3), UsageError) << factor;
    }
  }
  EXPECT_THROW(add_outer_boundary(body, {Kind::sphere, 1.01, 4}, 0.3), UsageError)
      << "the triangles of the sphere cut through the body";
  EXPECT_NO_THROW(add_outer_boundary(body, {Kind::box, 1.01, 0}, 0.3));
}

TEST(OuterBoundary, refuses_numbers_without_sense_and_says_which) {
  const auto message = [](const OuterBoundary& outer, double growth) -> std::string {
    try {
      add_outer_boundary(body, outer, growth);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message({Kind::box, 0.5, 0}, 0.3), HasSubstr("domain.factor: "));
  EXPECT_THAT(message({Kind::box, 5, -1}, 0.3), HasSubstr("domain.spacing: "));
  EXPECT_THAT(message({Kind::box, 5, 1e-9}, 0.3), HasSubstr("more than 10000000 triangles"));
  EXPECT_THAT(message({Kind::box, 5, 0}, -0.1), HasSubstr("growth"));
  EXPECT_THROW(add_outer_boundary({}, {Kind::box, 5, 0}, 0.3), UsageError);
}

TEST(OuterBoundary, has_the_same_bits_every_time) {
  for (const Kind kind : {Kind::box, Kind::sphere}) {
    EXPECT_EQ(add_outer_boundary(body, {kind, 3, 0.7}, 0.3).vertices,
              add_outer_boundary(body, {kind, 3, 0.7}, 0.3).vertices);
  }
}

}  // namespace
}  // namespace tetfarm
