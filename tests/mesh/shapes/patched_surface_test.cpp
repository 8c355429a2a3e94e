#include "mesh/shapes/patched_surface.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/core/validate.h"
#include "mesh/shapes/circle_point.h"

namespace tetfarm {
namespace {

VertexRow circle(PatchedSurface& surface, int n, double z) {
  VertexRow row;
  for (int k = 0; k < n; ++k) {
    const auto [c, s] = circle_point(k, n);
    row.push_back(surface.add_vertex({c, s, z}));
  }
  return row;
}

TEST(PatchedSurface, rings_of_different_counts_are_joined_without_a_gap) {
  PatchedSurface surface;
  surface.begin_patch("lid");
  const VertexRow bottom = circle(surface, 12, 0);
  const VertexRow top = circle(surface, 17, 1);
  surface.zip_rings({surface.add_vertex({0, 0, 0})}, bottom);
  surface.begin_patch("side");
  surface.zip_rings(top, bottom);
  surface.zip_rings({surface.add_vertex({0, 0, 1})}, top);
  const SurfaceMesh mesh = surface.take();
  EXPECT_EQ(mesh.triangles.size(), std::size_t{12 + 12 + 17 + 17});
  EXPECT_EQ(mesh.patch_of_triangle.size(), mesh.triangles.size());
  EXPECT_EQ(mesh.patch_of_triangle[11], 0);
  EXPECT_EQ(mesh.patch_of_triangle[12], 1);
}

TEST(PatchedSurface, a_strip_is_anticlockwise_when_the_right_row_lies_to_the_right) {
  PatchedSurface surface;
  surface.begin_patch("strip");
  const VertexRow left = {surface.add_vertex({0, 0, 0}), surface.add_vertex({0, 1, 0})};
  const VertexRow right = {surface.add_vertex({1, 0, 0}), surface.add_vertex({1, 1, 0})};
  surface.zip(left, right);
  const SurfaceMesh mesh = surface.take();
  ASSERT_EQ(mesh.triangles.size(), 2U);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](std::int32_t v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
    EXPECT_GT(cross(at(b) - at(a), at(c) - at(a)).z, 0);
  }
}

TEST(PatchedSurface, a_turned_surface_encloses_the_opposite_volume) {
  PatchedSurface tetrahedron;
  tetrahedron.begin_patch("all");
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    tetrahedron.add_vertex(p);
  }
  for (const auto& [a, b, c] : tet_face_nodes) tetrahedron.add_triangle(a, b, c);
  const SurfaceMesh one = tetrahedron.take();
  PatchedSurface turned;
  turned.begin_patch("all");
  turned.add_surface(one, true);
  const SurfaceMesh other = turned.take();
  EXPECT_TRUE(unmatched_edges(other.triangles).empty());
  EXPECT_GT(enclosed_volume(one.vertices, one.triangles), 0);
  EXPECT_EQ(enclosed_volume(other.vertices, other.triangles),
            -enclosed_volume(one.vertices, one.triangles));
}

TEST(PatchedSurface, a_spacing_that_would_need_too_many_parts_is_a_usage_error) {
  EXPECT_EQ(parts_of_length(1, 0.26, 1), 4);
  EXPECT_EQ(parts_of_length(1, 10, 3), 3);
  EXPECT_THROW(parts_of_length(1, 1e-9, 1), UsageError);
  EXPECT_THROW(parts_of_length(1, 0, 1), UsageError);
  EXPECT_THROW(parts_of_length(1, -1, 1), UsageError);
}

}  // namespace
}  // namespace tetfarm
