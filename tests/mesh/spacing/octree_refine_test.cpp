#include "mesh/spacing/octree_refine.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// Sources at one place, none of which makes another needless.
SpacingDemand crowd(int sources) {
  const double background = 1;
  SpacingDemand demand{DemandTree({}, 0.5), {}, background, 0.5, background};
  for (int i = 0; i < sources; ++i) {
    demand.sources.push_back(source_demand({{{{0.5, 0.5, 0.5}, 0.03, 0.2, 0.4}}}, 0.5));
  }
  return demand;
}

Box3 unit_box() {
  Box3 box;
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{1, 1, 1});
  return box;
}

/// Small spacings, anywhere in the unit box.
std::vector<PointDemand> scattered_demands(int count, double background) {
  std::uint64_t state = 11;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  std::vector<PointDemand> demands;
  for (int i = 0; i < count; ++i) {
    const Vec3 at{next(), next(), next()};
    const double spacing = (0.05 + 0.3 * next()) * background;
    demands.push_back({at, spacing, surface_plateau * spacing});
  }
  return demands;
}

/// The rule of octree_build.h with every demand looked at in every cell; where a background is set.
class AskedEverywhere {
 public:
  AskedEverywhere(const std::vector<PointDemand>& demands, double growth, double background,
                  const GridFrame& frame)
      : demands_(demands), growth_(growth), background_(background), frame_(frame) {}

  bool is_split(const LatticeCell& cell) const {
    const CellDemand::Cell ball = demand_cell(frame_, cell);
    const double lowest = least(ball.centre, ball.half_diagonal);
    if (lowest >= background_) return false;
    if (cell.level < coarsest_level) return true;
    const double spacing = std::min(least(ball.centre, 0), 2 * lowest);
    return size_at_level(cell.level) * frame_.unit > cell_fit / lattice_ratio * spacing;
  }

 private:
  double least(const Vec3& point, double radius) const {
    double least = background_;
    for (const PointDemand& d : demands_) {
      const double beyond = std::max(0.0, distance(d.at, point) - radius - d.plateau);
      least = std::min(least, d.spacing + growth_ * beyond);
    }
    return least;
  }

  const std::vector<PointDemand>& demands_;
  double growth_;
  double background_;
  const GridFrame& frame_;
};

/// How many cells of the tree are not as they should be.
int count_differences(const RefinedTree& tree, const AskedEverywhere& rule, std::size_t node,
                      const LatticeCell& cell) {
  const bool is_split = tree.child_of[node] != 0;
  int differences = is_split == rule.is_split(cell) ? 0 : 1;
  if (!is_split) return differences;
  const std::int32_t half = size_at_level(cell.level + 1);
  for (std::size_t k = 0; k < 8; ++k) {
    differences += count_differences(tree, rule, static_cast<std::size_t>(tree.child_of[node]) + k,
                                     {cell.level + 1, corner_of(cell.low, half, k)});
  }
  return differences;
}

TEST(OctreeRefine, splits_as_if_all_demands_were_looked_at_in_every_cell) {
  constexpr double background = 0.2;
  const std::vector<PointDemand> demands = scattered_demands(60, background);
  const GridFrame frame = grid_frame(unit_box(), background);
  for (const double growth : {0.02, 0.1, 0.3, 1.0, 3.0}) {
    const SpacingDemand demand{DemandTree(demands, growth), {}, background, growth, background};
    const RefinedTree tree = refine(demand, frame, unit_box());
    EXPECT_GT(tree.child_of.size(), 1000U);
    const AskedEverywhere rule(demands, growth, background, frame);
    EXPECT_EQ(count_differences(tree, rule, 0, {0, {}}), 0) << growth;
  }
}

TEST(OctreeRefine, stops_when_its_work_is_more_than_it_may_be) {
  Box3 domain;
  domain.add(Vec3{0, 0, 0});
  domain.add(Vec3{1, 1, 1});
  const GridFrame frame = grid_frame(domain, 1);
  constexpr std::uint64_t looks = 3'000'000;
  EXPECT_NO_THROW(refine(crowd(2), frame, domain, looks));
  try {
    refine(crowd(100), frame, domain, looks);
    ADD_FAILURE() << "it went on";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("too many sources"));
  }
}

int deepest_level(const RefinedTree& tree, std::size_t node) {
  if (tree.child_of[node] == 0) return 0;
  int deepest = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    deepest =
        std::max(deepest, deepest_level(tree, static_cast<std::size_t>(tree.child_of[node]) + k));
  }
  return deepest + 1;
}

TEST(OctreeRefine, divides_no_cell_of_the_deepest_level_however_small_the_spacing) {
  constexpr double background = 1;
  constexpr double growth = 1;
  const SpacingDemand demand{
      DemandTree({{{0.3, 0.4, 0.6}, 1e-9, 0}}, growth), {}, background, growth, background};
  const GridFrame frame = grid_frame(unit_box(), background);
  EXPECT_EQ(deepest_level(refine(demand, frame, unit_box()), 0), octree_max_level);
}

}  // namespace
}  // namespace tetfarm
