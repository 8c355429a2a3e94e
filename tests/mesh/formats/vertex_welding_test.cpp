#include "mesh/formats/vertex_welding.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(VertexWelding, gives_equal_points_the_number_of_the_first) {
  VertexWelding welding(0);
  EXPECT_EQ(welding.add({1, 2, 3}), 0);
  EXPECT_EQ(welding.add({3, 2, 1}), 1);
  EXPECT_EQ(welding.add({1, 2, 3}), 0);
  EXPECT_EQ(welding.take_points(), (std::vector<Vec3>{{1, 2, 3}, {3, 2, 1}}));
}

TEST(VertexWelding, takes_minus_zero_as_zero) {
  VertexWelding welding(4);
  EXPECT_EQ(welding.add({-0.0, 0, 1}), 0);
  EXPECT_EQ(welding.add({0, -0.0, 1}), 0);
  EXPECT_FALSE(std::signbit(welding.take_points()[0].x));
}

TEST(VertexWelding, grows_far_beyond_what_was_expected) {
  VertexWelding welding(1);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        for (int k = 0; k < 20; ++k) {
          ASSERT_EQ(welding.add({i * 0.25, j * 0.25, k * 0.25}), (i * 20 + j) * 20 + k);
        }
      }
    }
  }
  EXPECT_EQ(welding.take_points().size(), 8000U);
}

}  // namespace
}  // namespace tetfarm
