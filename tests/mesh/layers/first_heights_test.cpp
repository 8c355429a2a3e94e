#include "mesh/layers/first_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/array_index.h"
#include "mesh/layers/marching_direction.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// The whole of a surface as the wall, or a patch of it, and lines that are high enough above all
/// faces.
struct LevelGround {
  SurfaceMesh surface;
  WallGraph graph;
  WallPlanes planes;
  std::vector<Vec3> normals;
  std::vector<Vec3> places;
  std::vector<Vec3> along;

  explicit LevelGround(SurfaceMesh made, std::vector<std::int32_t> wall)
      : surface(std::move(made)),
        graph(wall_graph(surface, wall)),
        planes(wall_planes(surface, graph)) {
    for (const std::int32_t t : wall) {
      const Triangle& nodes = surface.triangles[at(t)];
      const Vec3 a = surface.vertices[at(nodes[0])];
      normals.push_back(normalized(
          cross(surface.vertices[at(nodes[2])] - a, surface.vertices[at(nodes[1])] - a)));
    }
    for (const std::int32_t foot : graph.feet) places.push_back(surface.vertices[at(foot)]);
    for (std::size_t i = 0; i < graph.feet.size(); ++i) {
      const std::vector<Vec3> round = normals_at(view(), i);
      const Vec3 best = planes.held(i, marching_direction(with_images(round, planes, i)).direction);
      along.push_back(best / visibility(best, round));
    }
  }

  LineGround view() const { return {graph, planes, normals, places}; }

  std::vector<Vec3> levelled(const std::vector<bool>& held) const {
    std::vector<Vec3> lines = along;
    level_first_heights(view(), held, lines);
    return lines;
  }
  std::vector<Vec3> levelled() const { return levelled(std::vector<bool>(along.size(), false)); }

  /// By how much the height above a face is off at most, for a step of 1.
  double worst(const std::vector<Vec3>& lines) const {
    double most = 0;
    for (std::size_t f = 0; f < graph.wall_lines.size(); ++f) {
      double sum = 0;
      for (const std::int32_t line : graph.wall_lines[f]) sum += dot(lines[at(line)], normals[f]);
      most = std::max(most, std::abs(sum / 3 - 1));
    }
    return most;
  }
};

/// A box whose points are moved like a rough sea, so that faces turn to and away from each other.
SurfaceMesh rough_box(double height) {
  SurfaceMesh box = shapes::box({-1, -1, -1}, {1, 1, 1}, 8);
  for (Vec3& p : box.vertices) {
    if (std::abs(p.x) == 1 || std::abs(p.y) == 1) continue;
    const int i = static_cast<int>(std::lround(4 * p.x));
    const int j = static_cast<int>(std::lround(4 * p.y));
    p.z += height * ((7 * i * i + 3 * i * j + 5 * j * j * j) % 5);
  }
  return box;
}

LevelGround all_of(const SurfaceMesh& surface) {
  std::vector<std::int32_t> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return LevelGround(surface, all);
}

TEST(FirstHeights, lines_that_serve_all_faces_stay) {
  const LevelGround cube = all_of(shapes::box({0, 0, 0}, {1, 1, 1}, 4));
  EXPECT_LT(cube.worst(cube.along), 1e-12);
  EXPECT_EQ(cube.levelled(), cube.along);
}

TEST(FirstHeights, are_within_two_percent_where_faces_turn_both_ways) {
  const LevelGround sea = all_of(rough_box(0.015));
  EXPECT_GT(sea.worst(sea.along), 0.1);
  EXPECT_LT(sea.worst(sea.levelled()), 0.02);
}

TEST(FirstHeights, no_corner_gets_far_lower_than_its_face_is_to_have) {
  const LevelGround sea = all_of(rough_box(0.03));
  const std::vector<Vec3> lines = sea.levelled();
  for (std::size_t f = 0; f < sea.graph.wall_lines.size(); ++f) {
    for (const std::int32_t line : sea.graph.wall_lines[f]) {
      EXPECT_GT(dot(lines[at(line)], sea.normals[f]), 0.65);
    }
  }
}

TEST(FirstHeights, held_lines_and_lines_without_layers_stay) {
  LevelGround sea = all_of(rough_box(0.03));
  std::vector<bool> held(sea.along.size(), false);
  for (std::size_t i = 0; i < held.size(); i += 3) held[i] = true;
  for (std::size_t i = 1; i < held.size(); i += 7) sea.along[i] = Vec3{};
  const std::vector<Vec3> lines = sea.levelled(held);
  EXPECT_NE(lines, sea.along);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const bool stays = held[i] || sea.along[i] == Vec3{};
    EXPECT_TRUE(!stays || lines[i] == sea.along[i]) << i;
  }
}

TEST(FirstHeights, lines_in_planes_stay_in_them) {
  SurfaceMesh box = rough_box(0.03);
  box.patch_names = {"sides", "sea"};
  std::vector<std::int32_t> sea;
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const bool is_top = std::all_of(box.triangles[t].begin(), box.triangles[t].end(),
                                    [&](std::int32_t v) { return box.vertices[at(v)].z > 0.9; });
    box.patch_of_triangle.push_back(is_top ? 1 : 0);
    if (is_top) sea.push_back(static_cast<std::int32_t>(t));
  }
  const LevelGround ground(box, sea);
  const std::vector<Vec3> lines = ground.levelled();
  EXPECT_NE(lines, ground.along);
  int in_planes = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::int32_t plane : ground.planes.of_line[i]) {
      if (plane < 0) continue;
      const int axis = ground.planes.planes[at(plane)].axis;
      ASSERT_GE(axis, 0);
      EXPECT_EQ(lines[i][axis], 0) << i;
      ++in_planes;
    }
  }
  EXPECT_GT(in_planes, 8);
}

}  // namespace
}  // namespace tetfarm
