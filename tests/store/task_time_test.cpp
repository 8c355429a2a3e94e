#include "store/task_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tetfarm {
namespace {

constexpr TaskSize even{2e5, 1e4, 0};
constexpr TaskSize with_needles{2e5, 1e4, 4000};

double width(const SecondsRange& range) { return range.high / range.low; }

TEST(TaskTime, needles_take_longer_and_are_less_sure) {
  const SecondsRange good = usual_seconds(TaskKind::mesh, even);
  const SecondsRange bad = usual_seconds(TaskKind::mesh, with_needles);
  EXPECT_GT(bad.expected, 2 * good.expected);
  EXPECT_GT(width(bad), width(good));
  EXPECT_LT(good.low, good.expected);
  EXPECT_GT(good.high, good.expected);
}

TEST(TaskTime, of_a_kind_that_was_never_seen_is_the_usual) {
  TaskTimes times;
  times.learn(TaskKind::write, even, 3);
  EXPECT_EQ(times.seconds(TaskKind::mesh, with_needles).expected,
            usual_seconds(TaskKind::mesh, with_needles).expected);
  EXPECT_EQ(times.learnt(), 1U);
}

TEST(TaskTime, one_task_changes_what_is_expected_but_not_all_the_way) {
  TaskTimes times;
  const double usual = usual_seconds(TaskKind::mesh, even).expected;
  times.learn(TaskKind::mesh, even, 4 * usual);
  const double now = times.seconds(TaskKind::mesh, even).expected;
  EXPECT_GT(now, 1.2 * usual);
  EXPECT_LT(now, 4 * usual);
}

/// A machine of its own: so much for each term, and errors of a tenth.
double taken(const TaskSize& size, std::mt19937& random) {
  const double error = 0.9 + 0.2 * static_cast<double>(random() % 1000) / 999;
  return error * (0.02 + 9e-6 * size.elements + 20e-6 * size.triangles +
                  3e-3 * size.needles * size.needles / (size.needles + 2000));
}

TEST(TaskTime, after_many_tasks_is_that_of_the_machine_and_sure) {
  std::mt19937 random(5);
  const auto any_size = [&random] {
    return TaskSize{static_cast<double>(random() % 500'000), static_cast<double>(random() % 30'000),
                    static_cast<double>(random() % 3 == 0 ? random() % 20'000 : 0)};
  };
  TaskTimes times;
  for (int i = 0; i < 200; ++i) {
    const TaskSize size = any_size();
    times.learn(TaskKind::mesh, size, taken(size, random));
  }
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    const TaskSize size = any_size();
    const double seconds = taken(size, random);
    const SecondsRange range = times.seconds(TaskKind::mesh, size);
    EXPECT_NEAR(range.expected / seconds, 1, 0.35) << size.elements << " " << size.needles;
    if (range.low <= seconds && seconds <= range.high) ++inside;
  }
  EXPECT_GE(inside, 80);
  EXPECT_LT(width(times.seconds(TaskKind::mesh, with_needles)),
            0.5 * width(usual_seconds(TaskKind::mesh, with_needles)));
}

TEST(TaskTime, tasks_without_needles_say_nothing_of_how_sure_needles_are) {
  TaskTimes times;
  const double usual = usual_seconds(TaskKind::mesh, even).expected;
  for (int i = 0; i < 100; ++i) times.learn(TaskKind::mesh, even, usual);
  EXPECT_LT(width(times.seconds(TaskKind::mesh, even)),
            0.6 * width(usual_seconds(TaskKind::mesh, even)));
  EXPECT_GT(width(times.seconds(TaskKind::mesh, with_needles)),
            0.7 * width(usual_seconds(TaskKind::mesh, with_needles)));
}

TEST(TaskTime, what_makes_no_sense_is_not_learnt) {
  TaskTimes times;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  times.learn(TaskKind::mesh, {nan, 1, 1}, 1);
  times.learn(TaskKind::mesh, {1, -1, 1}, 1);
  times.learn(TaskKind::mesh, {1, 1, 1}, std::numeric_limits<double>::infinity());
  EXPECT_EQ(times.learnt(), 0U);
  times.learn(TaskKind::mesh, {1, 1, 0}, 0);
  const SecondsRange range = times.seconds(TaskKind::mesh, even);
  EXPECT_TRUE(std::isfinite(range.high));
  EXPECT_GT(range.low, 0);
}

TEST(TaskTime, of_long_ago_is_forgotten) {
  TaskTimes times;
  const double usual = usual_seconds(TaskKind::mesh, even).expected;
  for (std::size_t i = 0; i < 50; ++i) times.learn(TaskKind::mesh, even, 50 * usual);
  for (std::size_t i = 0; i < TaskTimes::samples_kept; ++i) {
    times.learn(TaskKind::mesh, even, usual);
  }
  EXPECT_EQ(times.learnt(), TaskTimes::samples_kept);
  EXPECT_NEAR(times.seconds(TaskKind::mesh, even).expected / usual, 1, 0.01);
}

TEST(TaskTime, ranges_of_tasks_add_up) {
  SecondsRange sum = usual_seconds(TaskKind::mesh, even);
  sum += usual_seconds(TaskKind::mesh, even);
  EXPECT_DOUBLE_EQ(sum.high, 2 * usual_seconds(TaskKind::mesh, even).high);
  EXPECT_DOUBLE_EQ(sum.low, 2 * usual_seconds(TaskKind::mesh, even).low);
}

TEST(TaskTime, is_the_sum_of_its_terms) {
  const auto expected = [](TaskKind kind, const TaskSize& size) {
    return usual_seconds(kind, size).expected;
  };
  const double fixed = expected(TaskKind::mesh, {0, 0, 0});
  EXPECT_NEAR(fixed, 0.006, 1e-9);
  EXPECT_NEAR(expected(TaskKind::mesh, {1e6, 0, 0}) - fixed, 1.8, 1e-9);
  EXPECT_NEAR(expected(TaskKind::mesh, {0, 1e5, 0}) - fixed, 0.8, 1e-9);
  EXPECT_NEAR(expected(TaskKind::mesh, {1e6, 1e5, 0}) - fixed, 2.6, 1e-9);
  EXPECT_NEAR(expected(TaskKind::number, {1e6, 1e6, 1e6}), 0.003 + 0.45, 1e-9)
      << "of a kind that is told no elements and no needles";
}

TEST(TaskTime, needles_take_the_longer_the_more_there_are_of_them) {
  const auto of_needles = [](double needles) {
    return usual_seconds(TaskKind::mesh, {0, 0, needles}).expected -
           usual_seconds(TaskKind::mesh, {0, 0, 0}).expected;
  };
  EXPECT_GT(of_needles(1), 0);
  EXPECT_GT(of_needles(2000), 2 * of_needles(1000)) << "few of them are no trouble";
  EXPECT_NEAR(of_needles(1e7), 0.45e-3 * 1e7, 0.02 * 0.45e-3 * 1e7);
}

}  // namespace
}  // namespace tetfarm
