#include "mesh/inspect/shell_orientation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "mesh/core/validate.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

ShellOrientation orient(const SurfaceMesh& mesh) {
  const std::vector<char> all(mesh.triangles.size(), 1);
  return orient_shells(mesh, edge_uses(mesh.triangles, all), all);
}

/// A closed band of n squares, twisted by half a turn when asked.
SurfaceMesh band(int n, bool is_twisted) {
  SurfaceMesh mesh;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    const double tilt = is_twisted ? angle / 2 : 0;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(tilt);
      mesh.vertices.push_back({r * std::cos(angle), r * std::sin(angle), s * std::sin(tilt)});
    }
  }
  for (int i = 0; i < n; ++i) {
    const std::int32_t a = 2 * i;
    const std::int32_t b = 2 * i + 1;
    std::int32_t c = (2 * i + 2) % (2 * n);
    std::int32_t d = (2 * i + 3) % (2 * n);
    if (is_twisted && i == n - 1) std::swap(c, d);
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({c, d, b});
  }
  return mesh;
}

TEST(ShellOrientation, turns_nothing_in_a_good_surface) {
  const auto result = orient(shapes::nested_spheres(1));
  EXPECT_EQ(result.shells.size(), 2U);
  EXPECT_THAT(result.turn, testing::Each(0));
  EXPECT_FALSE(result.defect);
}

TEST(ShellOrientation, makes_random_flips_agree_again) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    SurfaceMesh mesh = shapes::torus(0.4, 9, 7);
    for (Triangle& t : mesh.triangles) {
      if (below(random, 2) == 0) std::swap(t[0], t[1]);
    }
    const auto result = orient(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (result.turn[t] != 0) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    }
    EXPECT_THAT(unmatched_edges(mesh.triangles), testing::IsEmpty());
  }
}

TEST(ShellOrientation, finds_no_sides_on_a_moebius_strip) {
  EXPECT_FALSE(orient(band(12, false)).defect);
  const auto result = orient(band(12, true));
  ASSERT_TRUE(result.defect);
  EXPECT_EQ(result.defect->kind, "non-orientable shell");
  EXPECT_FALSE(result.defect->triangles.empty());
}

TEST(ShellOrientation, finds_no_sides_on_the_closed_projective_plane) {
  SurfaceMesh mesh;
  mesh.vertices.resize(6);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  const std::vector<char> all(mesh.triangles.size(), 1);
  ASSERT_FALSE(check_edges(mesh, edge_uses(mesh.triangles, all)));
  EXPECT_TRUE(orient(mesh).defect);
}

TEST(ShellOrientation, keeps_shells_apart_that_share_a_vertex) {
  const SurfaceMesh mesh =
      welded(joined(shapes::unit_cube(), shapes::box({1, 1, 1}, {2, 2, 2}, 1)));
  const auto result = orient(mesh);
  ASSERT_EQ(result.shells.size(), 2U);
  EXPECT_EQ(result.shells[1].front(), 12);
  EXPECT_EQ(result.triangle2shell[11], 0);
  EXPECT_EQ(result.triangle2shell[12], 1);
}

TEST(ShellOrientation, keeps_shells_apart_that_share_an_edge_of_more_than_two_triangles) {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const auto result = orient(mesh);
  EXPECT_THAT(result.triangle2shell, testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(result.turn, testing::Each(0));
  EXPECT_FALSE(result.defect);
}

}  // namespace
}  // namespace tetfarm
