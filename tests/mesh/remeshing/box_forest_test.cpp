#include "mesh/remeshing/box_forest.h"

#include <gtest/gtest.h>

#include <random>

namespace tetfarm {
namespace {

TEST(BoxForest, finds_the_nearest_of_the_group_asked_for) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  const auto point = [&] { return Vec3{place(random), place(random), place(random)}; };
  std::vector<Vec3> points;
  std::vector<Box3> boxes;
  std::vector<std::int32_t> group;
  for (int i = 0; i < 500; ++i) {
    points.push_back(point());
    boxes.emplace_back().add(points.back());
    group.push_back(static_cast<std::int32_t>(random() % 3));
  }
  const BoxForest forest(boxes, group, 4);
  for (int asked = 0; asked < 200; ++asked) {
    const Vec3 p = point();
    const auto of = static_cast<std::int32_t>(random() % 3);
    std::int32_t expected = -1;
    double least = 0.01;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d2 = norm2(points[i] - p);
      if (group[i] != of || d2 >= least) continue;
      least = d2;
      expected = static_cast<std::int32_t>(i);
    }
    const BoxForest::Nearest found = forest.nearest(of, p, 0.01, [&](std::int32_t i) {
      return norm2(points[static_cast<std::size_t>(i)] - p);
    });
    EXPECT_EQ(found.item, expected);
    EXPECT_EQ(found.distance2, least);
  }
}

TEST(BoxForest, a_group_without_items_has_nothing_near) {
  const BoxForest forest({}, {}, 2);
  EXPECT_EQ(forest.nearest(1, {0, 0, 0}, 1e9, [](std::int32_t) { return 0.0; }).item, -1);
}

}  // namespace
}  // namespace tetfarm
