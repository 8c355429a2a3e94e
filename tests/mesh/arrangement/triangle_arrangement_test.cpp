#include "mesh/arrangement/triangle_arrangement.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

SurfaceMesh of_both(SurfaceMesh a, const SurfaceMesh& b) {
  const auto first = static_cast<std::int32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  a.patch_of_triangle.clear();
  return a;
}

double area_of(const TriangleChain& chain) {
  double area = 0;
  for (std::size_t t = 0; t < chain.triangles.size(); ++t) {
    const TrianglePoints p = chain.points_of(static_cast<std::int32_t>(t));
    area += chain.triangles[t].times * norm(cross(p[1] - p[0], p[2] - p[0])) / 2;
  }
  return area;
}

/// Whether every edge is used as often one way as the other.
bool is_cycle(const TriangleChain& chain) {
  std::map<std::array<std::int32_t, 2>, int> balance;
  for (const ChainTriangle& t : chain.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t.nodes[k];
      const std::int32_t b = t.nodes[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? t.times : -t.times;
    }
  }
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

void expect_arranged(const SurfaceMesh& surface, double area) {
  auto chain = arrange_triangles(surface, 1e-6);
  ASSERT_TRUE(chain);
  EXPECT_TRUE(is_cycle(*chain));
  EXPECT_NEAR(area_of(*chain), area, 1e-5 * area);
  for (ChainTriangle& t : chain->triangles) t.is_clear = false;
  EXPECT_THAT(meeting_pairs(*chain).value(), IsEmpty());
}

TEST(TriangleArrangement, divides_two_boxes_where_they_go_through_each_other) {
  expect_arranged(of_both(shapes::box({0, 0, 0}, {1, 1, 1}, 2),
                          shapes::box({0.53, 0.41, 0.37}, {2, 0.9, 0.8}, 2)),
                  6 + 2 * (1.47 * 0.49 + 1.47 * 0.43 + 0.49 * 0.43));
}

TEST(TriangleArrangement, what_lies_back_to_back_in_one_plane_is_gone) {
  expect_arranged(
      of_both(shapes::box({0, 0, 0}, {1, 1, 1}, 1), shapes::box({0.25, 0.5, 1}, {0.75, 1.5, 2}, 2)),
      6 + 2 * (0.5 + 0.5 + 1) - 2 * 0.25);
}

TEST(TriangleArrangement, faces_that_nearly_lie_on_each_other_come_to_an_end) {
  SurfaceMesh boxes = of_both(shapes::box({0, 0, 0}, {1, 1, 1}, 3),
                              of_both(shapes::box({0.5, 0, 0}, {1.5, 1, 1}, 2),
                                      shapes::box({0.25, 0.25, 1}, {0.75, 1.25, 2}, 1)));
  // No face lies along the axes any more, and none is quite flat.
  for (Vec3& p : boxes.vertices) {
    const double x = p.x * std::cos(0.3) - p.y * std::sin(0.3);
    const double y = p.x * std::sin(0.3) + p.y * std::cos(0.3);
    p = {x, y * std::cos(0.7) - p.z * std::sin(0.7), y * std::sin(0.7) + p.z * std::cos(0.7)};
  }
  auto chain = arrange_triangles(boxes, 1e-6);
  ASSERT_TRUE(chain);
  EXPECT_TRUE(is_cycle(*chain));
}

TEST(TriangleArrangement, keeps_triangles_that_meet_none_with_their_numbers) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  const auto chain = arrange_triangles(ball, 1e-6);
  ASSERT_TRUE(chain);
  ASSERT_THAT(chain->triangles, SizeIs(ball.triangles.size()));
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    EXPECT_EQ(chain->triangles[t].nodes, ball.triangles[t]);
    EXPECT_FALSE(chain->triangles[t].is_divided);
  }
  EXPECT_EQ(chain->vertices, ball.vertices);
}

TEST(TriangleArrangement, the_border_of_a_sheet_stays) {
  SurfaceMesh sheets;
  sheets.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {3, 3, 1}};
  sheets.triangles = {{0, 1, 2}, {3, 4, 5}};
  const auto chain = arrange_triangles(sheets, 1e-6);
  ASSERT_TRUE(chain);
  EXPECT_NEAR(area_of(*chain), 8 + std::sqrt(8.0), 1e-12);
}

}  // namespace
}  // namespace tetfarm
