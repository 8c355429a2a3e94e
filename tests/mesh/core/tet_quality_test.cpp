#include "mesh/core/tet_quality.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

const Vec3 origin{0, 0, 0};
const Vec3 x{1, 0, 0};
const Vec3 y{0, 1, 0};
const Vec3 z{0, 0, 1};

TEST(TetQuality, the_regular_tet_has_ratio_one_and_equal_angles) {
  const Vec3 a{1, 1, 1};
  const Vec3 b{-1, 1, -1};
  const Vec3 c{1, -1, -1};
  const Vec3 d{-1, -1, 1};
  ASSERT_GT(tet_volume(a, b, c, d), 0);
  EXPECT_NEAR(radius_ratio(a, b, c, d), 1, 1e-14);
  EXPECT_NEAR(dihedral_range(a, b, c, d).min_deg, 70.528779365509308, 1e-10);
  EXPECT_NEAR(dihedral_range(a, b, c, d).max_deg, 70.528779365509308, 1e-10);
  EXPECT_NEAR(dihedral_cosines(a, b, c, d).of_smallest, 1.0 / 3, 1e-14);
}

TEST(TetQuality, the_corner_of_a_cube_has_right_angles) {
  const DihedralRange range = dihedral_range(origin, x, y, z);
  EXPECT_NEAR(range.max_deg, 90, 1e-12);
  EXPECT_NEAR(range.min_deg, 54.735610317245346, 1e-10);
  // inradius 1 / (3 + sqrt 3), circumradius sqrt 3 / 2
  EXPECT_NEAR(radius_ratio(origin, x, y, z), 3 / (3 + std::sqrt(3.0)) / (std::sqrt(3.0) / 2),
              1e-14);
}

TEST(TetQuality, only_tets_of_no_smaller_angle_are_passed_over) {
  std::uint64_t state = 3;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  const auto point = [&next] {
    const double px = next(), py = next(), pz = next();
    return Vec3{px, py, pz};
  };
  int passed_over = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const double smallest = dihedral_cosines(a, b, c, d).of_smallest;
    for (const double cosine : {-1.0, 0.0, 0.5, 0.9, 0.99 * smallest, smallest, 1.01 * smallest}) {
      if (may_have_smaller_dihedral(a, b, c, d, cosine)) continue;
      EXPECT_LE(smallest, cosine);
      ++passed_over;
    }
  }
  EXPECT_GT(passed_over, 1000);
  EXPECT_FALSE(may_have_smaller_dihedral(origin, x, y, z, 0.6));
  EXPECT_TRUE(may_have_smaller_dihedral(origin, x, y, -z, 0.99)) << "inverted";
}

TEST(TetQuality, size_and_place_do_not_matter) {
  const Vec3 shift{100, -50, 25};
  const auto moved = [&](const Vec3& p) { return shift + 1e-3 * p; };
  EXPECT_NEAR(radius_ratio(moved(origin), moved(x), moved(y), moved(z)),
              radius_ratio(origin, x, y, z), 1e-9);
  EXPECT_NEAR(dihedral_range(moved(origin), moved(x), moved(y), moved(z)).min_deg,
              dihedral_range(origin, x, y, z).min_deg, 1e-7);
}

TEST(TetQuality, flat_and_inverted_tets_are_the_worst_there_is) {
  const Vec3 flat{0.3, 0.3, 0};
  for (const Vec3& top : {flat, -z}) {
    EXPECT_EQ(radius_ratio(origin, x, y, top), 0);
    EXPECT_EQ(dihedral_range(origin, x, y, top).min_deg, 0);
    EXPECT_NEAR(dihedral_range(origin, x, y, top).max_deg, 180, 1e-12);
  }
  EXPECT_EQ(dihedral_cosines(origin, origin, origin, origin).of_smallest, 1);
}

TEST(TetQuality, a_sliver_has_small_and_large_angles) {
  const DihedralRange range = dihedral_range({1, 0, 0}, {-1, 0, 0}, {0, 1, 0.01}, {0, -1, 0.01});
  const DihedralRange mirrored = dihedral_range({-1, 0, 0}, {1, 0, 0}, {0, 1, 0.01}, {0, -1, 0.01});
  const DihedralRange sliver = range.min_deg > mirrored.min_deg ? range : mirrored;
  EXPECT_GT(sliver.min_deg, 0.1);
  EXPECT_LT(sliver.min_deg, 2);
  EXPECT_GT(sliver.max_deg, 178);
}

}  // namespace
}  // namespace tetfarm
