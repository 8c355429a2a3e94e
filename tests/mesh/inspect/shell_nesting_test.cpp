#include "mesh/inspect/shell_nesting.h"

#include <gmock/gmock.h>

#include "mesh/inspect/shell_orientation.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::FieldsAre;

std::vector<ShellPlace> nest(const SurfaceMesh& mesh) {
  const std::vector<char> all(mesh.triangles.size(), 1);
  return nest_shells(mesh, orient_shells(mesh, edge_uses(mesh.triangles, all), all).shells);
}

SurfaceMesh cube(double low, double high) {
  return shapes::box({low, low, low}, {high, high, high}, 2);
}

TEST(ShellNesting, counts_the_shells_around) {
  const SurfaceMesh mesh =
      joined(joined(cube(2, 4), cube(0, 10)), joined(cube(1, 9), joined(cube(5, 6), cube(11, 12))));
  EXPECT_THAT(nest(mesh), ElementsAre(FieldsAre(2, 2), FieldsAre(-1, 0), FieldsAre(1, 1),
                                      FieldsAre(2, 2), FieldsAre(-1, 0)));
}

TEST(ShellNesting, is_not_fooled_by_rays_through_edges_and_vertices) {
  // All corners lie on one lattice, so the rays run along faces, edges and vertices of the others.
  const SurfaceMesh ring = joined(cube(0, 4), cube(1, 3));
  EXPECT_THAT(nest(ring), ElementsAre(FieldsAre(-1, 0), FieldsAre(0, 1)));
  const SurfaceMesh row =
      joined(shapes::box({0, 0, 0}, {1, 1, 1}, 2),
             joined(shapes::box({2, 0, 0}, {3, 1, 1}, 2), shapes::box({4, -1, -1}, {6, 1, 1}, 2)));
  EXPECT_THAT(nest(row), ElementsAre(FieldsAre(-1, 0), FieldsAre(-1, 0), FieldsAre(-1, 0)));
}

TEST(ShellNesting, knows_a_hollow_from_the_inside) {
  // The small cube lies in the bounding box of the torus, in its hole.
  const SurfaceMesh beside = joined(shapes::torus(0.3, 16, 8), cube(-0.2, 0.2));
  EXPECT_THAT(nest(beside), ElementsAre(FieldsAre(-1, 0), FieldsAre(-1, 0)));
  SurfaceMesh within = joined(shapes::torus(0.3, 16, 8), cube(-0.1, 0.1));
  for (std::size_t v = 16 * 8; v < within.vertices.size(); ++v) within.vertices[v].x += 1;
  EXPECT_THAT(nest(within), ElementsAre(FieldsAre(-1, 0), FieldsAre(0, 1)));
}

TEST(ShellNesting, works_where_shells_share_vertices) {
  // A tetrahedron inside the cube, with a corner on one of the cube's.
  SurfaceMesh inner = shapes::tetrahedron();
  inner.vertices = {{0, 0, 0}, {0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.5}};
  EXPECT_THAT(nest(welded(joined(shapes::unit_cube(), inner))),
              ElementsAre(FieldsAre(-1, 0), FieldsAre(0, 1)));
  // All four corners on the cube's.
  inner.vertices = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const auto places = nest(welded(joined(cube(0, 1), inner)));
  EXPECT_THAT(places, ElementsAre(FieldsAre(-1, 0), FieldsAre(0, 1)));
}

}  // namespace
}  // namespace tetfarm
