// `[decompose] max_memory` is a promise: no task of a run needs more.
#include <gmock/gmock.h>

#include "base/sanitizers.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double megabyte = 1e6;

class Memory : public ::testing::Test {
 protected:
  void SetUp() override {
    if (is_sanitized) GTEST_SKIP() << "a sanitizer's memory is not the program's";
  }
  Memory() {
    run_program({"shape", "sphere-in-sphere", "-o", "ball.off", "--spacing", "0.08"},
                folder_.path());
  }
  Ended run(const std::string& most, const std::string& output) {
    return run_program({"run", "ball.off", "-o", output, "--max-memory", most, "--json",
                        "--progress", "none", "-j", "2"},
                       folder_.path(), 300);
  }
  TemporaryFolder folder_;
};

TEST_F(Memory, no_task_needs_more_than_was_allowed_nor_than_was_expected) {
  const double most = 40 * megabyte;
  const Ended ended = run("40MB", "out");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json result = test::result_of(ended);
  EXPECT_GT(result["subdomains"], 2) << "one would need more";
  ASSERT_EQ(result["tasks"].size(), 9U) << "all kinds but assimilate";
  for (const auto& [kind, task] : result["tasks"].items()) {
    EXPECT_LE(task["bytes"], most) << kind;
    EXPECT_LE(task["expected_bytes"], most) << kind;
    EXPECT_LE(task["of_expected_bytes"], 1) << kind;
    EXPECT_GT(task["of_expected_bytes"], 0.2) << kind << ": a bound that is never near is none";
  }
}

TEST_F(Memory, a_plan_says_before_what_the_run_then_takes) {
  const Ended ended =
      run_program({"plan", "ball.off", "--max-memory", "40MB", "--json"}, folder_.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json plan = test::result_of(ended);
  const nlohmann::json result = test::result_of(run("40MB", "out"));
  const double planned = plan["tasks"]["mesh"]["count"];
  const double made = result["tasks"]["mesh"]["count"];
  EXPECT_NEAR(planned, made, 0.35 * made);
  ASSERT_EQ(plan["tasks"].size(), 9U);
  for (const auto& [kind, task] : plan["tasks"].items()) {
    EXPECT_LE(task["bytes"], 40 * megabyte) << kind;
    EXPECT_LE(result["tasks"][kind]["bytes"], task["bytes"]) << kind;
  }
  EXPECT_NEAR(plan["estimated_elements"], result["elements"],
              0.4 * result["elements"].get<double>());
}

TEST_F(Memory, a_limit_that_no_cut_can_keep_is_refused_with_what_it_takes) {
  const Ended ended = run("15MB", "out");
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("this surface needs at least"));
  const Ended plan = run_program({"plan", "ball.off", "--max-memory", "15MB"}, folder_.path());
  EXPECT_EQ(plan.code, 2);
}

TEST_F(Memory, other_limits_give_other_meshes_but_other_workers_do_not) {
  const std::string digest = test::digest_of(run("40MB", "out"));
  const Ended one = run_program({"run", "ball.off", "-o", "one", "--max-memory", "40000000",
                                 "--json", "--progress", "none", "-j", "1"},
                                folder_.path(), 300);
  EXPECT_EQ(test::digest_of(one), digest);
  EXPECT_EQ(digest.size(), 32U);
}

}  // namespace
}  // namespace tetfarm
