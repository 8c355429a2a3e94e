#include "mesh/cosmetics/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/core/tet_quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

TEST(SineQuality, is_eight_ninths_for_the_regular_tet) {
  EXPECT_NEAR(quality({1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}), 8.0 / 9, 1e-14);
}

TEST(SineQuality, is_the_squared_smallest_sine_of_the_dihedral_angles) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    Vec3 p[4];
    for (std::uint64_t j = 0; j < 4; ++j) p[j] = trial::random_vector(7, 4 * i + j);
    if (tet_volume(p[0], p[1], p[2], p[3]) < 0) std::swap(p[0], p[1]);
    const DihedralCosines cosines = dihedral_cosines(p[0], p[1], p[2], p[3]);
    const double cosine = std::max(cosines.of_smallest, -cosines.of_largest);
    EXPECT_NEAR(quality(p[0], p[1], p[2], p[3]), 1 - cosine * cosine, 1e-10);
  }
}

TEST(SineQuality, is_zero_for_flat_and_negative_for_inverted_tets) {
  EXPECT_EQ(quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0}), 0);
  EXPECT_LT(quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 0);
  EXPECT_EQ(quality({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}), 0);
}

TEST(SineQuality, does_not_depend_on_size) {
  for (const double s : {1e-15, 1e-3, 1e15}) {
    EXPECT_NEAR(quality({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}),
                quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1e-12);
  }
}

TEST(SineQuality, of_an_angle_is_its_squared_sine) {
  for (const double degrees : {0.0, 1.0, 20.0, 45.0, 70.5, 90.0}) {
    const double sine = std::sin(degrees * 3.14159265358979323846 / 180);
    EXPECT_NEAR(quality_of_angle(degrees), sine * sine, 1e-15);
  }
}

TEST(SineQuality, of_two_tets_is_the_smaller_one) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    std::array<Vec3, 5> p;
    for (std::size_t k = 0; k < 5; ++k) p[k] = trial::random_vector(7, 5 * i + k);
    const double expected =
        std::min(quality(p[0], p[1], p[2], p[3]), quality(p[0], p[2], p[1], p[4]));
    EXPECT_NEAR(quality_of_two(p[0], p[1], p[2], p[3], p[4]), expected, 1e-12);
  }
  const Vec3 a{0, 0, 0};
  EXPECT_EQ(quality_of_two(a, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, -1}), 0);
}

TEST(SineQuality, over_two_faces_is_that_of_the_worse_to_the_last_bit) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    std::array<Vec3, 7> p;
    for (std::size_t k = 0; k < 7; ++k) p[k] = trial::random_vector(8, 7 * i + k);
    const double expected =
        std::min(quality(p[0], p[1], p[2], p[6]), quality(p[3], p[4], p[5], p[6]));
    EXPECT_EQ(quality_over_two({p[0], p[1], p[2]}, {p[3], p[4], p[5]}, p[6]), expected);
  }
}

}  // namespace
}  // namespace tetfarm::cosmetics
