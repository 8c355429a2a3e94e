#include "mesh/geometry/bowyer_watson.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

std::vector<Vec3> random_points(std::size_t count, int grid, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = grid == 0 ? std::uniform_real_distribution<double>(0, 1)(random)
                          : std::uniform_int_distribution<int>(0, grid)(random);
    }
  }
  return points;
}

double total_volume(const TetComplex& complex) {
  double sum = 0;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    const Tet& n = complex.nodes[t];
    const auto p = [&](std::size_t i) { return complex.points[static_cast<std::size_t>(n[i])]; };
    EXPECT_GT(orient3d(p(0), p(1), p(2), p(3)), 0);
    sum += tet_volume(p(0), p(1), p(2), p(3));
  }
  return sum;
}

/// No node of a neighbouring tet lies strictly inside a tet's sphere.
void expect_delaunay(const TetComplex& complex) {
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    const Tet& n = complex.nodes[t];
    for (const FaceHandle other : complex.neighbours[t]) {
      if (other == no_face) continue;
      const std::int32_t apex = complex.nodes[static_cast<std::size_t>(tet_of(other))]
                                             [static_cast<std::size_t>(face_of(other))];
      const auto p = [&](std::int32_t v) { return complex.points[static_cast<std::size_t>(v)]; };
      ASSERT_LE(insphere(p(n[0]), p(n[1]), p(n[2]), p(n[3]), p(apex)), 0);
    }
  }
}

TEST(BowyerWatson, random_points_give_delaunay_tets_that_fill_the_enclosing_tet) {
  for (const std::size_t count : {1U, 2U, 4U, 50U, 3000U}) {
    const DelaunayTets tets = bowyer_watson(random_points(count, 0, count));
    EXPECT_TRUE(validate(tets.complex).empty());
    EXPECT_TRUE(tets.duplicates.empty());
    expect_delaunay(tets.complex);
    const auto& p = tets.complex.points;
    EXPECT_NEAR(total_volume(tets.complex),
                std::abs(tet_volume(p[count], p[count + 1], p[count + 2], p[count + 3])),
                1e-9 * total_volume(tets.complex));
  }
}

TEST(BowyerWatson, cospherical_lattice_points_are_no_special_case) {
  std::vector<Vec3> lattice;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      for (int k = 0; k < 9; ++k) lattice.push_back({i * 0.1, j * 0.1, k * 0.1});
    }
  }
  const DelaunayTets tets = bowyer_watson(lattice);
  EXPECT_TRUE(validate(tets.complex).empty());
  expect_delaunay(tets.complex);
  total_volume(tets.complex);
}

TEST(BowyerWatson, duplicates_are_reported_and_every_other_point_is_in_the_mesh) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = random_points(400, 5, seed);
    const DelaunayTets tets = bowyer_watson(points);
    EXPECT_TRUE(validate(tets.complex).empty());
    EXPECT_GT(tets.duplicates.size(), 0U);
    for (const auto& [left_out, twin] : tets.duplicates) {
      EXPECT_EQ(points[static_cast<std::size_t>(left_out)], points[static_cast<std::size_t>(twin)]);
      EXPECT_EQ(tets.complex.node2tet[static_cast<std::size_t>(left_out)], -1);
    }
    std::size_t used = 0;
    for (std::size_t v = 0; v < points.size(); ++v) used += tets.complex.node2tet[v] >= 0;
    EXPECT_EQ(used + tets.duplicates.size(), points.size());
  }
}

TEST(BowyerWatson, coplanar_and_collinear_points_are_inserted) {
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) points.push_back({i * 1.0, 0, 0});
  for (int i = 0; i < 20; ++i) points.push_back({i * 0.5, i * 0.25 + 1, 0});
  const DelaunayTets tets = bowyer_watson(points);
  EXPECT_TRUE(validate(tets.complex).empty());
  EXPECT_TRUE(tets.duplicates.empty());
  total_volume(tets.complex);
}

TEST(BowyerWatson, the_same_points_give_the_same_tets) {
  const auto points = random_points(2000, 0, 3);
  EXPECT_EQ(bowyer_watson(points).complex.nodes, bowyer_watson(points).complex.nodes);
}

}  // namespace
}  // namespace tetfarm
