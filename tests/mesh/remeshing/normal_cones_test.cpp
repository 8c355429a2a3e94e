#include "mesh/remeshing/normal_cones.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "mesh/geometry/triangle_intersection.h"
#include "mesh/remeshing/triangle_normal.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct SurfaceWithCones {
  explicit SurfaceWithCones(SurfaceMesh given) : mesh(std::move(given)) {
    for (const Triangle& t : mesh.triangles) {
      normals.push_back(normalized(doubled_area(triangle_points(mesh.vertices, t))));
    }
    cones = NormalCones(mesh, normals);
  }
  bool all_look(const Box3& box, const Vec3& way, double least_cosine) const {
    return cones.all_look(mesh, normals, box, way, least_cosine);
  }

  SurfaceMesh mesh;
  std::vector<Vec3> normals;
  NormalCones cones;
};

Box3 cube_round(const Vec3& middle, double half) {
  Box3 box;
  box.add(middle - Vec3{half, half, half});
  box.add(middle + Vec3{half, half, half});
  return box;
}

TEST(NormalCones, of_a_sphere_are_true_near_a_pole_and_not_where_the_equator_is_reached) {
  const SurfaceWithCones sphere(shapes::sphere({0, 0, 0}, 1, 4));
  EXPECT_TRUE(sphere.all_look(cube_round({0, 0, 1}, 0.3), {0, 0, 1}, 0.3));
  EXPECT_FALSE(sphere.all_look(cube_round({0, 0, 1}, 0.3), {0, 0, -1}, 0.3));
  EXPECT_FALSE(sphere.all_look(cube_round({0, 0, 1}, 0.3), {1, 0, 0}, 0.3));
  EXPECT_FALSE(sphere.all_look(cube_round({0, 0, 1}, 1), {0, 0, 1}, 0.3));
  EXPECT_TRUE(sphere.all_look(cube_round({0, 0, 3}, 1), {0, 0, 1}, 0.3)) << "there is nothing";
}

/// Points over the triangle, corners and edges too.
bool has_point_in(const TrianglePoints& c, const Box3& box) {
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Vec3 p = (i * c[0] + j * c[1] + (steps - i - j) * c[2]) / steps;
      Box3 at;
      at.add(p);
      if (at.overlaps(box)) return true;
    }
  }
  return false;
}

TEST(NormalCones, never_pass_over_a_triangle_in_the_box_that_looks_away) {
  std::mt19937 random(7);
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  for (const SurfaceMesh& surface :
       {shapes::sphere({0, 0, 0}, 1, 3), shapes::box({-1, -1, -0.05}, {1, 1, 0.05}, 1)}) {
    const SurfaceWithCones of(surface);
    int passed = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec3 middle{2 * share() - 1, 2 * share() - 1, 2 * share() - 1};
      const Box3 box = cube_round(middle, 0.02 + 0.5 * share());
      const Vec3 way = normalized(Vec3{share() - 0.5, share() - 0.5, share() - 0.5});
      if (!of.all_look(box, way, 0.3)) continue;
      ++passed;
      for (std::size_t t = 0; t < of.normals.size(); ++t) {
        if (dot(of.normals[t], way) > 0.3) continue;
        EXPECT_FALSE(has_point_in(triangle_points(surface.vertices, surface.triangles[t]), box));
      }
    }
    EXPECT_GT(passed, 20);
  }
}

TEST(NormalCones, pass_over_triangles_without_a_sure_normal) {
  SurfaceWithCones of(shapes::unit_cube());
  const Box3 top = cube_round({0.5, 0.5, 1}, 0.2);
  for (std::size_t t = 0; t < of.normals.size(); ++t) {
    if (of.normals[t].z > 0.5) of.normals[t] = {};
  }
  of.cones = NormalCones(of.mesh, of.normals);
  EXPECT_TRUE(of.all_look(top, {1, 0, 0}, 0.3));
}

}  // namespace
}  // namespace tetfarm
