#include "mesh/assemble/forced_nodes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// A box of 4 x 4 squares a face; on its top, far from all edges, a vertex near to its neighbour.
SurfaceMesh box_with_needles() {
  SurfaceMesh box = shapes::box({0, 0, 0}, {4, 4, 4}, 4);
  for (Vec3& v : box.vertices) {
    if (v == Vec3{2, 2, 4}) v.x = 2.999;
  }
  return box;
}

/// A wedge of 3 degrees along the y axis, four nodes long: those on its edge are 0, 3, 6 and 9. In
/// its triangles at 3 and 6 no angle is small.
SurfaceMesh wedge() {
  SurfaceMesh surface;
  for (int j = 0; j < 4; ++j) {
    const double y = j;
    for (const Vec3& p : {Vec3{0, y, 0}, Vec3{1, y, 0}, Vec3{1, y, 0.05}}) {
      surface.vertices.push_back(p);
    }
  }
  for (std::int32_t e = 0; e < 9; e += 3) {
    const std::int32_t b = e + 1;
    const std::int32_t t = e + 2;
    for (const Triangle& triangle :
         {Triangle{e, e + 3, b + 3}, Triangle{e, b + 3, b}, Triangle{e, t, t + 3},
          Triangle{e, t + 3, e + 3}, Triangle{b, b + 3, t + 3}, Triangle{b, t + 3, t}}) {
      surface.triangles.push_back(triangle);
    }
  }
  surface.triangles.push_back({0, 1, 2});
  surface.triangles.push_back({9, 11, 10});
  return surface;
}

TEST(ForcedNodes, of_a_good_surface_are_none) {
  EXPECT_THAT(forced_nodes(shapes::box({0, 0, 0}, {4, 4, 4}, 4)), IsEmpty());
}

TEST(ForcedNodes, are_the_corners_of_thin_triangles) {
  const SurfaceMesh box = box_with_needles();
  const std::vector<ForcedNode> forced = forced_nodes(box);
  EXPECT_GE(forced.size(), 4U);
  for (const ForcedNode& node : forced) {
    EXPECT_EQ(node.region, 1);
    EXPECT_LT(distance(box.vertices[static_cast<std::size_t>(node.vertex)], {2.999, 2, 4}), 1.5);
  }
}

TEST(ForcedNodes, are_the_ends_of_sharp_edges_and_only_inside_the_wedge) {
  SurfaceMesh surface = wedge();
  const auto is_forced = [&surface](std::int32_t vertex, std::int32_t region) {
    const std::vector<ForcedNode> forced = forced_nodes(surface);
    return std::binary_search(forced.begin(), forced.end(), ForcedNode{vertex, region});
  };
  EXPECT_TRUE(is_forced(3, 1) && is_forced(6, 1));
  surface.sides.assign(surface.triangles.size(), Sides{2, 1});
  surface.region_names = {"outside", "wedge"};
  EXPECT_TRUE(is_forced(3, 2) && is_forced(6, 2));
  EXPECT_FALSE(is_forced(3, 1) || is_forced(6, 1));
  EXPECT_TRUE(is_forced(0, 1)) << "the triangle at the end is thin for either side";
}

TEST(ForcedNodes, ascend_and_come_once_a_region) {
  SurfaceMesh box = box_with_needles();
  const std::vector<ForcedNode> one = forced_nodes(box);
  box.sides.assign(box.triangles.size(), Sides{2, 1});
  box.region_names = {"outside", "inside"};
  std::vector<ForcedNode> both;
  for (const ForcedNode& node : one) {
    both.push_back({node.vertex, 1});
    both.push_back({node.vertex, 2});
  }
  EXPECT_EQ(forced_nodes(box), both);
}

TEST(ForcedNodes, do_not_come_of_triangles_between_what_is_not_meshed) {
  SurfaceMesh box = box_with_needles();
  box.sides.assign(box.triangles.size(), Sides{0, 0});
  EXPECT_THAT(forced_nodes(box), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
