#include "mesh/remeshing/surface_features.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::ptrdiff_t count_of(const SurfaceFeatures& features, VertexKind kind) {
  return std::ranges::count(features.kind, kind);
}

TEST(SurfaceFeatures, of_a_box_are_its_edges_corners_and_faces) {
  const SurfaceFeatures features = surface_features(shapes::box({0, 0, 0}, {1, 1, 1}, 3), 30);
  EXPECT_THAT(features.edges, SizeIs(12 * 3));
  EXPECT_EQ(count_of(features, VertexKind::corner), 8);
  EXPECT_EQ(count_of(features, VertexKind::on_curve), 12 * 2);
  EXPECT_EQ(features.face_count, 6);
}

TEST(SurfaceFeatures, of_a_smooth_sphere_are_none) {
  const SurfaceFeatures features = surface_features(shapes::sphere({0, 0, 0}, 1, 3), 30);
  EXPECT_THAT(features.edges, IsEmpty());
  EXPECT_THAT(features.kind, Each(VertexKind::smooth));
  EXPECT_EQ(features.face_count, 1);
}

TEST(SurfaceFeatures, are_the_borders_of_patches_in_a_plane_too) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 2);
  box.patch_of_triangle.clear();
  box.patch_names = {"all", "half"};
  for (const Triangle& t : box.triangles) {
    double x = 0;
    for (const std::int32_t v : t) x += box.vertices[static_cast<std::size_t>(v)].x / 3;
    box.patch_of_triangle.push_back(x < 0.5 ? 1 : 0);
  }
  const SurfaceFeatures features = surface_features(box, 30);
  EXPECT_THAT(features.edges, SizeIs(12 * 2 + 4 * 2));
  EXPECT_EQ(features.face_count, 6 + 4);
}

TEST(SurfaceFeatures, of_needles_are_not_made_by_their_normals) {
  SurfaceMesh box = shapes::unit_cube();
  box.patch_of_triangle.clear();
  // A needle on a diagonal of a face, whose own normal may point anywhere: its apex a hair off.
  Triangle t = box.triangles.front();
  const auto at = [&](std::int32_t v) { return box.vertices[static_cast<std::size_t>(v)]; };
  while (distance(at(t[0]), at(t[1])) < 1.1) std::rotate(t.begin(), t.begin() + 1, t.end());
  const Vec3 normal = normalized(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
  const auto middle = static_cast<std::int32_t>(box.vertices.size());
  box.vertices.push_back(0.5 * (at(t[0]) + at(t[1])) + 1e-7 * (at(t[2]) - at(t[0])) +
                         2e-7 * normal);
  box.triangles.front() = {t[0], t[1], middle};
  box.triangles.push_back({t[1], t[2], middle});
  box.triangles.push_back({t[2], t[0], middle});
  const SurfaceFeatures features = surface_features(box, 30);
  EXPECT_THAT(features.edges, SizeIs(12));
}

/// Its sides meet in angles of 30 degrees, to rounding.
SurfaceMesh prism_of_twelve_sides() {
  constexpr int sides = 12;
  SurfaceMesh prism;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    prism.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    prism.vertices.push_back({std::cos(angle), std::sin(angle), 1});
  }
  prism.vertices.push_back({0, 0, 0});
  prism.vertices.push_back({0, 0, 1});
  for (int i = 0; i < sides; ++i) {
    const int a = 2 * i;
    const int b = 2 * ((i + 1) % sides);
    prism.triangles.push_back({a, b, b + 1});
    prism.triangles.push_back({a, b + 1, a + 1});
    prism.triangles.push_back({b, a, 2 * sides});
    prism.triangles.push_back({a + 1, b + 1, 2 * sides + 1});
  }
  return prism;
}

TEST(SurfaceFeatures, an_angle_equal_to_the_wanted_one_is_smooth_all_round) {
  const SurfaceMesh prism = prism_of_twelve_sides();
  EXPECT_THAT(surface_features(prism, 30).edges, SizeIs(24));
  EXPECT_THAT(surface_features(prism, 29.9).edges, SizeIs(24 + 12));
}

}  // namespace
}  // namespace tetfarm
