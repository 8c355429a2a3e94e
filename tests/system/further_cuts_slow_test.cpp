// What is out of memory on every worker is cut further, as if the job had asked for it.
#include <set>

#include "base/sanitizers.h"
#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using ::testing::HasSubstr;

class FurtherCuts : public test::Daemon {
 protected:
  void SetUp() override {
    if (is_sanitized) GTEST_SKIP() << "under a sanitizer tasks have no limit of memory";
    const Ended made = run_program(
        {"shape", "sphere-in-sphere", "-o", "ball.off", "--spacing", "0.055"}, folder_.path());
    ASSERT_EQ(made.code, 0) << made.err;
  }
  /// Mesh tasks of half the ball need more; all other tasks, and those of a quarter, do not.
  static constexpr const char* too_little_for_a_half = "31MB";

  std::string digest_of_local_run(int subdomains) const {
    return test::digest_of(
        run_program(test::run_words("ball.off", "local", 2, subdomains), folder_.path()));
  }
};

TEST_F(FurtherCuts, a_job_too_large_for_every_worker_gives_the_mesh_of_a_finer_one) {
  const auto small = start_worker({"--memory", too_little_for_a_half});
  const Ended ended = wait_for(submit("ball.off", 2));
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json result = test::result_of(ended);
  EXPECT_EQ(result["subdomains"], 4);
  ASSERT_EQ(result["cut_further"].size(), 2U);
  EXPECT_THAT(result["cut_further"]["L"].get<std::string>(),
              HasSubstr("ran out of memory with 31 MiB, all that the largest worker has"));
  EXPECT_EQ(test::digest_of(ended), digest_of_local_run(4)) << "the same tree";
  EXPECT_THAT(ask({"events", "job-1", "--all"}).out, HasSubstr("cut further"));
}

TEST_F(FurtherCuts, kills_of_everybody_while_leaves_are_cut_further_change_nothing) {
  auto small = start_worker({"--memory", too_little_for_a_half});
  const std::string job = submit("ball.off", 2);
  std::set<std::size_t> killed_after;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(100);
  while (!killed_after.contains(2) && std::chrono::steady_clock::now() < until) {
    const std::vector<AttemptRow> all = attempts();
    const auto starved = static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(),
        [](const AttemptRow& attempt) { return attempt.state == AttemptState::starved; }));
    if (!killed_after.insert(starved).second) {
      pause_ms(20);
      continue;
    }
    coordinator_->signal(SIGKILL);
    coordinator_->wait();
    small->signal(SIGKILL);
    small->wait();
    coordinator_ = start_coordinator(endpoint_);
    small = start_worker({"--memory", too_little_for_a_half});
  }
  EXPECT_TRUE(killed_after.contains(0) && killed_after.contains(2))
      << "before and after both; between them where they are not too fast";
  const Ended ended = wait_for(job);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(test::digest_of(ended), digest_of_local_run(4));
}

}  // namespace
}  // namespace tetfarm
