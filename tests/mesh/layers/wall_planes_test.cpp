#include "mesh/layers/wall_planes.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/mesh/layers/boxes_with_planes.h"

namespace tetfarm {
namespace {

/// The patch is the wall.
WallGraph graph_of(const SurfaceMesh& surface, std::int32_t patch) {
  std::vector<std::int32_t> wall;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.patch_of_triangle[t] == patch) wall.push_back(static_cast<std::int32_t>(t));
  }
  return wall_graph(surface, std::move(wall));
}

std::set<std::int32_t> patches_of(const WallPlanes& planes) {
  std::set<std::int32_t> patches;
  for (const WallPlane& plane : planes.planes) patches.insert(plane.patch);
  return patches;
}

TEST(WallPlanes, are_the_flat_patches_next_to_the_wall) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 4);
  const WallGraph graph = graph_of(box, test::floor_patch);
  const WallPlanes planes = wall_planes(box, graph);
  EXPECT_EQ(patches_of(planes), (std::set<std::int32_t>{2, 3, 4, 5})) << "the ceiling is not near";
  int with_two = 0;
  int with_one = 0;
  for (std::size_t i = 0; i < graph.feet.size(); ++i) {
    EXPECT_EQ(planes.holds(i), graph.at_border[i]);
    with_two += planes.of_line[i][1] >= 0 ? 1 : 0;
    with_one += planes.holds(i) && planes.of_line[i][1] < 0 ? 1 : 0;
  }
  EXPECT_EQ(with_two, 4);
  EXPECT_EQ(with_one, 12);
  for (const WallPlane& plane : planes.planes) {
    EXPECT_EQ(plane.axis, plane.patch < 4 ? 0 : 1);
    EXPECT_EQ(plane.triangles.size(), 32U);
    EXPECT_EQ(plane.border.size(), 16U);
  }
}

TEST(WallPlanes, of_one_patch_are_two_where_it_has_a_ridge) {
  SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 4);
  for (std::int32_t& patch : box.patch_of_triangle) patch = patch > 2 ? 2 : patch;
  const WallPlanes planes = wall_planes(box, graph_of(box, test::floor_patch));
  EXPECT_EQ(planes.planes.size(), 4U);
}

TEST(WallPlanes, are_found_where_the_digits_of_a_file_have_moved_their_points) {
  SurfaceMesh box = test::turned(test::box_with_patches({0, 0, 0}, {2, 2, 2}, 20));
  for (Vec3& p : box.vertices) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(p[axis] * 1e5) / 1e5;  // six digits
  }
  const WallPlanes planes = wall_planes(box, graph_of(box, test::floor_patch));
  EXPECT_EQ(planes.planes.size(), 4U);
  for (const WallPlane& plane : planes.planes) EXPECT_EQ(plane.axis, -1);
}

TEST(WallPlanes, are_not_pieces_of_a_curved_patch) {
  SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& p : box.vertices) {
    if (p.x == 1) p.x += 0.2 * p.y * (1 - p.y);  // the east bulges
  }
  const WallGraph graph = graph_of(box, test::floor_patch);
  const WallPlanes planes = wall_planes(box, graph);
  EXPECT_EQ(patches_of(planes), (std::set<std::int32_t>{2, 4, 5}));
  for (std::size_t i = 0; i < graph.feet.size(); ++i) {
    if (box.vertices[at(graph.feet[i])].x < 1) continue;
    EXPECT_FALSE(planes.holds(i)) << "a line beside the east";
  }
}

TEST(WallPlanes, draw_and_lift_points_without_a_change) {
  const SurfaceMesh box = test::box_with_patches({0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}, 4);
  const WallPlanes planes = wall_planes(box, graph_of(box, test::floor_patch));
  for (const WallPlane& plane : planes.planes) {
    for (const std::int32_t t : plane.triangles) {
      const Triangle& nodes = box.triangles[at(t)];
      std::array<Vec2, 3> drawn;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = box.vertices[at(nodes[k])];
        drawn[k] = plane.project(p);
        EXPECT_EQ(plane.lift(drawn[k]), p);
      }
      EXPECT_GT((drawn[1].x - drawn[0].x) * (drawn[2].y - drawn[0].y) -
                    (drawn[1].y - drawn[0].y) * (drawn[2].x - drawn[0].x),
                0)
          << "anticlockwise seen from outside";
    }
  }
}

TEST(WallPlanes, hold_a_direction_in_them) {
  const SurfaceMesh box = test::box_with_patches({0, 0, 0}, {1, 1, 1}, 4);
  const WallGraph graph = graph_of(box, test::floor_patch);
  const WallPlanes planes = wall_planes(box, graph);
  const Vec3 aslant = normalized(Vec3{0.3, 0.2, 1});
  for (std::size_t i = 0; i < graph.feet.size(); ++i) {
    const Vec3 held = planes.held(i, aslant);
    const Vec3 p = box.vertices[at(graph.feet[i])];
    EXPECT_EQ(held == aslant, !graph.at_border[i]);
    EXPECT_EQ(held.x == 0, p.x == 0 || p.x == 1);
    EXPECT_EQ(held.y == 0, p.y == 0 || p.y == 1);
    EXPECT_NEAR(norm(held), 1, 1e-15);
  }
}

}  // namespace
}  // namespace tetfarm
