#include "mesh/layers/marching_direction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tetfarm {
namespace {

double visibility(const Vec3& direction, const std::vector<Vec3>& normals) {
  double least = 1;
  for (const Vec3& normal : normals) least = std::min(least, dot(direction, normal));
  return least;
}

TEST(MarchingDirection, of_a_flat_fan_is_the_normal) {
  const std::vector<Vec3> normals(7, Vec3{0, 0.6, 0.8});
  const MarchingDirection found = marching_direction(normals);
  EXPECT_EQ(found.direction, (Vec3{0, 0.6, 0.8}));
  EXPECT_DOUBLE_EQ(found.visibility, 1);
}

TEST(MarchingDirection,
     of_a_cubes_corner_sees_the_three_faces_alike_however_many_triangles_each_has) {
  const std::vector<Vec3> normals = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const MarchingDirection found = marching_direction(normals);
  const double third = 1 / std::sqrt(3.0);
  EXPECT_NEAR(distance(found.direction, {third, third, third}), 0, 1e-14);
  EXPECT_NEAR(found.visibility, third, 1e-14);
}

/// Of a flange as an STL file of six digits has it: a cone's triangles in pairs, and a flat face.
TEST(MarchingDirection, of_faces_that_are_almost_the_same_is_that_of_the_two_that_differ) {
  std::vector<Vec3> normals = {{0.3997923108446706, 0.0, 0.916605753958308},
                               {0.3997923108446706, 0.0, 0.916605753958308},
                               {0.39979534861342025, 0.0, 0.916604428980721},
                               {0.39979534861342025, -0.0, 0.916604428980721},
                               {0, -1, 0},
                               {0, -1, 0},
                               {0, -1, -0.0},
                               {0, -1, 0}};
  std::mt19937 random(7);
  for (int order = 0; order < 500; ++order) {
    std::shuffle(normals.begin(), normals.end(), random);
    EXPECT_NEAR(marching_direction(normals).visibility, std::sqrt(0.5), 1e-5);
  }
}

TEST(MarchingDirection, of_nearly_equal_normals_is_hardly_worse_than_that_of_one_of_them) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int powers = 3; powers < 17; ++powers) {
    const double apart = std::pow(10.0, -powers);
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<Vec3> normals;
      for (const Vec3& face : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (int i = 0; i < 4; ++i) {
          const Vec3 off{unit(random), unit(random), unit(random)};
          normals.push_back(normalized(face + apart * off));
        }
      }
      std::shuffle(normals.begin(), normals.end(), random);
      EXPECT_GT(marching_direction(normals).visibility, std::sqrt(1 / 3.0) - 4 * apart - 1e-5);
    }
  }
}

TEST(MarchingDirection, is_none_where_faces_look_away_from_each_other) {
  EXPECT_EQ(marching_direction(std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}}).visibility, 0);
  const std::vector<Vec3> round = {
      {1, 0, 0}, {-0.5, std::sqrt(0.75), 0}, {-0.5, -std::sqrt(0.75), 0}};
  EXPECT_EQ(marching_direction(round).visibility, 0);
}

/// Directions near the one that was found, and many others, see the worst face less well.
TEST(MarchingDirection, no_other_sees_the_worst_face_better) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec3> normals;
    for (int i = 0; i < 2 + trial % 9; ++i) {
      Vec3 n{normal(random), normal(random), normal(random) + 1.5};
      normals.push_back(normalized(n));
    }
    const MarchingDirection found = marching_direction(normals);
    if (found.visibility == 0) continue;
    EXPECT_NEAR(visibility(found.direction, normals), found.visibility, 1e-15);
    for (int other = 0; other < 200; ++other) {
      const double size = other % 2 == 0 ? 1e-3 : 1;
      const Vec3 step{normal(random), normal(random), normal(random)};
      const Vec3 direction = normalized(found.direction + size * step);
      EXPECT_LE(visibility(direction, normals), found.visibility + 1e-9);
    }
  }
}

TEST(MarchingDirection, order_makes_no_difference_but_of_rounding) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  std::vector<Vec3> normals;
  for (int i = 0; i < 300; ++i) {
    normals.push_back(
        normalized(Vec3{normal(random), normal(random), std::abs(normal(random)) + 2}));
  }
  const MarchingDirection first = marching_direction(normals);
  std::shuffle(normals.begin(), normals.end(), random);
  EXPECT_NEAR(distance(marching_direction(normals).direction, first.direction), 0, 1e-9);
}

}  // namespace
}  // namespace tetfarm
