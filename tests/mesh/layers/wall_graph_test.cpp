#include "mesh/layers/wall_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/array_index.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> all_triangles(const SurfaceMesh& surface) {
  std::vector<std::int32_t> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<Vec3> places_of(const SurfaceMesh& surface, const WallGraph& graph) {
  std::vector<Vec3> places;
  for (const std::int32_t v : graph.feet) places.push_back(surface.vertices[at(v)]);
  return places;
}

TEST(WallGraph, has_a_line_for_each_vertex_of_the_wall_and_tells_those_at_its_border) {
  const SurfaceMesh cube = shapes::unit_cube();
  const std::vector<std::int32_t> wall = {0, 1};
  const WallGraph graph = wall_graph(cube, wall);
  EXPECT_EQ(graph.feet.size(), 4U);
  for (std::size_t i = 0; i < graph.feet.size(); ++i) {
    EXPECT_EQ(graph.vertex2line[at(graph.feet[i])], static_cast<std::int32_t>(i));
    EXPECT_TRUE(graph.at_border[i]);
  }
  const WallGraph whole = wall_graph(cube, all_triangles(cube));
  EXPECT_EQ(whole.feet.size(), 8U);
  EXPECT_EQ(std::count(whole.at_border.begin(), whole.at_border.end(), true), 0);
}

TEST(WallGraph, neighbours_are_the_ends_of_edges_each_once) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const WallGraph graph = wall_graph(sphere, all_triangles(sphere));
  std::size_t ends = 0;
  for (std::int32_t i = 0; i < std::ssize(graph.feet); ++i) {
    const auto neighbours = graph.neighbours.of(i);
    EXPECT_TRUE(std::is_sorted(neighbours.begin(), neighbours.end()));
    EXPECT_EQ(graph.faces.of(i).size(), neighbours.size());  // round a node of a closed surface
    ends += neighbours.size();
  }
  EXPECT_EQ(ends, 3 * sphere.triangles.size());
}

TEST(WallGraph, limited_values_are_the_largest_that_rise_no_faster) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const WallGraph graph = wall_graph(sphere, all_triangles(sphere));
  const std::vector<Vec3> places = places_of(sphere, graph);
  std::vector<double> values(places.size(), 1);
  values[17] = 0.1;
  const std::vector<std::int32_t> sources = limit_slopes(graph, places, 0.25, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double most = 1;
    for (const std::int32_t n : graph.neighbours.of(static_cast<std::int32_t>(i))) {
      most = std::min(most, values[at(n)] + 0.25 * distance(places[i], places[at(n)]));
    }
    if (i != 17) {
      EXPECT_DOUBLE_EQ(values[i], most);
    }
    EXPECT_EQ(sources[i], values[i] < 1 ? 17 : static_cast<std::int32_t>(i));
  }
  EXPECT_EQ(values[17], 0.1);
}

TEST(WallGraph, the_smaller_step_of_two_neighbours_holds_between_them) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const WallGraph graph = wall_graph(sphere, all_triangles(sphere));
  std::vector<int> stops(graph.feet.size(), 50);
  stops[3] = 0;
  std::vector<int> most(stops.size(), 4);
  const std::int32_t slow = graph.neighbours.of(3).front();
  most[at(slow)] = 2;
  limit_steps(graph, most, stops);
  EXPECT_EQ(stops[at(slow)], 2);
  EXPECT_EQ(stops[at(graph.neighbours.of(3).back())], 4);
}

TEST(WallGraph, steps_between_neighbours_become_one) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 3);
  const WallGraph graph = wall_graph(sphere, all_triangles(sphere));
  std::vector<int> stops(graph.feet.size(), 20);
  stops[3] = 0;
  stops[100] = 5;
  const std::vector<std::int32_t> sources =
      limit_steps(graph, std::vector<int>(stops.size(), 1), stops);
  EXPECT_EQ(stops[3], 0);
  for (std::int32_t i = 0; i < std::ssize(stops); ++i) {
    int least = 20;
    for (const std::int32_t n : graph.neighbours.of(i)) least = std::min(least, stops[at(n)] + 1);
    if (i != 3 && i != 100) {
      EXPECT_EQ(stops[at(i)], least);
    }
    EXPECT_TRUE(sources[at(i)] == i || sources[at(i)] == 3 || sources[at(i)] == 100);
  }
}

/// Vertex 0 of a cube gets three lines: one of them, 2, with no triangle.
TEST(WallGraph, with_fans_has_several_lines_at_a_foot) {
  const SurfaceMesh cube = shapes::unit_cube();
  const WallGraph single = wall_graph(cube, all_triangles(cube));
  const std::int32_t moved = single.wall[at(single.faces.of(0)[1])];
  const Triangle& nodes = cube.triangles[at(moved)];
  const auto corner = static_cast<int>(std::find(nodes.begin(), nodes.end(), 0) - nodes.begin());
  const std::int32_t next = nodes[(at(corner) + 1) % 3];
  const std::vector<FanCorner> corners = {{moved, corner, 1}};
  const std::int32_t there = next + 2;  // two lines come before it
  const std::vector<FanPiece> pieces = {{{0, 2}, {there, there}, moved},
                                        {{2, 1}, {there, there}, moved}};
  const WallGraph graph = with_fans(single, {0, 0, 0, 1, 2, 3, 4, 5, 6, 7}, corners, pieces);
  EXPECT_EQ(graph.vertex2line[0], 0);
  EXPECT_EQ(graph.vertex2line[7], 9);
  EXPECT_EQ(graph.wall_lines[at(moved)][at(corner)], 1);
  EXPECT_EQ(graph.faces.of(0).size() + 1, single.faces.of(0).size());
  EXPECT_EQ(std::vector<std::int32_t>(graph.faces.of(1).begin(), graph.faces.of(1).end()),
            std::vector<std::int32_t>{moved});
  EXPECT_TRUE(graph.faces.of(2).empty());
  const auto of_middle = graph.neighbours.of(2);
  EXPECT_EQ(std::vector<std::int32_t>(of_middle.begin(), of_middle.end()),
            (std::vector<std::int32_t>{0, 1, there}));
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(graph.is_of_fan(i), i < 3);
}

TEST(WallGraph, lines_of_one_foot_stop_alike) {
  const SurfaceMesh cube = shapes::unit_cube();
  const WallGraph single = wall_graph(cube, all_triangles(cube));
  const std::vector<FanPiece> pieces = {{{0, 2}, {3, 3}, 0}, {{2, 1}, {3, 3}, 0}};
  const WallGraph graph = with_fans(single, {0, 0, 0, 1, 2, 3, 4, 5, 6, 7}, {}, pieces);
  std::vector<int> stops(10, 7);
  stops[1] = 4;
  limit_steps(graph, std::vector<int>(10, 2), stops);
  EXPECT_EQ(stops[0], 4);
  EXPECT_EQ(stops[2], 4);
  EXPECT_EQ(stops[3], 6);
}

}  // namespace
}  // namespace tetfarm
