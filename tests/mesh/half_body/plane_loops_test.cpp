#include "mesh/half_body/plane_loops.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/half_body/half_shapes.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

const AxisPlane y_is_0 = {1, 0};

std::string refusal_of_loops(SurfaceMesh surface, const AxisPlane& plane = y_is_0) {
  return error_text_of<InvalidInput>([&] { find_plane_loops(surface, plane); });
}

TEST(PlaneLoops, are_where_the_surface_ends_on_the_plane) {
  SurfaceMesh surface =
      both_of(open_box({0, 0, 0}, {1, 2, 1}, 2), open_box({3, 0, 0}, {5, 2, 2}, 3));
  const std::vector<Vec3> before = surface.vertices;
  const PlaneLoops found = find_plane_loops(surface, y_is_0);
  ASSERT_EQ(found.loops.size(), 2U);
  EXPECT_EQ(found.loops[0].size(), 8U);
  EXPECT_EQ(found.loops[1].size(), 12U);
  EXPECT_EQ(found.side, 1);
  EXPECT_EQ(found.moved, 0);
  EXPECT_EQ(surface.vertices, before);
  for (const std::vector<std::int32_t>& loop : found.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3& a = surface.vertices[static_cast<std::size_t>(loop[i])];
      const Vec3& b = surface.vertices[static_cast<std::size_t>(loop[(i + 1) % loop.size()])];
      EXPECT_LE(distance(a, b), 1) << "consecutive vertices are ends of an edge";
    }
  }
}

TEST(PlaneLoops, of_a_surface_on_the_other_side_are_found_too) {
  SurfaceMesh surface = open_box({0, -2, 0}, {1, 0, 1}, 2);
  EXPECT_EQ(find_plane_loops(surface, y_is_0).side, -1);
}

TEST(PlaneLoops, that_lie_a_little_beside_are_where_the_plane_is) {
  SurfaceMesh surface = open_box({0, 0, 0}, {1, 2, 1}, 2);
  for (Vec3& v : surface.vertices) v.y += 1e-7;
  const PlaneLoops found = find_plane_loops(surface, y_is_0);
  EXPECT_EQ(found.plane.height, 1e-7);
  EXPECT_EQ(found.moved, 0);
}

TEST(PlaneLoops, that_differ_a_little_are_moved_onto_the_plane_and_counted) {
  SurfaceMesh surface = open_box({0, 0, 0}, {1, 2, 1}, 2);
  const PlaneLoops whole = find_plane_loops(surface, y_is_0);
  const auto first = static_cast<std::size_t>(whole.loops[0][0]);
  surface.vertices[first].y = 3e-8;
  const PlaneLoops found = find_plane_loops(surface, y_is_0);
  EXPECT_EQ(found.moved, 1);
  EXPECT_EQ(found.farthest_move, 3e-8);
  EXPECT_EQ(surface.vertices[first].y, 0);
  EXPECT_EQ(found.loops, whole.loops);
}

TEST(PlaneLoops, are_refused_with_places_where_there_are_none_or_others) {
  EXPECT_EQ(
      refusal_of_loops(shapes::unit_cube()),
      "symmetry y=0: the surface is closed, so that nothing ends on this plane; leave out the "
      "symmetry, or give one half of the surface, open where the plane is");
  EXPECT_THAT(refusal_of_loops(open_box({0, 0, 0}, {1, 2, 1}, 2), {1, 1}),
              HasSubstr("symmetry y=1: 8 vertices of 8 on open edges lie elsewhere, the farthest 1 "
                        "away at ("));
  SurfaceMesh holed = open_box({0, 0, 0}, {1, 2, 1}, 3);
  holed.triangles.erase(
      std::find_if(holed.triangles.begin(), holed.triangles.end(), [&](const Triangle& t) {
        return std::all_of(t.begin(), t.end(), [&](std::int32_t v) {
          return holed.vertices[static_cast<std::size_t>(v)].y == 2;
        });
      }));
  EXPECT_THAT(refusal_of_loops(holed),
              HasSubstr("3 vertices of 15 on open edges lie elsewhere, the "
                        "farthest 2 away"));
}

TEST(PlaneLoops, are_refused_where_the_surface_goes_on_behind_the_plane_or_in_it) {
  const SurfaceMesh through =
      both_of(open_box({0, 0, 0}, {1, 2, 1}, 2), shapes::box({3, -0.5, 0}, {4, 1, 1}, 1));
  EXPECT_THAT(refusal_of_loops(through), HasSubstr("reaches through it, by 0.5 at ("));
  const SurfaceMesh within =
      both_of(open_box({0, 0, 0}, {1, 2, 1}, 2), shapes::box({3, 0, 0}, {4, 1, 1}, 1));
  EXPECT_THAT(refusal_of_loops(within), HasSubstr("2 triangles of the surface lie in the plane"));
}

TEST(PlaneLoops, are_refused_where_they_touch) {
  SurfaceMesh touching =
      both_of(open_box({0, 0, 0}, {1, 2, 1}, 1), open_box({1, 0, 1}, {2, 2, 2}, 1));
  // The edge that both boxes have is one, and so are its vertices.
  const auto number_of = [&](const Vec3& place) {
    return static_cast<std::int32_t>(
        std::find(touching.vertices.begin(), touching.vertices.end(), place) -
        touching.vertices.begin());
  };
  for (Triangle& triangle : touching.triangles) {
    for (std::int32_t& v : triangle) v = number_of(touching.vertices[static_cast<std::size_t>(v)]);
  }
  EXPECT_THAT(refusal_of_loops(touching), HasSubstr("more than two open edges meet at (1, 0, 1)"));
}

}  // namespace
}  // namespace tetfarm
