#include "mesh/volume/steiner_relocation.h"

#include <gtest/gtest.h>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/volume/boundary_recovery.h"
#include "mesh/volume/inside_tets.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

/// The inside of a cube with a point added to it and split into the surface at one edge or face.
struct SplitCube {
  SplitCube(const Vec3& place, std::int32_t edge_triangle, bool is_on_edge) {
    domain = root_subdomain(shapes::unit_cube());
    SplitSurface surface = unsplit(domain.triangles);
    const auto [a, b, c] = domain.triangles[static_cast<std::size_t>(edge_triangle)];
    std::vector<Vec3> points = domain.vertices;
    points.push_back(place);
    if (is_on_edge) {
      split_edge(surface, a, b, 8);
    } else {
      split_face(surface, edge_triangle, 8);
    }
    split = surface.splits.front();
    TetComplex complex = bowyer_watson(points).complex;
    std::vector<std::uint8_t> marks(complex.nodes.size(), 0);
    const RecoveredBoundary recovered = recover_boundary(complex, marks, surface.triangles);
    EXPECT_TRUE(recovered.lost.empty());
    EXPECT_TRUE(recovered.surface.splits.empty());
    const RecoverySurface all(surface.triangles, static_cast<std::int32_t>(complex.points.size()));
    inside = keep_inside(complex, marks, inside_tets(LocalRemeshing(complex, marks), all), 9, 4);
  }

  Subdomain domain;
  SteinerSplit split;
  InsideComplex inside;
};

TEST(SteinerRelocation, of_a_point_on_an_edge_makes_its_triangles_whole) {
  const Subdomain domain = root_subdomain(shapes::unit_cube());
  const auto& t = domain.triangles.front();
  const Vec3 place = 0.5 * (domain.vertices[static_cast<std::size_t>(t[0])] +
                            domain.vertices[static_cast<std::size_t>(t[1])]);
  SplitCube cube(place, 0, true);
  ASSERT_TRUE(relocate_steiner_point(cube.inside.complex, cube.inside.constrained, cube.split));
  EXPECT_TRUE(validate(cube.inside.complex).empty());
  expect_mesh_of(to_tet_mesh(cube.inside.complex, 8), cube.domain);
  const Vec3& moved = cube.inside.complex.points[8];
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(moved[axis], 0);
    EXPECT_LT(moved[axis], 1);
  }
}

TEST(SteinerRelocation, of_a_point_on_a_face_makes_the_face_whole) {
  const Subdomain domain = root_subdomain(shapes::unit_cube());
  const auto& t = domain.triangles[3];
  const auto p = [&](int i) {
    return domain.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
  };
  SplitCube cube(0.25 * p(0) + 0.5 * p(1) + 0.25 * p(2), 3, false);
  ASSERT_TRUE(relocate_steiner_point(cube.inside.complex, cube.inside.constrained, cube.split));
  expect_mesh_of(to_tet_mesh(cube.inside.complex, 8), cube.domain);
}

TEST(SteinerRelocation, of_a_point_that_is_in_no_tet_changes_nothing) {
  const Subdomain domain = root_subdomain(shapes::unit_cube());
  const auto& t = domain.triangles.front();
  const auto p = [&](std::size_t i) { return domain.vertices[static_cast<std::size_t>(t[i])]; };
  SplitCube cube(0.25 * p(0) + 0.25 * p(1) + 0.5 * p(2), 0, false);
  const auto before = cube.inside.complex.nodes;
  SteinerSplit none = cube.split;
  none.node = 8;
  cube.inside.complex.node2tet[8] = -1;
  EXPECT_FALSE(relocate_steiner_point(cube.inside.complex, cube.inside.constrained, none));
  EXPECT_EQ(cube.inside.complex.nodes, before);
}

}  // namespace
}  // namespace tetfarm
