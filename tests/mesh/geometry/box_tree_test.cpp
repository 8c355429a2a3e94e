#include "mesh/geometry/box_tree.h"

#include <gmock/gmock.h>

#include <random>
#include <utility>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Boxes with corners on a coarse grid, so that many only touch and some are flat.
std::vector<Box3> random_boxes(int n, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Box3> boxes(static_cast<std::size_t>(n));
  const auto at = [&random] { return static_cast<double>(random() % 40); };
  for (Box3& box : boxes) {
    const Vec3 low{at(), at(), at()};
    box.add(low);
    box.add(low + Vec3{static_cast<double>(random() % 4), static_cast<double>(random() % 4),
                       static_cast<double>(random() % 4)});
  }
  return boxes;
}

Pairs pairs_of(const BoxTree& tree) {
  Pairs pairs;
  tree.self_pairs([&pairs](std::int32_t i, std::int32_t j) { pairs.emplace_back(i, j); });
  return pairs;
}

TEST(BoxTree, finds_exactly_the_boxes_that_overlap) {
  const auto boxes = random_boxes(500, 1);
  const BoxTree tree(boxes);
  for (const Box3& wanted : random_boxes(100, 2)) {
    std::vector<std::int32_t> found;
    tree.query(wanted, [&found](std::int32_t i) { found.push_back(i); });
    std::vector<std::int32_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].overlaps(wanted)) expected.push_back(static_cast<std::int32_t>(i));
    }
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected));
  }
}

TEST(BoxTree, gives_every_overlapping_pair_once) {
  for (const int n : {1, 2, 3, 5, 60, 700}) {
    const auto boxes = random_boxes(n, 3);
    Pairs expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].overlaps(boxes[j])) {
          expected.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
        }
      }
    }
    Pairs found = pairs_of(BoxTree(boxes));
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << n << " boxes";
  }
}

TEST(BoxTree, keeps_equal_boxes_apart) {
  const std::vector<Box3> boxes(100, Box3{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(pairs_of(BoxTree(boxes)).size(), 100U * 99U / 2U);
}

TEST(BoxTree, stops_at_the_first_that_holds) {
  const BoxTree tree(std::vector<Box3>(50, Box3{{0, 0, 0}, {1, 1, 1}}));
  int calls = 0;
  EXPECT_TRUE(tree.any({{0, 0, 0}, {0, 0, 0}}, [&calls](std::int32_t) { return ++calls == 3; }));
  EXPECT_EQ(calls, 3);
  EXPECT_FALSE(tree.any({{2, 2, 2}, {3, 3, 3}}, [](std::int32_t) { return true; }));
}

TEST(BoxTree, answers_a_ray_as_a_flat_endless_box) {
  const auto cube = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  const BoxTree tree(triangle_boxes(cube.vertices, cube.triangles));
  int hits = 0;
  tree.query({{0.5, 0.4, 0.4}, {HUGE_VAL, 0.4, 0.4}}, [&hits](std::int32_t) { ++hits; });
  EXPECT_EQ(hits, 2);  // both triangles of the square on the face x = 1
}

TEST(BoxTree, without_boxes_finds_nothing) {
  const BoxTree tree;
  EXPECT_FALSE(tree.any({{0, 0, 0}, {1, 1, 1}}, [](std::int32_t) { return true; }));
  EXPECT_TRUE(pairs_of(tree).empty());
}

}  // namespace
}  // namespace tetfarm
