// A task that hangs is ended by its worker at its limit, and tried again.
#include <algorithm>
#include <map>

#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Ended;
using ::testing::HasSubstr;

class HungTasks : public test::Daemon {
 protected:
  HungTasks() : Daemon({"--task-limit", "1", "--first-task-limit", "2"}) {}
};

TEST_F(HungTasks, are_ended_by_their_worker_and_done_elsewhere) {
  const std::string input = test::sphere_in_box(folder_.path(), 8, 2);
  const auto worker = start_worker();
  const std::string job = submit(input);
  stop_task_of(*worker);
  ASSERT_TRUE(comes_true([](const auto& all) { return all.size() >= 2; }));
  const AttemptRow hung = attempts()[0];
  EXPECT_EQ(hung.state, AttemptState::crashed);
  EXPECT_THAT(hung.message, HasSubstr("it hung, or took longer than its limit of 2 s"));
  EXPECT_GE(hung.ended_ms - hung.started_ms, 1900);
  EXPECT_LE(hung.ended_ms - hung.started_ms, 10000);
  EXPECT_EQ(attempts()[1].task, hung.task) << "tried again";
  const Ended ended = wait_for(job);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Ended local = test::run_program(test::run_words(input, "local", 2), folder_.path());
  EXPECT_EQ(test::digest_of(ended), test::digest_of(local));
  const Ended status = ask({"status", job, "--json"});
  EXPECT_THAT(status.out, HasSubstr("\"crashes\":1"));
  EXPECT_THAT(status.out, HasSubstr("\"attempts_lost\":0")) << "nobody killed it from outside";
}

/// How often the task crashed that did so most often.
std::ptrdiff_t most_crashes(const std::vector<AttemptRow>& attempts) {
  std::map<TaskId, std::ptrdiff_t> crashes;
  std::ptrdiff_t most = 0;
  for (const AttemptRow& attempt : attempts) {
    if (attempt.state == AttemptState::crashed) most = std::max(most, ++crashes[attempt.task]);
  }
  return most;
}

std::ptrdiff_t ended_of(const std::vector<AttemptRow>& attempts) {
  return std::count_if(attempts.begin(), attempts.end(), [](const AttemptRow& attempt) {
    return attempt.state != AttemptState::running;
  });
}

TEST_F(HungTasks, that_hang_each_time_are_in_quarantine) {
  const auto worker = start_worker();
  const std::string job = submit(test::sphere_in_box(folder_.path(), 8, 2));
  // One may be done before it is stopped: then the next hangs.
  for (int i = 0; i < 20 && most_crashes(attempts()) < 3; ++i) {
    const std::ptrdiff_t ended_before = ended_of(attempts());
    stop_task_of(*worker);
    ASSERT_TRUE(comes_true([&](const auto& all) { return ended_of(all) > ended_before; }))
        << "the worker does not end it";
  }
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("crashed 3 times; last failure: it hung"));
  EXPECT_EQ(ask({"retry", job}).code, 0);
  EXPECT_EQ(wait_for(job).code, 0) << "when it hangs no more";
}

}  // namespace
}  // namespace tetfarm
