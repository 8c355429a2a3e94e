#include "mesh/remeshing/edge_flip.h"

#include <gmock/gmock.h>

#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// A box of which one face has a vertex at the wrong end of its diagonals: flips help there.
SurfaceMesh slanted_box() {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 3);
  for (Vec3& vertex : box.vertices) vertex.x += 1.5 * vertex.y;
  return box;
}

TEST(EdgeFlip, makes_the_worst_triangles_better_and_ends) {
  SurfaceToChange slanted(slanted_box(), 1, 0.01);
  std::vector<std::int32_t> all(36 * 3);
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<std::int32_t>(t);
  const double before = worst_shape(slanted.surface, all);
  EXPECT_GT(flip_edges(slanted.work, FlipFor::shape), 0);
  EXPECT_GT(worst_shape(slanted.surface, all), before);
  EXPECT_EQ(flip_edges(slanted.work, FlipFor::shape), 0);
  EXPECT_NEAR(volume_of(slanted.surface), 1, 1e-14);
  EXPECT_THAT(complaints_of(slanted.surface), IsEmpty());
}

TEST(EdgeFlip, never_turns_a_feature) {
  SurfaceToChange cube(shapes::unit_cube(), 1, 1);
  for (const std::array<std::int32_t, 2>& edge : cube.features.edges) {
    EXPECT_FALSE(flip_edge(cube.work, edge[0], edge[1], FlipFor::shape));
    EXPECT_FALSE(flip_edge(cube.work, edge[0], edge[1], FlipFor::valence));
  }
}

TEST(EdgeFlip, by_valence_ends_and_keeps_shapes_passable) {
  SurfaceToChange sphere(shapes::sphere({0, 0, 0}, 1, 2), 0.3, 0.1);
  flip_edges(sphere.work, FlipFor::valence);
  EXPECT_EQ(flip_edges(sphere.work, FlipFor::valence), 0);
  for (std::int32_t t = 0; t < sphere.surface.triangle_end(); ++t) {
    EXPECT_GE(triangle_shape(sphere.surface.points(sphere.surface.triangle(t).nodes)),
              passable_shape);
  }
  EXPECT_THAT(complaints_of(sphere.surface), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
