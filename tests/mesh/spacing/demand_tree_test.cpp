#include "mesh/spacing/demand_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace tetfarm {
namespace {

TEST(DemandTree, finds_what_asking_everyone_finds) {
  std::uint64_t state = 5;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  for (const double growth : {0.05, 0.3, 2.5}) {
    std::vector<PointDemand> demands;
    for (int i = 0; i < 500; ++i) {
      const double spacing = 0.01 + 0.2 * next();
      demands.push_back({{next(), next(), next()}, spacing, surface_plateau * spacing});
    }
    const DemandTree tree(demands, growth);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p{3 * next() - 1, 3 * next() - 1, 3 * next() - 1};
      double expected = 0.35;
      for (const PointDemand& d : demands) {
        const double beyond = std::max(0.0, distance(d.at, p) - d.plateau);
        expected = std::min(expected, d.spacing + growth * beyond);
      }
      EXPECT_EQ(tree.lowest(p, 0, 0.35), expected);
    }
  }
}

TEST(DemandTree, gives_the_limit_when_nobody_asks) {
  EXPECT_EQ(DemandTree({}, 0.3).lowest({1, 2, 3}, 0, 7), 7);
}

TEST(DemandTree, takes_many_demands_at_one_place) {
  std::vector<PointDemand> demands(100, PointDemand{{1, 1, 1}, 0.5, 0});
  demands[40].spacing = 0.25;
  EXPECT_EQ(DemandTree(demands, 0.3).lowest({1, 1, 1}, 0, 7), 0.25);
}

}  // namespace
}  // namespace tetfarm
