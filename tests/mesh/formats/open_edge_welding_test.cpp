#include "mesh/formats/open_edge_welding.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// Each triangle with vertices of its own.
SurfaceMesh taken_apart(const SurfaceMesh& surface) {
  SurfaceMesh apart = surface;
  apart.vertices.clear();
  for (Triangle& t : apart.triangles) {
    for (std::int32_t& v : t) {
      apart.vertices.push_back(surface.vertices[static_cast<std::size_t>(v)]);
      v = static_cast<std::int32_t>(apart.vertices.size() - 1);
    }
  }
  return apart;
}

std::size_t vertices_in_use(const SurfaceMesh& surface) {
  std::vector<std::int32_t> used;
  for (const Triangle& t : surface.triangles) used.insert(used.end(), t.begin(), t.end());
  std::ranges::sort(used);
  return static_cast<std::size_t>(std::unique(used.begin(), used.end()) - used.begin());
}

TEST(OpenEdgeWelding, joins_triangles_that_each_have_their_own_vertices_into_the_closed_surface) {
  const SurfaceMesh ball = shapes::sphere({1, 2, 3}, 1, 2);
  SurfaceMesh surface = taken_apart(ball);
  const std::vector<Vec3> places = surface.vertices;
  const auto vertices = static_cast<std::int64_t>(ball.vertices.size());
  EXPECT_EQ(weld_open_edges(surface), std::int64_t(places.size()) - vertices);
  EXPECT_EQ(vertices_in_use(surface), ball.vertices.size());
  EXPECT_EQ(surface.vertices, places);
  EXPECT_DOUBLE_EQ(enclosed_volume(surface.vertices, surface.triangles),
                   enclosed_volume(ball.vertices, ball.triangles));
  EXPECT_EQ(weld_open_edges(surface), 0);
}

TEST(OpenEdgeWelding, takes_the_vertex_that_comes_first_in_the_file) {
  SurfaceMesh surface = taken_apart(shapes::unit_cube());
  weld_open_edges(surface);
  for (const Triangle& t : surface.triangles) {
    for (const std::int32_t v : t) {
      const auto first = std::ranges::find(surface.vertices, surface.vertices[std::size_t(v)]);
      EXPECT_EQ(first - surface.vertices.begin(), v);
    }
  }
}

TEST(OpenEdgeWelding, leaves_closed_bodies_apart_that_touch) {
  SurfaceMesh surface = shapes::unit_cube();
  const auto count = static_cast<std::int32_t>(surface.vertices.size());
  for (std::size_t t = 0; t < 12; ++t) {
    Triangle other = surface.triangles[t];
    for (std::int32_t& v : other) v += count;
    surface.triangles.push_back(other);
  }
  for (std::int32_t v = 0; v < count; ++v) {
    surface.vertices.push_back(surface.vertices[std::size_t(v)] + Vec3{1, 0, 0});
  }
  const SurfaceMesh before = surface;
  EXPECT_EQ(weld_open_edges(surface), 0);
  EXPECT_EQ(surface.triangles, before.triangles);
}

TEST(OpenEdgeWelding, joins_nothing_that_differs_in_the_last_bit) {
  SurfaceMesh surface = taken_apart(shapes::unit_cube());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    surface.vertices[v].x += 1e-15 * static_cast<double>(v + 1);
  }
  EXPECT_EQ(weld_open_edges(surface), 0);
}

}  // namespace
}  // namespace tetfarm
