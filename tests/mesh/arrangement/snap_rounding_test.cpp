#include "mesh/arrangement/snap_rounding.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(SnapRounding, edges_that_cross_share_a_new_point_between_them) {
  std::vector<Vec3> points = {{0, 0, 0}, {2, 2, 0}, {0, 2, 1}, {2, 0, 1}};
  const auto chains = snap_round(points, {{0, 1}, {2, 3}}, 2, 1e-3).value();
  EXPECT_THAT(chains[0], ElementsAre(0, 4, 1));
  EXPECT_THAT(chains[1], ElementsAre(2, 4, 3));
  EXPECT_EQ(points[4], (Vec3{1, 1, 0.5}));
}

TEST(SnapRounding, an_edge_is_led_through_points_that_it_nearly_passes_in_their_order) {
  std::vector<Vec3> points = {{0, 0, 0}, {4, 0, 0}, {3, 1e-4, 0}, {1, -1e-4, 0}, {2, 1, 0}};
  const auto chains = snap_round(points, {{0, 1}, {2, 4}, {3, 4}}, 2, 1e-3).value();
  EXPECT_THAT(chains[0], ElementsAre(0, 3, 2, 1));
  EXPECT_THAT(chains[1], SizeIs(2));
  EXPECT_THAT(points, SizeIs(5));
}

TEST(SnapRounding, edges_along_each_other_get_the_same_pieces) {
  std::vector<Vec3> points = {{0, 0, 0}, {3, 0, 0}, {1, 1e-5, 0}, {4, -1e-5, 0}};
  const auto chains = snap_round(points, {{0, 1}, {2, 3}}, 2, 1e-3).value();
  EXPECT_THAT(chains[0], ElementsAre(0, 2, 1));
  EXPECT_THAT(chains[1], ElementsAre(2, 1, 3));
}

}  // namespace
}  // namespace tetfarm
