#include "mesh/decompose/shadow_grid.h"

#include <gtest/gtest.h>

#include <random>

namespace tetfarm {
namespace {

Box3 random_box(std::mt19937& random, double largest) {
  const auto number = [&random] { return static_cast<double>(random() % 10000) / 10000; };
  const Vec3 low{number(), number(), number()};
  return {low, low + largest * Vec3{number(), number(), number()}};
}

bool shadows_overlap(const Box3& a, const Box3& b) {
  return a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

TEST(ShadowGrid, finds_each_box_on_the_same_lines_once) {
  std::mt19937 random(7);
  for (const double largest : {0.0, 0.02, 0.3, 1.0}) {
    std::vector<Box3> boxes;
    for (int i = 0; i < 300; ++i) boxes.push_back(random_box(random, largest));
    const ShadowGrid grid(boxes);
    for (int i = 0; i < 200; ++i) {
      const Box3 asked = random_box(random, 0.2);
      std::vector<int> visits(boxes.size(), 0);
      grid.query(asked, [&](std::int32_t k) { ++visits[static_cast<std::size_t>(k)]; });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        EXPECT_EQ(visits[k], shadows_overlap(asked, boxes[k]) ? 1 : 0);
      }
    }
  }
}

TEST(ShadowGrid, without_boxes_finds_none) {
  const ShadowGrid grid({});
  grid.query({{0, 0, 0}, {1, 1, 1}}, [](std::int32_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace tetfarm
