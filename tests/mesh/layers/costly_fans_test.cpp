#include "mesh/layers/costly_fans.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "tests/mesh/layers/layered_bodies.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// A cube with fans along its edges, and no cells that fold.
class CostlyFansOfACube : public testing::Test {
 protected:
  static std::size_t lines_at(const LayerPlan& plan, std::int32_t foot) {
    return static_cast<std::size_t>(
        std::count_if(plan.lines.begin(), plan.lines.end(),
                      [&](const LayerLine& line) { return line.foot == foot; }));
  }

  std::int32_t foot_with(bool several) const {
    for (const LayerLine& line : cube_.plan.lines) {
      if ((lines_at(cube_.plan, line.foot) > 1) == several) return line.foot;
    }
    return -1;
  }

  /// All lines at the foot stop at so many layers as if cells folded there.
  void fold(std::int32_t foot, std::int32_t place, int stop) {
    for (LayerLine& line : cube_.plan.lines) {
      if (line.foot != foot) continue;
      line.stop = stop;
      line.reason = StopReason::fold;
      line.because_of = place;
    }
  }

  test::LayeredBody cube_{test::cube_in_box(4), test::fanned(0.02, 6, 60)};
};

TEST_F(CostlyFansOfACube, are_none_where_no_cells_fold) {
  EXPECT_TRUE(costly_fans(cube_.plan, cube_.surface, 3).empty());
  EXPECT_EQ(missing_layers(cube_.plan), 0);
}

TEST_F(CostlyFansOfACube, are_those_so_many_edges_from_where_cells_fold) {
  const std::int32_t edge = foot_with(true);
  fold(edge, edge, 2);
  const std::vector<CostlyFans> here = costly_fans(cube_.plan, cube_.surface, 0);
  ASSERT_EQ(here.size(), 1);
  EXPECT_THAT(here[0].fans, ElementsAre(edge));
  const std::vector<CostlyFans> round = costly_fans(cube_.plan, cube_.surface, 1);
  ASSERT_EQ(round.size(), 1);
  EXPECT_GT(round[0].fans.size(), 1);
  EXPECT_THAT(round[0].fans, Contains(edge));
  EXPECT_THAT(round[0].fans, Not(Contains(foot_with(false))));
}

TEST_F(CostlyFansOfACube, hold_the_feet_that_stop_because_of_their_place) {
  const std::int32_t edge = foot_with(true);
  const std::int32_t face = foot_with(false);
  fold(edge, edge, 2);
  fold(face, edge, 3);
  const std::vector<CostlyFans> costly = costly_fans(cube_.plan, cube_.surface, 0);
  ASSERT_EQ(costly.size(), 1);
  EXPECT_THAT(costly[0].held, ElementsAre(std::min(edge, face), std::max(edge, face)));
}

TEST_F(CostlyFansOfACube, are_not_to_blame_far_from_them) {
  const std::int32_t face = foot_with(false);
  fold(face, face, 2);
  EXPECT_TRUE(costly_fans(cube_.plan, cube_.surface, 0).empty());
}

TEST_F(CostlyFansOfACube, count_what_is_missing_once_for_each_foot_by_its_lowest_line) {
  const std::int32_t edge = foot_with(true);
  fold(edge, edge, 5);
  cube_.plan.lines[at(cube_.plan.vertex2line[at(edge)])].stop = 2;
  EXPECT_EQ(missing_layers_at(cube_.plan, {edge}), 4);
  EXPECT_EQ(missing_layers(cube_.plan), 4);
}

}  // namespace
}  // namespace tetfarm
