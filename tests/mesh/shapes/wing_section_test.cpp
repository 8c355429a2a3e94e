#include "mesh/shapes/wing_section.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

TEST(WingSection, is_12_percent_thick_and_closed_behind) {
  double highest = 0;
  for (const SectionPoint& p : upper_half()) {
    highest = std::max(highest, p.at.z);
    EXPECT_GE(p.at.z, 0);
    EXPECT_NEAR(norm(p.normal), 1, 1e-14);
  }
  EXPECT_NEAR(highest, 0.06, 1e-4);
  EXPECT_EQ(upper_half().front().at, (Vec3{1, 0, 0}));
  EXPECT_EQ(upper_half().back().at, (Vec3{0, 0, 0}));
}

TEST(WingSection, turns_one_way_all_along) {
  const std::vector<SectionPoint> half = upper_half();
  for (std::size_t i = 1; i < half.size(); ++i) {
    EXPECT_GE(cross(half[i].normal, half[i - 1].normal).y, 0) << i;
  }
}

TEST(WingSection, rings_lie_in_each_other_and_end_as_a_circle) {
  const std::vector<SectionPoint> half = upper_half();
  const std::vector<Vec3> inner = upper_line(half, {0.9, 1});
  const std::vector<Vec3> outer = upper_line(half, {0.8, 1.2});
  for (const Vec3& p : inner) {
    for (std::size_t i = 0; i < outer.size(); i += 97) EXPECT_GT(distance(p, outer[i]), 0.1);
  }
  for (const Vec3& p : upper_line(half, {0, 10})) EXPECT_NEAR(norm(p), 10, 1e-12);
}

TEST(WingSection, points_on_a_line_are_even_and_keep_its_ends) {
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 2}};
  EXPECT_EQ(length_of(line), 3);
  EXPECT_THAT(even_points(line, 6),
              testing::ElementsAre(Vec3{0, 0, 0}, Vec3{0.5, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0.5},
                                   Vec3{1, 0, 1}, Vec3{1, 0, 1.5}, Vec3{1, 0, 2}));
}

}  // namespace
}  // namespace tetfarm
