#include "mesh/healing/nearly_flat_triangles.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "tests/mesh/healing/damaged_surface.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

const Vec3& corner_of(const SurfaceMesh& surface, std::size_t t, std::size_t k) {
  return vertex_at(surface, surface.triangles[t][k]);
}

/// Height of the lowest triangle over its longest edge.
double lowest(const SurfaceMesh& surface) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePoints c = points_of(surface, t);
    const double longest =
        std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
    least = std::min(least, norm(cross(c[1] - c[0], c[2] - c[0])) / longest);
  }
  return least;
}

/// A cap of this height over the first edge of triangle t, in its plane.
void add_cap(SurfaceMesh& surface, std::size_t t, double height) {
  const Vec3 apex = corner_of(surface, t, 2);
  test::add_flat_triangle(surface, t);
  Vec3& middle = surface.vertices.back();
  middle = middle + height * normalized(apex - middle);
}

/// Two needles: the first edge of triangle t is divided `off` from its first vertex, on both sides.
void add_needles(SurfaceMesh& surface, std::size_t t, double off) {
  const std::int32_t a = surface.triangles[t][0];
  const std::int32_t b = surface.triangles[t][1];
  const auto m = static_cast<std::int32_t>(surface.vertices.size());
  surface.vertices.push_back(vertex_at(surface, a) +
                             off * normalized(vertex_at(surface, b) - vertex_at(surface, a)));
  for (std::size_t i = 0, count = surface.triangles.size(); i < count; ++i) {
    Triangle& n = surface.triangles[i];
    if (std::ranges::count(n, a) + std::ranges::count(n, b) < 2) continue;
    Triangle other = n;
    std::ranges::replace(n, a, m);
    std::ranges::replace(other, b, m);
    test::add_copy(surface, i, other);
  }
}

/// The triangle of the cube's top whose first edge is the one at y = 0.
std::size_t triangle_at_edge(SurfaceMesh& cube) {
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    for (int turn = 0; turn < 3; ++turn) {
      const TrianglePoints c = points_of(cube, t);
      if (c[0].z == 1 && c[1].z == 1 && c[2].z == 1 && c[0].y == 0 && c[1].y == 0) return t;
      Triangle& n = cube.triangles[t];
      n = {n[1], n[2], n[0]};
    }
  }
  ADD_FAILURE() << "no such triangle";
  return 0;
}

TEST(NearlyFlatTriangles, caps_go_and_the_triangle_beyond_is_divided) {
  for (const double height : {1e-15, 1e-12, 1e-7}) {
    test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
    add_cap(box.surface, 3, height);
    const SurfaceMesh before = box.surface;
    ASSERT_THAT(test::defects_of(before), IsEmpty());
    EXPECT_EQ(remove_nearly_flat_triangles(box.work), 1) << height;
    EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
    EXPECT_EQ(box.surface.vertices, before.vertices);
    EXPECT_EQ(box.surface.triangles.size(), before.triangles.size());
    EXPECT_GT(lowest(box.surface), 0.1);
    EXPECT_NEAR(domain_volume(box.surface), 1, 1e-6);
    ASSERT_THAT(box.acts, SizeIs(1));
    EXPECT_EQ(box.acts[0].kind, HealKind::nearly_flat);
    EXPECT_EQ(box.acts[0].at, before.vertices.back());
  }
}

TEST(NearlyFlatTriangles, one_upon_another_go_pass_by_pass) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 1));
  add_cap(box.surface, 0, 1e-7);
  // On a short side of the cap lies a lower one.
  const std::size_t cap = box.surface.triangles.size() - 1;
  const Triangle n = box.surface.triangles[cap];
  const Vec3 foot = 0.5 * (vertex_at(box.surface, n[0]) + vertex_at(box.surface, n[1]));
  const Vec3 up = normalized(vertex_at(box.surface, n[2]) - foot);
  box.surface.triangles[cap] = {n[2], n[0], n[1]};
  test::add_flat_triangle(box.surface, cap);
  box.surface.vertices.back() = box.surface.vertices.back() - 1e-9 * up;
  ASSERT_THAT(test::defects_of(box.surface), IsEmpty());
  ASSERT_LT(lowest(box.surface), 1e-8);
  EXPECT_GE(remove_nearly_flat_triangles(box.work), 2);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_GT(lowest(box.surface), 0.05);
}

TEST(NearlyFlatTriangles, needles_go_with_their_short_edge) {
  test::Damaged box(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  const std::size_t before = box.surface.triangles.size();
  add_needles(box.surface, 3, 1e-8);
  ASSERT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_EQ(remove_nearly_flat_triangles(box.work), 2);
  EXPECT_THAT(test::defects_of(box.surface), IsEmpty());
  EXPECT_THAT(box.surface.triangles, SizeIs(before));
  EXPECT_THAT(box.acts, SizeIs(2));
  EXPECT_NEAR(domain_volume(box.surface), 1, 1e-12);
}

TEST(NearlyFlatTriangles, a_vertex_inside_a_face_goes_before_one_on_a_border_of_patches) {
  test::Damaged box(shapes::unit_cube());
  SurfaceMesh& surface = box.surface;
  surface.patch_names = {"floor", "rest"};
  surface.patch_of_triangle.clear();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const TrianglePoints c = points_of(surface, t);
    surface.patch_of_triangle.push_back(c[0].z == 0 && c[1].z == 0 && c[2].z == 0 ? 0 : 1);
  }
  // A diagonal: the edge that no border of patches is.
  std::size_t t = 0;
  while (surface.patch_of_triangle[t] != 0) ++t;
  Triangle& n = surface.triangles[t];
  while (distance(vertex_at(surface, n[0]), vertex_at(surface, n[1])) < 1.2) n = {n[1], n[2], n[0]};
  const std::int32_t corner = n[0];
  const Vec3 at_corner = vertex_at(surface, corner);
  add_needles(surface, t, 1e-8);
  // The corner gets the higher number, which would go otherwise.
  const auto last = static_cast<std::int32_t>(surface.vertices.size()) - 1;
  std::swap(surface.vertices[static_cast<std::size_t>(corner)], surface.vertices.back());
  for (Triangle& nodes : surface.triangles) {
    for (std::int32_t& v : nodes) v = v == corner ? last : v == last ? corner : v;
  }
  EXPECT_EQ(remove_nearly_flat_triangles(box.work), 2);
  const auto is_used = [&surface](const Vec3& p) {
    return std::ranges::any_of(surface.triangles, [&](const Triangle& nodes) {
      return std::ranges::any_of(nodes, [&](std::int32_t v) { return vertex_at(surface, v) == p; });
    });
  };
  EXPECT_TRUE(is_used(at_corner));
  EXPECT_THAT(test::defects_of(surface), IsEmpty());
}

TEST(NearlyFlatTriangles, low_ones_of_good_shape_and_long_ones_with_height_stay) {
  const SurfaceMesh detail = shapes::box({0.5, 0.5, 0.5}, {0.5 + 1e-7, 0.5 + 1e-7, 0.5 + 1e-7}, 1);
  test::Damaged two(test::with_body(shapes::box({0, 0, 0}, {1, 1, 1}, 1), detail));
  add_cap(two.surface, 0, 1e-5);
  EXPECT_EQ(remove_nearly_flat_triangles(two.work), 0);
  EXPECT_THAT(two.acts, IsEmpty());
}

TEST(NearlyFlatTriangles, stay_where_something_lies_in_the_way) {
  // A cap along an edge of the cube: without it the wall below leans inwards.
  SurfaceMesh cube = shapes::unit_cube();
  add_cap(cube, triangle_at_edge(cube), 1e-9);
  const Vec3 tip = cube.vertices.back();
  test::Damaged free(cube);
  EXPECT_EQ(remove_nearly_flat_triangles(free.work), 1);
  const double e = 1e-10;
  const Vec3 below = tip - Vec3{0, 0.5 * e, 4 * e};
  const SurfaceMesh hole = shapes::box(below, below + Vec3{e, e, e}, 1);
  test::Damaged blocked(test::with_body(cube, hole));
  ASSERT_THAT(test::defects_of(blocked.surface), IsEmpty());
  const std::vector<Triangle> before = blocked.surface.triangles;
  EXPECT_EQ(remove_nearly_flat_triangles(blocked.work), 0);
  EXPECT_EQ(blocked.surface.triangles, before);
}

}  // namespace
}  // namespace tetfarm
