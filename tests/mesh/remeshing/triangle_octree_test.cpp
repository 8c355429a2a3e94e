#include "mesh/remeshing/triangle_octree.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace tetfarm {
namespace {

using ::testing::UnorderedElementsAreArray;

/// Some large, most small, with corners on a coarse grid so that many only touch.
Box3 chance_box(std::mt19937& random) {
  const auto at = [&random] { return static_cast<double>(random() % 64); };
  const double side = random() % 10 == 0 ? 30 : static_cast<double>(random() % 3);
  Box3 box;
  const Vec3 low{at(), at(), at()};
  box.add(low);
  box.add(low + Vec3{side, 0.5 * side, static_cast<double>(random() % 2)});
  return box;
}

TEST(TriangleOctree, finds_exactly_what_overlaps_while_boxes_come_and_go) {
  std::mt19937 random(3);
  Box3 whole;
  whole.add(Vec3{0, 0, 0});
  whole.add(Vec3{94, 94, 94});
  TriangleOctree tree(whole);
  std::vector<std::pair<std::int32_t, Box3>> there;
  for (std::int32_t id = 0; id < 2000; ++id) {
    there.emplace_back(id, chance_box(random));
    tree.add(id, there.back().second);
    if (random() % 2 == 0) {
      auto& moved = there[random() % there.size()];
      // A little, or away.
      if (random() % 2 == 0) {
        moved.second = chance_box(random);
      } else {
        moved.second.add(moved.second.high + Vec3{0.25, 0, 0.25});
      }
      tree.move(moved.first, moved.second);
    }
    if (random() % 3 == 0) {
      const std::size_t gone = random() % there.size();
      tree.remove(there[gone].first);
      there.erase(there.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    if (id % 20 != 0) continue;
    const Box3 asked = chance_box(random);
    std::vector<std::int32_t> expected;
    for (const auto& [other, box] : there) {
      if (box.overlaps(asked)) expected.push_back(other);
    }
    std::vector<std::int32_t> found;
    tree.query(asked, [&found](std::int32_t i) { found.push_back(i); });
    EXPECT_THAT(found, UnorderedElementsAreArray(expected));
  }
}

TEST(TriangleOctree, finds_a_box_outside_of_what_it_was_made_for) {
  Box3 whole;
  whole.add(Vec3{0, 0, 0});
  whole.add(Vec3{1, 1, 1});
  TriangleOctree tree(whole);
  Box3 away;
  away.add(Vec3{5, 5, 5});
  away.add(Vec3{5.001, 5, 5});
  tree.add(7, away);
  std::vector<std::int32_t> found;
  tree.query(away, [&found](std::int32_t i) { found.push_back(i); });
  EXPECT_THAT(found, ::testing::ElementsAre(7));
}

}  // namespace
}  // namespace tetfarm
