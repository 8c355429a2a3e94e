#include "mesh/adaptation/mesh_intersection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "base/error.h"
#include "tests/mesh/adaptation/transfer_shapes.h"

namespace tetfarm {
namespace {

using Corners = std::array<Vec2, 3>;

std::vector<std::int32_t> every_triangle(const TriangleComplex& complex) {
  std::vector<std::int32_t> all(complex.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(MeshIntersection, of_a_triangle_with_itself_is_all_of_it) {
  const Corners triangle{{{1, 1}, {4, 1}, {1, 3}}};
  const IntersectionPiece piece = intersection_of(triangle, triangle);
  EXPECT_DOUBLE_EQ(piece.area, 3);
  EXPECT_DOUBLE_EQ(piece.moment.x, 3);
  EXPECT_DOUBLE_EQ(piece.moment.y, 2);
  for (const double share : piece.shares) EXPECT_DOUBLE_EQ(share, 1);
}

TEST(MeshIntersection, of_two_crossing_triangles_is_their_hexagon) {
  // A star of David: the hexagon is two thirds of either triangle.
  const double h = std::sqrt(3.0);
  const Corners up{{{-1, 0}, {1, 0}, {0, h}}};
  const Corners down{{{1, 2 * h / 3}, {-1, 2 * h / 3}, {0, -h / 3}}};
  const IntersectionPiece piece = intersection_of(up, down);
  EXPECT_NEAR(piece.area, h * 2 / 3, 1e-15);
  for (const double share : piece.shares) EXPECT_NEAR(share, piece.area / 3, 1e-15);
  EXPECT_NEAR(piece.moment.x / piece.area + down[0].x, 0, 1e-15);
  EXPECT_NEAR(piece.moment.y / piece.area + down[0].y, h / 3, 1e-15);
}

TEST(MeshIntersection, of_triangles_that_only_touch_is_nothing) {
  const Corners triangle{{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(intersection_of(triangle, {{{0, 0}, {1, -1}, {1, 0}}}).area, 0);
  EXPECT_EQ(intersection_of(triangle, {{{1, 0}, {2, 0}, {1, 1}}}).area, 0);
  EXPECT_EQ(intersection_of(triangle, {{{5, 5}, {6, 5}, {5, 6}}}).area, 0);
}

TEST(MeshIntersection, has_shares_that_give_back_any_linear_function) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0, 1);
  int overlaps = 0;
  for (int k = 0; k < 500; ++k) {
    Corners a;
    Corners b;
    for (Vec2& p : a) p = {place(random), place(random)};
    for (Vec2& p : b) p = {place(random), place(random)};
    if (plane_test::turn(a[0], a[1], a[2]) < 0) std::swap(a[1], a[2]);
    if (plane_test::turn(b[0], b[1], b[2]) < 0) std::swap(b[1], b[2]);
    const IntersectionPiece piece = intersection_of(a, b);
    const auto field = [](const Vec2& p) { return 3 + 2 * p.x - 5 * p.y; };
    double by_shares = 0;
    for (std::size_t i = 0; i < 3; ++i) by_shares += piece.shares[i] * field(a[i]);
    const double by_moment = piece.area * field(b[0]) + 2 * piece.moment.x - 5 * piece.moment.y;
    EXPECT_NEAR(by_shares, by_moment, 1e-14);
    EXPECT_NEAR(piece.area, intersection_of(b, a).area, 1e-15);
    overlaps += piece.area > 0 ? 1 : 0;
  }
  EXPECT_GT(overlaps, 200);
}

TEST(MeshIntersection, covers_each_triangle_of_the_same_domain) {
  const TriangleComplex background = checked_complex(plane_test::shaken_square(13, 1));
  const PlaneMesh mesh = plane_test::thin_square(9, 2, 0.4, 1e-3);
  const TriangleComplex target = checked_complex(mesh);
  const std::vector<PlaneLocation> places = locate_nodes(MeshLocation(background), target);
  MeshIntersection intersection(background, target);
  std::vector<double> of_background(background.triangles.size(), 0);
  for (std::int32_t t = 0; t < target.size(); ++t) {
    const std::array seeds{places[at(target.node(t, 0))].triangle};
    double area = 0;
    for (const IntersectionPiece& piece : intersection.pieces_of(t, seeds)) {
      area += piece.area;
      of_background[at(piece.triangle)] += piece.area;
    }
    const auto& [a, b, c] = target.nodes(t);
    EXPECT_NEAR(area, plane_test::turn(target.point(a), target.point(b), target.point(c)) / 2,
                1e-16);
  }
  for (std::int32_t t = 0; t < background.size(); ++t) {
    const auto& [a, b, c] = background.nodes(t);
    EXPECT_NEAR(of_background[at(t)],
                plane_test::turn(background.point(a), background.point(b), background.point(c)) / 2,
                1e-16);
  }
}

TEST(MeshIntersection, does_not_go_beyond_what_touches) {
  // Two discs of one square each, apart: seeds in one do not reach the other.
  PlaneMesh both = plane_test::square(2);
  const PlaneMesh other = plane_test::square(2);
  const auto shift = static_cast<std::int32_t>(both.points.size());
  for (const Vec2& p : other.points) both.points.push_back({p.x + 1.1, p.y});
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({a + shift, b + shift, c + shift});
  }
  const TriangleComplex background = checked_complex(both);
  PlaneMesh bridge;
  bridge.points = {{0.9, 0.4}, {1.2, 0.4}, {1.2, 0.6}};
  bridge.triangles = {{0, 1, 2}};
  const TriangleComplex target = checked_complex(bridge);
  MeshIntersection intersection(background, target);
  const MeshLocation location(background);
  const auto area_from = [&](const std::vector<std::int32_t>& seeds) {
    double area = 0;
    for (const IntersectionPiece& piece : intersection.pieces_of(0, seeds)) area += piece.area;
    return area;
  };
  const std::int32_t left = location.locate({0.95, 0.42}, 0).triangle;
  const std::int32_t right = location.locate({1.15, 0.42}, 0).triangle;
  EXPECT_NEAR(area_from({left}), 0.1 * 0.1 * 2 / 3 / 2, 1e-15);
  EXPECT_NEAR(area_from({left}) + area_from({right}), area_from({left, right}), 1e-15);
  EXPECT_NEAR(area_from(every_triangle(background)), area_from({left, right}), 1e-15);
}

/// Strips across the unit square, n of them, along x or along y.
PlaneMesh strips(int n, bool along_x) {
  PlaneMesh mesh;
  for (int k = 0; k <= n; ++k) {
    const double s = static_cast<double>(k) / n;
    mesh.points.push_back(along_x ? Vec2{0, s} : Vec2{s, 1});
    mesh.points.push_back(along_x ? Vec2{1, s} : Vec2{s, 0});
    if (k == 0) continue;
    mesh.triangles.push_back({2 * k - 2, 2 * k - 1, 2 * k + 1});
    mesh.triangles.push_back({2 * k - 2, 2 * k + 1, 2 * k});
  }
  return mesh;
}

TEST(MeshIntersection, counts_pairs_of_meshes_that_lie_across_each_other) {
  const TriangleComplex background = checked_complex(strips(60, true));
  const TriangleComplex target = checked_complex(strips(60, false));
  // 120 triangles of either mesh, of which half of all pairs touch.
  MeshIntersection patient(background, target, 60);
  MeshIntersection impatient(background, target, 20);
  const auto all = [&](MeshIntersection& intersection) {
    for (std::int32_t t = 0; t < target.size(); ++t) {
      intersection.pieces_of(t, std::array{std::int32_t{0}});
    }
  };
  EXPECT_NO_THROW(all(patient));
  EXPECT_THROW(all(impatient), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
