#include "mesh/decompose/edge_path_smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/decompose/edge_loops.h"
#include "mesh/decompose/path_relaxation.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct ColouredSphere {
  Subdomain subdomain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 3));
  SurfaceTopology topology = make_surface_topology(subdomain);
  CutPlane plane = make_cut_plane(normalized(Vec3{1, 2, 3}), 0.1);
  FaceColours colours = colour_by_centroid(topology, plane);

  std::size_t path_length() const {
    std::size_t edges = 0;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(colours.size()); ++t) {
      if (colours[at(t)] == Side::left) {
        edges += static_cast<std::size_t>(edges_between_colours(colours, topology, t));
      }
    }
    return edges;
  }
};

TEST(FaceColouring, puts_triangles_below_the_plane_left) {
  const ColouredSphere sphere;
  for (std::size_t t = 0; t < sphere.colours.size(); ++t) {
    EXPECT_EQ(sphere.colours[t] == Side::left,
              sphere.plane.height(sphere.topology.centroid[t]) < 0);
  }
}

TEST(EdgePathSmoothing, leaves_no_triangle_with_two_edges_on_the_path) {
  ColouredSphere sphere;
  const std::size_t before = sphere.path_length();
  smooth_edge_path(sphere.colours, sphere.topology);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(sphere.colours.size()); ++t) {
    EXPECT_LT(edges_between_colours(sphere.colours, sphere.topology, t), 2);
  }
  EXPECT_LT(sphere.path_length(), before);
}

TEST(EdgePathSmoothing, drops_a_crumb) {
  ColouredSphere sphere;
  FaceColours& colours = sphere.colours;
  std::fill(colours.begin(), colours.end(), Side::left);
  colours[7] = Side::right;
  EXPECT_EQ(drop_crumbs(colours, sphere.topology), 1);
  EXPECT_EQ(std::count(colours.begin(), colours.end(), Side::right), 0);
}

TEST(EdgePathSmoothing, keeps_a_small_shell_that_is_whole) {
  const Subdomain nested = root_subdomain(
      shapes::between(shapes::sphere({0, 0, 0}, 1, 2), shapes::box({0, 0, 0}, {0.1, 0.1, 0.1}, 1)));
  const SurfaceTopology topology = make_surface_topology(nested);
  FaceColours colours(nested.triangles.size(), Side::left);
  std::fill(colours.end() - 12, colours.end(), Side::right);
  EXPECT_EQ(drop_crumbs(colours, topology), 0);
}

TEST(EdgePathSmoothing, opens_a_pinch) {
  ColouredSphere sphere;
  FaceColours& colours = sphere.colours;
  std::fill(colours.begin(), colours.end(), Side::left);
  const auto round = half_edges_round_start(sphere.topology, sphere.topology.vertex2half_edge[100]);
  ASSERT_EQ(round.size(), 6U);
  for (const std::size_t i : {0U, 2U, 3U}) colours[at(triangle_of(round[i]))] = Side::right;
  EXPECT_FALSE(
      find_edge_loops(colours, sphere.topology, sphere.subdomain.triangles).pinched_nodes.empty());
  EXPECT_GE(open_pinches(colours, sphere.topology, sphere.subdomain.triangles), 1);
  EXPECT_TRUE(
      find_edge_loops(colours, sphere.topology, sphere.subdomain.triangles).pinched_nodes.empty());
}

TEST(PathRelaxation, shortens_the_path_and_moves_only_triangles_at_the_plane) {
  ColouredSphere sphere;
  const FaceColours before = sphere.colours;
  const std::size_t length = sphere.path_length();
  relax_path(sphere.colours, sphere.subdomain, sphere.topology, sphere.plane);
  EXPECT_LT(sphere.path_length(), length);
  for (std::size_t t = 0; t < before.size(); ++t) {
    if (sphere.colours[t] == before[t]) continue;
    EXPECT_LT(std::fabs(sphere.plane.height(sphere.topology.centroid[t])),
              0.76 * sphere.topology.size[t]);
  }
}

TEST(EdgeLoops, one_round_a_sphere_two_across_a_torus_two_through_nested_spheres) {
  const auto loops_of = [](const SurfaceMesh& surface, const CutPlane& plane) {
    const Subdomain subdomain = root_subdomain(surface);
    const SurfaceTopology topology = make_surface_topology(subdomain);
    FaceColours colours = colour_by_centroid(topology, plane);
    tidy_path(colours, topology, subdomain.triangles);
    return find_edge_loops(colours, topology, subdomain.triangles).loops.size();
  };
  EXPECT_EQ(loops_of(shapes::sphere({0, 0, 0}, 1, 2), make_cut_plane({0, 0, 1}, 0.1)), 1U);
  EXPECT_EQ(loops_of(shapes::torus(0.3, 24, 10), make_cut_plane({1, 0, 0}, 0.03)), 2U);
  EXPECT_EQ(loops_of(shapes::nested_spheres(2), make_cut_plane({0, 1, 0}, 0.02)), 2U);
}

TEST(EdgeLoops, run_with_the_cut_on_their_left) {
  ColouredSphere sphere;
  tidy_path(sphere.colours, sphere.topology, sphere.subdomain.triangles);
  const EdgeLoops loops =
      find_edge_loops(sphere.colours, sphere.topology, sphere.subdomain.triangles);
  ASSERT_EQ(loops.loops.size(), 1U);
  double area = 0;
  const auto& loop = loops.loops.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    EXPECT_EQ(loop[i].to, loop[(i + 1) % loop.size()].from);
    const Vec2 a = sphere.plane.project(sphere.subdomain.vertices[at(loop[i].from)]);
    const Vec2 b = sphere.plane.project(sphere.subdomain.vertices[at(loop[i].to)]);
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  EXPECT_NEAR(area, 3.1, 0.2);  // of a disc of radius near 1, anticlockwise
}

}  // namespace
}  // namespace tetfarm
