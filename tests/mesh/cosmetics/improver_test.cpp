#include "mesh/cosmetics/improver.h"

#include <gmock/gmock.h>

#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// The bad tets of a ball of points by chance, ready for a pass.
struct Trial {
  explicit Trial(double wanted_deg = 30, double rebuilt_deg = 20)
      : complex(make_tet_complex(trial::random_ball(1, 30, 3))),
        improver{.work = WorkMesh(complex, 42),
                 .options = options,
                 .aims = {quality_of_angle(wanted_deg), quality_of_angle(rebuilt_deg),
                          quality_of_angle(std::max(40.0, wanted_deg))},
                 .report = {},
                 .queue = {},
                 .given_up = {},
                 .node2settled = {}} {
    std::vector<std::int32_t> all;
    for (std::int32_t t = 0; t < std::ssize(complex.nodes); ++t) all.push_back(t);
    improver.queue_bad(all);
  }
  double worst() const {
    double worst = 1;
    for (const Tet& tet : complex.nodes) {
      if (tet[0] >= 0) worst = std::min(worst, quality(complex, tet));
    }
    return worst;
  }

  CosmeticOptions options;
  TetComplex complex;
  Improver improver;
};

TEST(Improver, queues_what_is_below_its_aim_worst_first) {
  Trial trial;
  double before = -1;
  std::size_t queued = 0;
  for (; !trial.improver.queue.empty(); trial.improver.queue.pop(), ++queued) {
    const BadTet bad = trial.improver.queue.top();
    EXPECT_GE(bad.quality, before);
    EXPECT_LT(bad.quality, trial.improver.aims.wanted);
    EXPECT_EQ(bad.quality, quality(trial.complex, trial.complex.nodes[at(bad.tet)]));
    before = bad.quality;
  }
  EXPECT_GT(queued, 50U);
}

TEST(Improver, works_the_queue_off_and_keeps_what_nothing_helped) {
  Trial trial;
  const double before = trial.worst();
  run_pass(trial.improver, false);
  EXPECT_THAT(validate(trial.complex), IsEmpty());
  EXPECT_TRUE(trial.improver.queue.empty());
  EXPECT_GT(trial.worst(), before);
  EXPECT_GT(trial.improver.report.swaps, 0);
  EXPECT_GT(trial.improver.report.moves, 0);
  EXPECT_EQ(trial.improver.report.collapses + trial.improver.report.splits, 0) << "not thorough";
  for (std::int32_t t = 0; t < std::ssize(trial.complex.nodes); ++t) {
    if (!trial.complex.is_live(t)) continue;
    const double now = quality(trial.complex, trial.complex.nodes[at(t)]);
    if (now >= trial.improver.aims.wanted) continue;
    EXPECT_TRUE(std::ranges::any_of(trial.improver.given_up, [&](const GivenUp& item) {
      return item.bad == BadTet{now, t};
    })) << t;
  }
}

TEST(Improver, collapses_and_splits_in_a_thorough_pass_only) {
  Trial trial(45, 40);
  run_pass(trial.improver, true);
  EXPECT_GT(trial.improver.report.collapses + trial.improver.report.splits, 0);
  Trial mild(45, 0);
  run_pass(mild.improver, true);
  EXPECT_EQ(mild.improver.report.collapses + mild.improver.report.splits, 0)
      << "nothing is bad enough to be rebuilt";
  Trial to_wanted(45, 0);
  to_wanted.options.rebuilds_to_wanted = true;
  run_pass(to_wanted.improver, true);
  EXPECT_GT(to_wanted.improver.report.collapses + to_wanted.improver.report.splits, 0);
}

TEST(Improver, ends_a_pass_when_its_attempts_are_spent) {
  Trial trial;
  trial.improver.attempts = 7;
  run_pass(trial.improver, false);
  EXPECT_EQ(trial.improver.attempts, 0);
  EXPECT_EQ(trial.improver.report.attempts, 7);
  EXPECT_FALSE(trial.improver.queue.empty());
}

TEST(Improver, counts_attempts_in_its_report_and_off_those_that_are_left) {
  Trial trial;
  trial.improver.attempts = 100;
  trial.improver.count_attempts(4);
  trial.improver.count_attempts(1);
  EXPECT_EQ(trial.improver.attempts, 95);
  EXPECT_EQ(trial.improver.report.attempts, 5);
}

TEST(Improver, knows_a_node_as_settled_until_its_ball_changes) {
  Trial trial;
  Improver& improver = trial.improver;
  EXPECT_FALSE(improver.is_settled(50));
  improver.settle(50);
  EXPECT_TRUE(improver.is_settled(50));
  EXPECT_FALSE(improver.is_settled(49));
  improver.work.node2change[50] = ++improver.work.changes;
  EXPECT_FALSE(improver.is_settled(50));
  improver.settle(50);
  EXPECT_TRUE(improver.is_settled(50));
}

TEST(Improver, queues_again_what_has_changed_since_or_may_be_rebuilt) {
  Trial trial(50, 35);
  Improver& improver = trial.improver;
  run_pass(improver, false);
  std::erase_if(improver.given_up,
                [&](const GivenUp& item) { return !improver.is_current(item.bad); });
  const auto all = improver.given_up;
  ASSERT_GT(all.size(), 3U);
  for (GivenUp& item : improver.given_up) item.changes = improver.work.changes;
  requeue(improver, false);
  EXPECT_TRUE(improver.queue.empty()) << "nothing has changed";
  EXPECT_THAT(improver.given_up, SizeIs(all.size()));
  requeue(improver, true);
  EXPECT_EQ(improver.queue.size(),
            static_cast<std::size_t>(std::ranges::count_if(all, [&](const GivenUp& item) {
              return item.bad.quality < improver.aims.rebuilt;
            })));
  EXPECT_EQ(improver.queue.size() + improver.given_up.size(), all.size());
}

TEST(Improver, queues_again_where_a_node_that_may_move_has_changed_or_two_that_may_not) {
  Trial trial;
  Improver& improver = trial.improver;
  run_pass(improver, false);
  // Changes by hand, later than all others.
  const auto is_requeued = [&](const BadTet& bad, const std::vector<std::int32_t>& changed) {
    auto changes = improver.work.node2change;
    improver.given_up = {{bad, improver.work.changes}};
    for (const std::int32_t v : changed) {
      improver.work.node2change[at(v)] = improver.work.changes + 1;
    }
    improver.queue = {};
    requeue(improver, false);
    improver.work.node2change = std::move(changes);
    return !improver.queue.empty();
  };
  int looked_at = 0;
  for (std::int32_t t = 0; t < std::ssize(trial.complex.nodes); ++t) {
    if (!trial.complex.is_live(t)) continue;
    const BadTet bad{improver.work.quality_of(t), t};
    std::vector<std::int32_t> fixed;
    std::vector<std::int32_t> free;
    for (const std::int32_t v : improver.work.tet(t)) {
      (improver.work.may_move(v) ? free : fixed).push_back(v);
    }
    if (fixed.size() < 2 || free.empty()) continue;
    ++looked_at;
    EXPECT_FALSE(is_requeued(bad, {}));
    EXPECT_TRUE(is_requeued(bad, {free[0]}));
    EXPECT_FALSE(is_requeued(bad, {fixed[0]}));
    EXPECT_TRUE(is_requeued(bad, {fixed[0], fixed[1]}));
  }
  EXPECT_GT(looked_at, 10);
}

TEST(Improver, lists_what_was_given_up_below_a_quality_worst_first_without_what_is_stale) {
  Trial trial;
  Improver& improver = trial.improver;
  const double q0 = improver.work.quality_of(0);
  const double q1 = improver.work.quality_of(1);
  improver.given_up = {{{std::max(q0, q1), q0 > q1 ? 0 : 1}, 0},
                       {{std::min(q0, q1), q0 > q1 ? 1 : 0}, 0},
                       {{q0 + 0.001, 0}, 0}};
  const auto worst = worst_given_up(improver, 1);
  ASSERT_THAT(worst, SizeIs(2));
  EXPECT_EQ(worst[0].quality, std::min(q0, q1));
  EXPECT_EQ(worst[1].quality, std::max(q0, q1));
  EXPECT_THAT(worst_given_up(improver, std::max(q0, q1)), SizeIs(1)) << "below, not at it";
  EXPECT_THAT(worst_given_up(improver, std::min(q0, q1)), IsEmpty());
}

TEST(Improver, measures_lengths_in_spacings_at_the_middle_of_a_tet) {
  Trial trial;
  const BadTet bad{0, 3};
  EXPECT_EQ(length_at(trial.improver, bad, 2), 0) << "no spacing is known";
  Vec3 asked;
  trial.options.spacing = [&asked](const Vec3& p) {
    asked = p;
    return 0.5;
  };
  EXPECT_EQ(length_at(trial.improver, bad, 3), 1.5);
  Vec3 middle;
  for (const std::int32_t v : trial.complex.nodes[3]) middle += 0.25 * trial.complex.points[at(v)];
  EXPECT_EQ(asked, middle);
}

}  // namespace
}  // namespace tetfarm::cosmetics
