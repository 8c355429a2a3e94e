#include "json/meshing_rate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetfarm {
namespace {

/// A farm of `workers` that meshes leaves, each as fast as the others, as a display sees it. A leaf
/// comes to `actual` times the elements that were expected, all of a sudden at its end.
class MakeBelieveFarm {
 public:
  MakeBelieveFarm(int leaves, int workers, double actual)
      : leaves_(leaves), workers_(workers), actual_(actual) {}

  double seconds() const { return std::ceil(static_cast<double>(leaves_) / workers_) * leaf_s; }

  wire::JobStatus at(double seconds) const {
    wire::JobStatus status;
    status.set_stage("mesh");
    status.set_estimated_elements(leaves_ * expected);
    const int rounds = static_cast<int>(seconds / leaf_s);
    const int done = std::min(leaves_, rounds * workers_);
    const int running = std::min(leaves_ - done, workers_);
    status.set_leaves_made(static_cast<std::uint32_t>(leaves_));
    status.set_leaves_meshed(static_cast<std::uint32_t>(done));
    status.set_elements(static_cast<std::uint64_t>(done * expected * actual_));
    status.set_elements_under_way(running * expected * (seconds - rounds * leaf_s) / leaf_s);
    return status;
  }

 private:
  static constexpr double expected = 100'000;
  static constexpr double leaf_s = 60;
  int leaves_;
  int workers_;
  double actual_;
};

/// Seconds left as the display would tell them at each second but the first ones and the last.
std::vector<double> told_seconds_left(const MakeBelieveFarm& farm, MeshingRate& rate) {
  std::vector<double> told;
  for (double t = 0; t < farm.seconds() - 1; t += 0.25) {
    const wire::JobStatus status = farm.at(t);
    rate.note(status, static_cast<std::int64_t>(1000 * t));
    if (rate.tets_per_second() == 0) continue;
    told.push_back((status.estimated_elements() - made_elements(status)) / rate.tets_per_second());
  }
  return told;
}

TEST(MeshingRate, of_a_single_leaf_tells_how_long_it_will_take_while_it_runs) {
  const MakeBelieveFarm farm(1, 1, 1);
  MeshingRate rate;
  const std::vector<double> left = told_seconds_left(farm, rate);
  ASSERT_GT(left.size(), 200U);
  EXPECT_NEAR(left.front(), 59, 1);
  EXPECT_NEAR(left[left.size() / 2], 30, 1);
  EXPECT_NEAR(rate.share(), 59.0 / 60, 0.01);
}

TEST(MeshingRate, does_not_go_by_when_leaves_happen_to_end) {
  const MakeBelieveFarm farm(16, 4, 1);
  MeshingRate rate;
  const std::vector<double> left = told_seconds_left(farm, rate);
  for (std::size_t i = 1; i < left.size(); ++i) EXPECT_LE(left[i], left[i - 1] + 0.5) << i;
  EXPECT_NEAR(left[left.size() / 4], 0.75 * farm.seconds(), 3);
}

TEST(MeshingRate, bears_leaves_that_come_to_other_numbers_than_expected) {
  for (const double actual : {0.8, 1.2}) {
    const MakeBelieveFarm farm(8, 2, actual);
    MeshingRate rate;
    double last_share = 0;
    for (double t = 0; t < farm.seconds(); t += 1) {
      rate.note(farm.at(t), static_cast<std::int64_t>(1000 * t));
      EXPECT_GE(rate.share(), last_share);
      EXPECT_LE(rate.share(), 1);
      EXPECT_GE(rate.tets_per_second(), 0);
      last_share = rate.share();
    }
    EXPECT_NEAR(rate.tets_per_second(), 2 * 100'000 / 60.0, 0.25 * 2 * 100'000 / 60.0);
  }
}

TEST(MeshingRate, begins_when_meshing_does) {
  MeshingRate rate;
  wire::JobStatus status;
  status.set_stage("inspect");
  rate.note(status, 0);
  const MakeBelieveFarm farm(1, 1, 1);
  for (double t = 0; t <= 30; t += 1) {
    rate.note(farm.at(t), static_cast<std::int64_t>(1000 * (t + 500)));
  }
  EXPECT_NEAR(rate.tets_per_second(), 100'000 / 60.0, 1);
}

TEST(MeshingRate, of_a_run_that_goes_on_counts_from_what_was_there) {
  const MakeBelieveFarm farm(4, 1, 1);
  MeshingRate rate;
  for (double t = 130; t <= 170; t += 1) rate.note(farm.at(t), static_cast<std::int64_t>(1000 * t));
  EXPECT_NEAR(rate.tets_per_second(), 100'000 / 60.0, 1);
}

TEST(MeshingRate, is_not_known_in_the_first_second_nor_before_anything_is_made) {
  MeshingRate rate;
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_estimated_elements(1000);
  rate.note(status, 0);
  status.set_elements_under_way(100);
  rate.note(status, 900);
  EXPECT_EQ(rate.tets_per_second(), 0);
  MeshingRate still;
  status.set_elements_under_way(0);
  still.note(status, 0);
  still.note(status, 10'000);
  EXPECT_EQ(still.tets_per_second(), 0);
  EXPECT_FALSE(seconds_of_meshing_left(status, still.tets_per_second()));
}

}  // namespace
}  // namespace tetfarm
