#include "mesh/layers/line_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/array_index.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

WallGraph graph_of(const SurfaceMesh& surface) {
  std::vector<std::int32_t> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return wall_graph(surface, all);
}

TEST(LineRoom, free_way_is_a_share_of_the_distance_to_what_is_opposite) {
  const SurfaceMesh slab = shapes::box({0, 0, 0}, {1, 1, 0.5}, 4);
  const WallGraph graph = graph_of(slab);
  std::vector<Vec3> along;
  for (const std::int32_t v : graph.feet) {
    const Vec3 p = slab.vertices[at(v)];
    const bool is_below = p.z == 0 && p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1;
    along.push_back(is_below ? Vec3{0, 0, 2} : Vec3{});
  }
  const std::vector<double> wanted(along.size(), 3);
  const std::vector<double> ways = free_ways(slab, graph, wall_planes(slab, graph), along, wanted);
  int looked = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    // A height of 0.25 takes it all across, as its lines are twice as long as they are high.
    EXPECT_NEAR(ways[i], along[i] == Vec3{} ? 3 : 0.1, 1e-15);
    looked += along[i] == Vec3{} ? 0 : 1;
  }
  EXPECT_EQ(looked, 9);
}

/// The floor of a slab is one square; a line in the middle of the lid sees it, and those of
/// the floor, which go down here, see nothing.
TEST(LineRoom, the_lines_of_a_large_triangle_have_no_more_than_one_that_comes_down_on_it) {
  const SurfaceMesh slab = shapes::box({0, 0, 0}, {4, 4, 0.5}, 2);
  const WallGraph graph = graph_of(slab);
  std::vector<Vec3> along;
  for (const std::int32_t v : graph.feet) {
    const Vec3 p = slab.vertices[at(v)];
    const bool is_lid = p == Vec3{2, 2, 0.5};
    const bool is_floor = p.z == 0;
    along.push_back(is_lid ? Vec3{0.1, 0.2, -1} : is_floor ? Vec3{-1, -1, -1} : Vec3{});
  }
  const std::vector<double> wanted(along.size(), 3);
  const std::vector<double> ways = free_ways(slab, graph, wall_planes(slab, graph), along, wanted);
  int held = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    EXPECT_EQ(along[i] == Vec3{} ? 3 : ways[i], ways[i]) << "one that does not move";
    const bool is_floor = slab.vertices[at(graph.feet[i])].z == 0;
    if (!is_floor || ways[i] == 3) continue;
    ++held;
    EXPECT_NEAR(ways[i], 0.2, 1e-12);
  }
  EXPECT_EQ(held, 3);
}

/// Two blocks on a floor, of the same height: a line on the edge of one goes level to the other.
TEST(LineRoom, free_way_in_the_plane_of_what_is_opposite_ends_at_its_edge) {
  const SurfaceMesh lid = shapes::box({0, 0, 0}, {1, 1, 1}, 1);
  SurfaceMesh two = lid;
  for (const Vec3& p : lid.vertices) two.vertices.push_back({p.x + 3, p.y, p.z});
  for (const auto& [a, b, c] : lid.triangles) two.triangles.push_back({a + 8, b + 8, c + 8});
  const WallGraph graph = graph_of(two);
  std::vector<Vec3> along(graph.feet.size());
  const auto foot = static_cast<std::size_t>(
      std::find(two.vertices.begin(), two.vertices.end(), Vec3{1, 0, 1}) - two.vertices.begin());
  along.at(foot) = {1, 0.25, 0};
  const std::vector<double> wanted(along.size(), 4);
  const std::vector<double> ways = free_ways(two, graph, wall_planes(two, graph), along, wanted);
  EXPECT_NEAR(ways[foot], 0.8, 0.1) << "a share of 2, not 0";
}

TEST(LineRoom, free_way_is_not_less_than_wanted_where_nothing_is_near) {
  const SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  const WallGraph graph = graph_of(cube);
  std::vector<Vec3> along;
  for (const std::int32_t v : graph.feet) {
    along.push_back(normalized(Vec3{0.5, 0.5, 0.5} - cube.vertices[at(v)]));
  }
  const std::vector<double> wanted(along.size(), 0.1);
  EXPECT_EQ(free_ways(cube, graph, wall_planes(cube, graph), along, wanted), wanted);
}

/// Lines to the centre of a sphere leave so much of the area at a height h: (1 - h)².
TEST(LineRoom, cells_fold_where_their_jacobian_is_a_share_of_that_at_the_wall) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 3);
  const WallGraph graph = graph_of(sphere);
  std::vector<Vec3> along;
  for (const std::int32_t v : graph.feet) along.push_back(-sphere.vertices[at(v)]);
  const std::vector<double> wanted(along.size(), 10);
  for (const double height : fold_heights(sphere, graph, along, wanted)) {
    EXPECT_NEAR((1 - height) * (1 - height), least_jacobian, 1e-9);
  }
}

TEST(LineRoom, lines_that_part_never_fold) {
  const SurfaceMesh spheres =
      shapes::between(shapes::sphere({0, 0, 0}, 3, 1), shapes::sphere({0, 0, 0}, 1, 3));
  const WallGraph graph = graph_of(spheres);
  std::vector<Vec3> along;
  for (const std::int32_t v : graph.feet) {
    const Vec3 p = spheres.vertices[at(v)];
    along.push_back(norm(p) > 2 ? Vec3{} : p);
  }
  const std::vector<double> wanted(along.size(), 0.7);
  EXPECT_EQ(fold_heights(spheres, graph, along, wanted), wanted);
}

}  // namespace
}  // namespace tetfarm
