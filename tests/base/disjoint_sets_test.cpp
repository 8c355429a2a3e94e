#include "base/disjoint_sets.h"

#include <gmock/gmock.h>

#include <random>

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(DisjointSets, are_numbered_by_their_first_items) {
  DisjointSets sets(6);
  sets.join(4, 1);
  sets.join(5, 3);
  sets.join(3, 5);
  std::vector<std::int32_t> item2set;
  EXPECT_EQ(sets.number(item2set), 4);
  EXPECT_THAT(item2set, ElementsAre(0, 1, 2, 3, 1, 3));
}

TEST(DisjointSets, have_one_root_for_what_hangs_together_and_no_other) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    constexpr std::size_t items = 40;
    DisjointSets sets(items);
    std::vector<std::size_t> label(items);
    std::iota(label.begin(), label.end(), std::size_t{0});
    for (int joins = 0; joins < 25; ++joins) {
      const std::size_t a = random() % items;
      const std::size_t b = random() % items;
      sets.join(a, b);
      const std::size_t old = label[a];
      for (std::size_t& other : label) other = other == old ? label[b] : other;
    }
    for (std::size_t a = 0; a < items; ++a) {
      for (std::size_t b = 0; b < items; ++b) {
        EXPECT_EQ(sets.root(a) == sets.root(b), label[a] == label[b]);
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
