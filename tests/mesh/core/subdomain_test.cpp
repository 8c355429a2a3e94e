#include "mesh/core/subdomain.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(TreePath, names_the_way_from_the_root) {
  const TreePath root;
  EXPECT_EQ(root.text(), "root");
  EXPECT_EQ(root.depth(), 0);
  EXPECT_EQ(root.left().right().text(), "LR");
  EXPECT_EQ(root.left().right().heap, 5U);
  EXPECT_EQ(root.right().right().left().text(), "RRL");
  EXPECT_EQ(root.right().right().left().depth(), 3);
}

TEST(TreePath, reaches_62_levels) {
  TreePath path;
  for (int level = 0; level < 62; ++level) path = path.right();
  EXPECT_EQ(path.depth(), 62);
  EXPECT_EQ(path.text(), std::string(62, 'R'));
}

TEST(RootSubdomain, of_a_closed_shape_is_valid) {
  for (const SurfaceMesh& shape : {shapes::tetrahedron(), shapes::unit_cube(),
                                   shapes::nested_spheres(1), shapes::torus(0.3, 8, 6)}) {
    const Subdomain root = root_subdomain(shape);
    EXPECT_THAT(validate(root), IsEmpty());
    EXPECT_EQ(root.path, TreePath{});
    EXPECT_EQ(root.triangles, shape.triangles);
    EXPECT_EQ(root.vertices, shape.vertices);
  }
}

TEST(RootSubdomain, drops_unused_vertices_and_remembers_the_input_numbers) {
  SurfaceMesh surface = shapes::tetrahedron();
  surface.vertices.insert(surface.vertices.begin(), {9, 9, 9});
  for (Triangle& triangle : surface.triangles) {
    for (std::int32_t& v : triangle) ++v;
  }
  const Subdomain root = root_subdomain(surface);
  EXPECT_EQ(root.vertices, shapes::tetrahedron().vertices);
  EXPECT_EQ(root.triangles, shapes::tetrahedron().triangles);
  EXPECT_EQ(root.node_origin[0], (Origin{0, 1}));
  EXPECT_EQ(root.node_origin[3], (Origin{0, 4}));
  EXPECT_EQ(root.triangle_origin[2], (Origin{0, 2}));
}

TEST(ValidateSubdomain, two_shells_may_share_an_edge) {
  SurfaceMesh surface = shapes::tetrahedron();
  surface.vertices.push_back({1, -1, 0});
  surface.vertices.push_back({0, 0, -1});
  for (const Triangle& t : shapes::tetrahedron().triangles) {
    // The same shape on nodes 0, 1 and two new ones.
    const std::array<std::int32_t, 4> map = {0, 1, 5, 4};
    surface.triangles.push_back({map[static_cast<std::size_t>(t[0])],
                                 map[static_cast<std::size_t>(t[1])],
                                 map[static_cast<std::size_t>(t[2])]});
  }
  EXPECT_THAT(validate(root_subdomain(surface)), IsEmpty());
}

TEST(ValidateSubdomain, finds_a_hole_and_names_its_edges) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.triangles.pop_back();
  s.triangle_origin.pop_back();
  EXPECT_THAT(validate(s), SizeIs(3));
  EXPECT_THAT(validate(s), Contains(HasSubstr("both directions")));
}

TEST(ValidateSubdomain, finds_a_turned_triangle) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  std::swap(s.triangles[4][0], s.triangles[4][1]);
  EXPECT_THAT(validate(s), SizeIs(3));
}

TEST(ValidateSubdomain, finds_indices_out_of_range_and_repeated) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.triangles[0][0] = 8;
  s.triangles[1][0] = -1;
  s.triangles[2][0] = s.triangles[2][1];
  EXPECT_THAT(validate(s), SizeIs(3));
}

TEST(ValidateSubdomain, finds_unequal_lengths) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.node_origin.pop_back();
  s.triangle_origin.pop_back();
  EXPECT_THAT(validate(s), SizeIs(2));
}

TEST(ValidateSubdomain, finds_repeated_origins) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.node_origin[5] = s.node_origin[2];
  s.triangle_origin[1] = s.triangle_origin[7];
  EXPECT_THAT(validate(s), SizeIs(2));
  EXPECT_THAT(validate(s), Contains("two vertices have the origin (owner 0, index 2)"));
}

TEST(ValidateSubdomain, finds_an_unused_and_an_infinite_vertex) {
  Subdomain s = root_subdomain(shapes::unit_cube());
  s.vertices[3].y = std::numeric_limits<double>::infinity();
  s.vertices.push_back({0.5, 0.5, 0.5});
  s.node_origin.push_back({0, 99});
  EXPECT_THAT(validate(s), SizeIs(2));
}

TEST(ValidateSubdomain, stops_after_twenty_lines) {
  Subdomain s = root_subdomain(shapes::sphere({0, 0, 0}, 1, 2));
  for (Triangle& t : s.triangles) t[0] = -1;
  EXPECT_THAT(validate(s), SizeIs(20));
}

}  // namespace
}  // namespace tetfarm
