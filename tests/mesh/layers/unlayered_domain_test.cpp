#include "mesh/layers/unlayered_domain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(UnlayeredDomain, of_no_layers_is_the_surface) {
  const SurfaceMesh sphere = shapes::sphere({0, 0, 0}, 1, 2);
  const LayerPlan plan = plan_layers(sphere, {});
  const UnlayeredDomain rest = unlayered_domain(plan, sphere, TreePath{2}, 1);
  EXPECT_EQ(rest.top_nodes, 0);
  EXPECT_EQ(rest.top_triangles, 0);
  EXPECT_EQ(rest.root.vertices, sphere.vertices);
  EXPECT_EQ(rest.root.triangles, sphere.triangles);
  EXPECT_EQ(rest.root.path, TreePath{2});
}

TEST(UnlayeredDomain, has_the_tops_of_lines_numbered_in_their_order) {
  SurfaceMesh spheres = shapes::nested_spheres(2);
  spheres.patch_names = {"outer", "inner"};
  spheres.patch_of_triangle.clear();
  for (const Triangle& t : spheres.triangles) {
    spheres.patch_of_triangle.push_back(norm(spheres.vertices[at(t[0])]) > 0.6 ? 0 : 1);
  }
  LayerRequest request = test::request_of_all(spheres, 1e-3, 4);
  request.patches = {1};
  const LayerPlan plan = plan_layers(spheres, std::span(&request, 1));
  const UnlayeredDomain rest = unlayered_domain(plan, spheres, TreePath{2}, 77);
  EXPECT_EQ(rest.top_nodes, std::ssize(plan.lines));
  EXPECT_EQ(rest.top_triangles, std::ssize(plan.wall));
  ASSERT_EQ(rest.root.triangles.size(), spheres.triangles.size());
  std::uint32_t top = 0;
  for (std::size_t t = 0; t < spheres.triangles.size(); ++t) {
    const Origin& origin = rest.root.triangle_origin[t];
    const bool is_wall = spheres.patch_of_triangle[t] == 1;
    EXPECT_EQ(origin, (is_wall ? Origin{77, top++} : Origin{0, static_cast<std::uint32_t>(t)}));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = at(rest.root.triangles[t][k]);
      const Origin& node = rest.root.node_origin[v];
      const std::int32_t foot = spheres.triangles[t][k];
      if (!is_wall) {
        EXPECT_EQ(node, (Origin{0, static_cast<std::uint32_t>(foot)}));
        continue;
      }
      EXPECT_EQ(node.owner, 77U);
      const LayerLine& line = plan.lines[node.index];
      EXPECT_EQ(line.foot, foot);
      EXPECT_EQ(rest.root.vertices[v], point_of(line, line.stop));
    }
  }
}

}  // namespace
}  // namespace tetfarm
