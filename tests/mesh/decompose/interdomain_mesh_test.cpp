#include "mesh/decompose/interdomain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/mesh/decompose/flat_cut.h"

namespace tetfarm {
namespace {

TEST(InterdomainMesh, keeps_the_rim_and_fills_the_region) {
  const FlatCut cut = cap_of_sphere();
  double area = 0;
  for (const auto& [i, j, k] : cut.mesh.planar.triangles) {
    const Vec2& a = cut.mesh.planar.points[at(i)];
    const Vec2& b = cut.mesh.planar.points[at(j)];
    const Vec2& c = cut.mesh.planar.points[at(k)];
    area += 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  EXPECT_NEAR(area, 3.14 * (1 - 0.49), 0.15);
  for (std::size_t i = 0; i < cut.mesh.rim.size(); ++i) {
    EXPECT_EQ(node_position(cut.mesh, cut.subdomain, static_cast<std::int32_t>(i)),
              cut.subdomain.vertices[at(cut.mesh.rim[i].from)]);
  }
}

TEST(InterdomainMesh, has_no_chord_that_is_an_edge_of_the_surface) {
  // A spacing so large that the mesh would have chords everywhere.
  const FlatCut cut(shapes::box({0, 0, 0}, {1, 0.25, 1}, 4), make_cut_plane({0, 0, 1}, 0.4), 10);
  std::set<std::array<std::int32_t, 2>> surface;
  for (const Triangle& t : cut.subdomain.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      surface.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    }
  }
  ASSERT_FALSE(cut.mesh.planar.triangles.empty());
  int chords = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(cut.mesh.planar.triangles.size()); ++t) {
    for (const auto& [a, b] : chords_of_triangle(cut.mesh, t)) {
      ++chords;
      const auto [v, w] = std::minmax(cut.mesh.rim_vertices[at(a)], cut.mesh.rim_vertices[at(b)]);
      EXPECT_FALSE(surface.contains({v, w}));
    }
  }
  EXPECT_GT(chords, 0);
}

}  // namespace
}  // namespace tetfarm
