#include "mesh/inspect/surface_edges.h"

#include <gmock/gmock.h>

#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<SurfaceDefect> edge_defects(const SurfaceMesh& surface) {
  const std::vector<char> all(surface.triangles.size(), 1);
  const auto defect = check_edges(surface, edge_uses(surface.triangles, all));
  return defect ? std::vector{*defect} : std::vector<SurfaceDefect>{};
}

TEST(SurfaceEdges, of_closed_shapes_are_fine) {
  for (const SurfaceMesh& mesh : {shapes::tetrahedron(), shapes::unit_cube(),
                                  shapes::nested_spheres(1), shapes::torus(0.3, 8, 6)}) {
    EXPECT_THAT(edge_defects(mesh), IsEmpty());
  }
}

TEST(SurfaceEdges, are_each_used_twice_in_a_closed_shape) {
  const SurfaceMesh mesh = shapes::sphere({0, 0, 0}, 1, 1);
  const auto uses = edge_uses(mesh.triangles, std::vector<char>(mesh.triangles.size(), 1));
  std::size_t edges = 0;
  for_each_edge(uses, [&edges](std::span<const EdgeUse> edge) {
    ++edges;
    ASSERT_EQ(edge.size(), 2U);
    EXPECT_NE(edge[0].forward, edge[1].forward);
  });
  EXPECT_EQ(2 * edges, 3 * mesh.triangles.size());
}

TEST(SurfaceEdges, of_a_hole_are_open) {
  SurfaceMesh mesh = shapes::tetrahedron();
  mesh.triangles.erase(mesh.triangles.begin());  // (1, 2, 3)
  const auto defects = edge_defects(mesh);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].kind, "open edge");
  EXPECT_THAT(defects[0].triangles, ElementsAre(0, 1, 2));
  EXPECT_THAT(defects[0].message, HasSubstr("3 open edges"));
  EXPECT_THAT(defects[0].message,
              HasSubstr("edge from vertex 1 (1, 0, 0) to 2 (0, 1, 0) of triangle 2"));
}

TEST(SurfaceEdges, of_a_soup_are_open_and_the_message_says_what_would_help) {
  SurfaceMesh mesh = shapes::unit_cube();
  SurfaceMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::int32_t>(soup.vertices.size());
    for (const std::int32_t v : t)
      soup.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)]);
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  const auto defects = edge_defects(soup);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_THAT(defects[0].message, HasSubstr("36 open edges"));
  EXPECT_THAT(defects[0].message, HasSubstr("in the same place: joining these may close"));
}

TEST(SurfaceEdges, of_a_seam_that_rounding_tore_open_say_how_wide_it_is) {
  SurfaceMesh mesh = shapes::unit_cube();
  const std::int32_t v = mesh.triangles[0][0];
  mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)] + Vec3{0, 0, 0x1p-40});
  mesh.triangles[0][0] = 8;
  const auto defects = edge_defects(mesh);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_THAT(defects[0].message, HasSubstr("4 open edges"));
  EXPECT_THAT(defects[0].message,
              HasSubstr("1 pair of vertices on them lie within 9.09494702e-13"));
}

/// Two boxes side by side with one wall between them.
SurfaceMesh two_rooms() {
  SurfaceMesh mesh = welded(joined(shapes::unit_cube(), shapes::box({1, 0, 0}, {2, 1, 1}, 1)));
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    const bool is_known = std::ranges::any_of(
        kept, [&t](const Triangle& k) { return std::ranges::is_permutation(k, t); });
    if (!is_known) kept.push_back(t);
  }
  mesh.triangles = kept;
  return mesh;
}

TEST(SurfaceEdges, of_a_wall_between_two_rooms_are_fine) {
  EXPECT_THAT(edge_defects(two_rooms()), IsEmpty());
}

TEST(SurfaceEdges, of_a_flap_are_open_and_the_message_speaks_of_it) {
  SurfaceMesh mesh = shapes::unit_cube();
  mesh.vertices.push_back({2, 2, 2});
  const auto [a, b, c] = mesh.triangles[0];
  mesh.triangles.push_back({a, b, 8});
  const auto defects = edge_defects(mesh);
  ASSERT_EQ(defects.size(), 1U);
  EXPECT_EQ(defects[0].kind, "open edge");
  EXPECT_THAT(defects[0].message, Not(HasSubstr("joining")));
  EXPECT_THAT(defects[0].message, HasSubstr("1 edge is on more than two triangles: a sheet"));
}

}  // namespace
}  // namespace tetfarm
