// The daemon as on a cluster: a coordinator, workers that come over TCP, and clients.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "base/sanitizers.h"
#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Daemon;
using test::Ended;
using test::run_program;
using ::testing::HasSubstr;

TEST_F(Daemon, submit_wait_and_status_with_workers_that_come_later) {
  const std::string job = submit(test::sphere_in_box(folder_.path(), 8, 2));
  EXPECT_EQ(submit("sphere_in_box.off"), job) << "the same job again";
  const auto one = start_worker();
  const auto two = start_worker();
  const Ended ended = wait_for(job);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(test::digest_of(ended).size(), 32U);
  const Ended status = ask({"status", job, "--json"});
  EXPECT_THAT(status.out, HasSubstr("\"state\":\"done\""));
  EXPECT_THAT(ask({"status"}).out, HasSubstr(job));
  EXPECT_EQ(ask({"status", "job-99"}).code, 5);
  one->signal(SIGTERM);
  EXPECT_EQ(one->wait().code, 0);
}

TEST_F(Daemon, gives_the_mesh_that_a_local_run_gives) {
  const std::string input = test::sphere_in_box(folder_.path(), 8, 2);
  const auto worker = start_worker();
  const Ended remote = wait_for(submit(input));
  const Ended local = run_program(test::run_words(input, "local", 2), folder_.path());
  EXPECT_EQ(test::digest_of(remote), test::digest_of(local));
  EXPECT_EQ(test::digest_of(local).size(), 32U);
}

TEST_F(Daemon, workers_outlive_a_killed_coordinator) {
  const auto one = start_worker();
  const auto two = start_worker();
  const std::string job = submit(test::sphere_in_box(folder_.path(), 10, 2));
  const pid_t task = stop_task_of(*one);
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  ::kill(task, SIGCONT);
  pause_ms(300);
  coordinator_ = start_coordinator(endpoint_);
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(one->is_running());
  EXPECT_TRUE(two->is_running());
}

TEST_F(Daemon, a_worker_that_is_killed_leaves_nothing_behind_when_its_lease_is_over) {
  const auto worker = start_worker();
  submit(test::sphere_in_box(folder_.path(), 8, 2));
  ASSERT_GT(stop_task_of(*worker), 0);
  const std::filesystem::path scratch = folder_.path() / "store/scratch";
  const std::string attempt = "attempt-" + std::to_string(attempts().back().id.value);
  std::filesystem::create_directories(scratch / attempt);
  test::write_contents(scratch / attempt / "mesh.vtkhdf", "half a mesh");
  const auto files = [&scratch] {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(scratch)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  };
  EXPECT_THAT(files(), ::testing::Contains(::testing::StartsWith("probe-")));
  worker->signal(SIGKILL);
  for (int i = 0; i < 400 && !files().empty(); ++i) pause_ms(50);
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(Daemon, a_worker_that_sleeps_past_its_lease_does_no_harm) {
  const std::string input = test::sphere_in_box(folder_.path(), 10, 2);
  const auto sleeper = start_worker();
  const std::string job = submit(input);
  const pid_t task = stop_task_of(*sleeper);
  sleeper->signal(SIGSTOP);
  ::kill(task, SIGCONT);  // the task does not sleep
  const auto other = start_worker();
  pause_ms(2500);
  sleeper->signal(SIGCONT);
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 0) << ended.err;
  const Ended local = run_program(test::run_words(input, "local", 2), folder_.path());
  EXPECT_EQ(test::digest_of(ended), test::digest_of(local));
  EXPECT_TRUE(sleeper->is_running());
}

TEST_F(Daemon, a_result_that_was_made_while_the_coordinator_was_dead_is_kept_and_made_once) {
  const auto worker = start_worker();
  const std::string job = submit(test::sphere_in_box(folder_.path(), 8, 2));
  const pid_t task = stop_task_of(*worker);
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  ::kill(task, SIGCONT);
  for (int i = 0; i < 2000 && task_of(*worker); ++i) pause_ms(10);
  coordinator_ = start_coordinator(endpoint_);
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 0) << ended.err;
  std::map<std::uint64_t, int> task2attempts;
  for (const AttemptRow& attempt : attempts()) {
    EXPECT_EQ(++task2attempts[attempt.task.value], 1) << "task " << attempt.task.value;
    EXPECT_EQ(attempt.state, AttemptState::done);
  }
}

TEST_F(Daemon, a_zombies_result_is_refused_while_another_works_on_the_task) {
  const std::string input = test::sphere_in_box(folder_.path(), 8, 2);
  const auto zombie = start_worker();
  const std::string job = submit(input);
  const pid_t first = stop_task_of(*zombie);
  zombie->signal(SIGSTOP);
  const auto other = start_worker();
  const pid_t second = stop_task_of(*other);  // once the lease of the first is lost
  ::kill(first, SIGCONT);                     // it makes its result, and nobody hears of it yet
  pause_ms(1500);
  zombie->signal(SIGCONT);
  pause_ms(1500);
  ASSERT_TRUE(comes_true([](const auto& all) { return all.size() >= 2; }));
  EXPECT_EQ(attempts()[0].state, AttemptState::lost);
  EXPECT_EQ(attempts()[1].task, attempts()[0].task);
  EXPECT_EQ(attempts()[1].state, AttemptState::running) << "the zombie's result was taken";
  ::kill(second, SIGCONT);
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(attempts()[1].state, AttemptState::done);
  const Ended local = run_program(test::run_words(input, "local", 2), folder_.path());
  EXPECT_EQ(test::digest_of(ended), test::digest_of(local));
}

TEST_F(Daemon, a_task_out_of_memory_says_so_and_is_tried_where_there_is_more) {
  if (is_sanitized) GTEST_SKIP() << "under a sanitizer tasks have no limit of memory";
  const auto small = start_worker({"--memory", "3MB"});
  const std::string job = submit(test::sphere_in_box(folder_.path(), 24, 2));
  // Alone in the farm it has all the memory there is.
  const Ended poor = wait_for(job);
  EXPECT_EQ(poor.code, 6) << poor.err;
  EXPECT_THAT(poor.err, HasSubstr("out of memory"));
  const auto large = start_worker({"--memory", "2GB"});
  const std::string its_memory = std::to_string(std::uint64_t{2} << 30U);
  for (int i = 0; i < 200 && ask({"workers", "--json"}).out.find(its_memory) == std::string::npos;
       ++i) {
    pause_ms(20);
  }
  EXPECT_EQ(ask({"retry", job}).code, 0);
  const Ended ended = wait_for(job);
  EXPECT_EQ(ended.code, 0) << ended.err;
  const std::vector<AttemptRow> all = attempts();
  const auto starved = std::find_if(all.begin(), all.end(), [](const AttemptRow& attempt) {
    return attempt.state == AttemptState::starved;
  });
  ASSERT_NE(starved, all.end());
  const auto done = std::find_if(all.begin(), all.end(), [&](const AttemptRow& attempt) {
    return attempt.task == starved->task && attempt.state == AttemptState::done;
  });
  ASSERT_NE(done, all.end());
  EXPECT_GT(done->memory_bytes, starved->memory_bytes);
}

TEST_F(Daemon, a_cancelled_job_ends_and_the_next_one_runs) {
  const std::string first = submit(test::sphere_in_box(folder_.path(), 12, 3));
  const auto worker = start_worker();
  ASSERT_GT(stop_task_of(*worker), 0);  // only its end makes room for the next job
  EXPECT_EQ(ask({"cancel", first}).code, 0);
  EXPECT_EQ(wait_for(first).code, 1);
  EXPECT_EQ(ask({"cancel", "job-99"}).code, 5);
  const Ended ended = wait_for(submit(test::sphere_in_box(folder_.path(), 4, 1)));
  EXPECT_EQ(ended.code, 0) << ended.err;
}

}  // namespace
}  // namespace tetfarm
