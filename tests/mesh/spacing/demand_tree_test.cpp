#include "mesh/spacing/demand_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tetfarm {
namespace {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_;
};

std::vector<PointDemand> some_demands(int count, Numbers& numbers) {
  std::vector<PointDemand> demands;
  for (int i = 0; i < count; ++i) {
    const double spacing = 0.01 + 0.2 * numbers.next();
    const Vec3 at{numbers.next(), numbers.next(), numbers.next()};
    demands.push_back({at, spacing, surface_plateau * spacing});
  }
  return demands;
}

double asking_everyone(const std::vector<PointDemand>& demands, double growth, const Vec3& p,
                       double radius, double limit) {
  for (const PointDemand& d : demands) {
    const double beyond = std::max(0.0, distance(d.at, p) - radius - d.plateau);
    limit = std::min(limit, d.spacing + growth * beyond);
  }
  return limit;
}

constexpr double limit = 0.35;

TEST(DemandTree, finds_what_asking_everyone_finds) {
  Numbers numbers(5);
  for (const double growth : {0.05, 0.3, 2.5}) {
    const std::vector<PointDemand> demands = some_demands(500, numbers);
    const DemandTree tree(demands, growth);
    DemandsInCell everywhere(tree);
    everywhere.enter({0.5, 0.5, 0.5}, 3, limit);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p{3 * numbers.next() - 1, 3 * numbers.next() - 1, 3 * numbers.next() - 1};
      EXPECT_EQ(everywhere.lowest(p, 0, limit), asking_everyone(demands, growth, p, 0, limit));
    }
  }
}

/// Enters cells of half the size each, down to where few demands are left, and asks in each.
class CellsInside {
 public:
  CellsInside(const std::vector<PointDemand>& demands, double growth)
      : demands_(demands), growth_(growth), tree_(demands, growth), inside_(tree_) {}

  void visit(const Vec3& centre, double half_edge, int depth) {
    const double radius = std::sqrt(3 * half_edge * half_edge);
    inside_.enter(centre, radius, limit);
    for (const double within : {0.0, radius}) {
      EXPECT_EQ(inside_.lowest(centre, within, limit),
                asking_everyone(demands_, growth_, centre, within, limit));
    }
    for (const double x : {-half_edge, half_edge}) {
      for (const double y : {-half_edge, half_edge}) {
        for (const double z : {-half_edge, half_edge}) {
          const Vec3 corner = centre + Vec3{x, y, z};
          EXPECT_EQ(inside_.lowest(corner, 0, limit),
                    asking_everyone(demands_, growth_, corner, 0, limit));
          if (depth > 0) visit(centre + 0.5 * Vec3{x, y, z}, 0.5 * half_edge, depth - 1);
        }
      }
    }
    inside_.leave();
  }

 private:
  const std::vector<PointDemand>& demands_;
  double growth_;
  DemandTree tree_;
  DemandsInCell inside_;
};

TEST(DemandsInCell, leave_out_no_demand_that_is_lowest_in_a_cell) {
  Numbers numbers(7);
  for (const double growth : {0.05, 0.3, 2.5}) {
    const std::vector<PointDemand> demands = some_demands(400, numbers);
    CellsInside(demands, growth).visit({0.5, 0.5, 0.5}, 1, 3);
    CellsInside(demands, growth).visit({0.3, 0.6, 0.4}, 0.05, 3);
  }
}

TEST(DemandsInCell, give_the_limit_when_nobody_asks) {
  const DemandTree tree({}, 0.3);
  DemandsInCell inside(tree);
  inside.enter({1, 2, 3}, 1, 7);
  EXPECT_EQ(inside.lowest({1, 2, 3}, 0, 7), 7);
  EXPECT_EQ(inside.lowest({1, 2, 3}, 1, 7), 7);
}

TEST(DemandsInCell, take_many_demands_at_one_place) {
  std::vector<PointDemand> demands(100, PointDemand{{1, 1, 1}, 0.5, 0});
  demands[40].spacing = 0.25;
  const DemandTree tree(demands, 0.3);
  DemandsInCell inside(tree);
  inside.enter({1, 1, 1}, 0.5, 7);
  inside.enter({1, 1, 1}, 0.1, 7);
  EXPECT_EQ(inside.lowest({1, 1, 1}, 0, 7), 0.25);
}

}  // namespace
}  // namespace tetfarm
