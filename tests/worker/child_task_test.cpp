#include "worker/child_task.h"

#include <gmock/gmock.h>
#include <poll.h>
#include <signal.h>

#include <fstream>

#include "store/rows.h"
#include "tasks/failure_cause.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// Runs a shell script as the task and returns its outcome; `said` collects the progress.
wire::Envelope run_script(const std::string& script, std::vector<wire::Doing>* said = nullptr) {
  wire::Assign assign;
  assign.set_task(7);
  assign.set_attempt(3);
  ChildTask child({.command = {"/bin/sh", "-c", script}}, assign);
  const auto note = [said](const wire::Doing& progress) {
    if (said != nullptr) said->push_back(progress);
  };
  while (true) {
    if (std::optional<wire::Envelope> outcome = child.poll(note)) return *outcome;
    pollfd waiting{child.fd(), POLLIN, 0};
    ::poll(&waiting, 1, 100);
  }
}

/// A shell command that writes the envelope as a frame to the result descriptor.
std::string say(const wire::Envelope& envelope) {
  std::string octal;
  for (const char c : frame_of(envelope)) {
    char text[8];
    std::snprintf(text, sizeof text, "\\%03o",
                  static_cast<unsigned>(static_cast<unsigned char>(c)));
    octal += text;
  }
  return "printf '" + octal + "' >&3; ";
}

wire::Envelope done_with(const std::string& key, double value) {
  wire::Envelope envelope;
  (*envelope.mutable_done()->mutable_numbers())[key] = value;
  return envelope;
}

TEST(ChildTask, result_carries_task_attempt_time_and_peak_memory) {
  const wire::Envelope outcome = run_script(say(done_with("elements", 42)));
  ASSERT_TRUE(outcome.has_done());
  EXPECT_EQ(outcome.done().task(), 7U);
  EXPECT_EQ(outcome.done().attempt(), 3U);
  EXPECT_EQ(outcome.done().numbers().at("elements"), 42);
  EXPECT_GT(outcome.done().peak_rss_bytes(), 0U);
  EXPECT_GT(outcome.done().numbers().at("cpu_seconds"), 0);
}

TEST(ChildTask, progress_arrives_before_the_result) {
  wire::Envelope beat;
  beat.mutable_heartbeat()->mutable_doing()->set_stage("edges");
  beat.mutable_heartbeat()->mutable_doing()->set_done(11);
  std::vector<wire::Doing> said;
  const wire::Envelope outcome = run_script(say(beat) + say(done_with("elements", 1)), &said);
  EXPECT_TRUE(outcome.has_done());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].stage(), "edges");
  EXPECT_EQ(said[0].done(), 11U);
}

TEST(ChildTask, the_log_has_the_stages_with_their_times_and_what_was_said) {
  wire::Envelope edges;
  edges.mutable_heartbeat()->mutable_doing()->set_stage("edges");
  wire::Envelope faces;
  faces.mutable_heartbeat()->mutable_doing()->set_stage("faces");
  const wire::Envelope outcome = run_script(say(edges) + say(faces) + say(edges) +
                                            "echo 'a warning' >&2; " + say(done_with("x", 1)));
  ASSERT_TRUE(outcome.has_done());
  const std::string& log = outcome.done().log();
  EXPECT_THAT(log, HasSubstr(" s  edges\n"));
  EXPECT_EQ(log.find("edges"), log.rfind("edges")) << "a stage is written once";
  EXPECT_THAT(log, HasSubstr("a warning"));
  const wire::Envelope loud = run_script("head -c 100000 /dev/zero | tr '\\0' x; exit 1");
  ASSERT_TRUE(loud.has_failed());
  EXPECT_LE(loud.failed().log().size(), longest_log);
  EXPECT_THAT(loud.failed().log(), HasSubstr("failed: "));
}

TEST(ChildTask, a_killed_child_may_be_retried_and_names_the_signal) {
  const wire::Envelope outcome = run_script("kill -SEGV $$");
  ASSERT_TRUE(outcome.has_failed());
  EXPECT_EQ(outcome.failed().cause(), on_wire(FailureCause::error));
  EXPECT_EQ(outcome.failed().attempt(), 3U);
  EXPECT_THAT(outcome.failed().message(), HasSubstr("signal 11"));
}

TEST(ChildTask, being_killed_from_outside_is_no_crash) {
  const wire::Envelope outcome = run_script("kill -KILL $$");
  ASSERT_TRUE(outcome.has_failed());
  EXPECT_EQ(outcome.failed().cause(), on_wire(FailureCause::killed));
}

TEST(ChildTask, last_words_of_a_child_that_aborts_are_in_the_message) {
  const wire::Envelope outcome = run_script("echo 'check failed: a < b' >&2; kill -ABRT $$");
  ASSERT_TRUE(outcome.has_failed());
  EXPECT_THAT(outcome.failed().message(), HasSubstr("check failed: a < b"));
}

TEST(ChildTask, a_result_followed_by_a_crash_is_not_believed) {
  const wire::Envelope outcome = run_script(say(done_with("elements", 1)) + "kill -KILL $$");
  EXPECT_TRUE(outcome.has_failed());
}

TEST(ChildTask, ending_without_a_result_is_a_failure) {
  const wire::Envelope outcome = run_script("exit 0");
  ASSERT_TRUE(outcome.has_failed());
  EXPECT_EQ(outcome.failed().cause(), on_wire(FailureCause::error));
  EXPECT_THAT(outcome.failed().message(), HasSubstr("without a result"));
}

TEST(ChildTask, garbage_and_an_absurd_length_do_not_hurt_the_worker) {
  EXPECT_TRUE(run_script("printf '\\377\\377\\377\\377' >&3; sleep 100").has_failed());
  EXPECT_TRUE(run_script("printf '\\002\\000\\000\\000xx' >&3").has_failed());
}

TEST(ChildTask, a_program_that_is_not_there_is_a_failure) {
  ChildTask child({.command = {"/nowhere/tetfarm"}}, wire::Assign());
  std::optional<wire::Envelope> outcome;
  while (!outcome) outcome = child.poll([](const wire::Doing&) {});
  EXPECT_TRUE(outcome->has_failed());
}

TEST(ChildTask, killing_ends_it) {
  ChildTask child({.command = {"/bin/sh", "-c", "sleep 1000"}}, wire::Assign());
  EXPECT_FALSE(child.poll([](const wire::Doing&) {}).has_value());
  child.kill();
  std::optional<wire::Envelope> outcome;
  while (!outcome) outcome = child.poll([](const wire::Doing&) {});
  EXPECT_THAT(outcome->failed().message(), HasSubstr("signal 9"));
}

TEST(ChildTask, one_that_took_too_long_was_not_killed_from_outside) {
  ChildTask child({.command = {"/bin/sh", "-c", "sleep 1000"}}, wire::Assign());
  child.end_overdue(7'000);
  std::optional<wire::Envelope> outcome;
  while (!outcome) outcome = child.poll([](const wire::Doing&) {});
  EXPECT_EQ(outcome->failed().cause(), on_wire(FailureCause::error));
  EXPECT_THAT(outcome->failed().message(), HasSubstr("its limit of 7 s"));
}

TEST(ChildTask, destruction_leaves_no_process_behind) {
  pid_t process = 0;
  {
    const ChildTask child({.command = {"/bin/sh", "-c", "sleep 1000"}}, wire::Assign());
    process = child.process();
    EXPECT_EQ(::kill(process, 0), 0);
  }
  EXPECT_NE(::kill(process, 0), 0);
}

TEST(ChildTask, a_long_assignment_arrives_whole) {
  wire::Assign assign;
  for (int i = 0; i < 20000; ++i) assign.add_inputs()->set_name("mesh:" + std::to_string(i));
  wire::TaskStart start;
  *start.mutable_assign() = assign;
  const std::string wanted = std::to_string(start.ByteSizeLong());
  ChildTask child({.command = {"/bin/sh", "-c",
                               "test $(wc -c) -eq " + wanted + " && " + say(done_with("ok", 1))}},
                  assign);
  std::optional<wire::Envelope> outcome;
  while (!outcome) outcome = child.poll([](const wire::Doing&) {});
  EXPECT_TRUE(outcome->has_done());
}

TEST(ChildTask, tells_how_it_ended_and_its_last_words) {
  EXPECT_EQ(run_script("exit 4").failed().message(),
            "the task's process ended with code 4 and without a result");
  EXPECT_EQ(run_script("echo 'it is odd'; echo; exit 0").failed().message(),
            "the task's process ended with code 0 and without a result; its output: it is odd");
  EXPECT_EQ(run_script("kill -SEGV $$").failed().message(),
            "the task's process was killed by signal 11 (Segmentation fault)");
  const wire::Envelope loud =
      run_script("head -c 5000 /dev/zero | tr '\\0' x; printf 'the end'; exit 1");
  EXPECT_EQ(loud.failed().message(),
            "the task's process ended with code 1 and without a result; its output: " +
                std::string(2000 - 7, 'x') + "the end")
      << "of what it said the end is kept";
}

TEST(ChildTask, has_a_cause_for_each_way_to_end) {
  const auto cause = [](const std::string& script) { return run_script(script).failed().cause(); };
  EXPECT_EQ(cause("kill -KILL $$"), on_wire(FailureCause::killed));
  EXPECT_EQ(cause("kill -TERM $$"), on_wire(FailureCause::killed));
  EXPECT_EQ(cause("kill -ABRT $$"), on_wire(FailureCause::error));
  EXPECT_EQ(cause("exit 1"), on_wire(FailureCause::error));
  const wire::Failed starved =
      run_script("echo \"terminate called: what():  std::bad_alloc\" >&2; kill -ABRT $$").failed();
  EXPECT_EQ(starved.cause(), on_wire(FailureCause::out_of_memory));
  EXPECT_EQ(starved.exit_code(), 6);
  EXPECT_THAT(starved.message(), ::testing::EndsWith("std::bad_alloc; it ran out of memory"));
  EXPECT_EQ(run_script("exit 1").failed().exit_code(), 1);
}

TEST(ChildTask, that_is_overdue_says_its_limit_and_is_no_lack_of_memory) {
  wire::Assign assign;
  ChildTask child({.command = {"/bin/sh", "-c", "echo std::bad_alloc; sleep 9"}}, assign);
  pollfd waiting{child.fd(), POLLIN, 0};
  ::poll(&waiting, 1, 50);
  child.end_overdue(65'999);
  std::optional<wire::Envelope> outcome;
  while (!outcome) outcome = child.poll([](const wire::Doing&) {});
  EXPECT_EQ(outcome->failed().cause(), on_wire(FailureCause::error));
  EXPECT_THAT(outcome->failed().message(),
              ::testing::StartsWith("it hung, or took longer than its limit of 65 s; the task's "
                                    "process was killed by signal 9 (Killed)"));
}

TEST(ChildTask, has_its_log_with_a_failure_too) {
  wire::Envelope failed;
  failed.mutable_failed()->set_message("open edge");
  failed.mutable_failed()->set_exit_code(3);
  failed.mutable_failed()->set_cause(on_wire(FailureCause::for_good));
  const wire::Envelope outcome = run_script("echo hello; " + say(failed));
  EXPECT_EQ(outcome.failed().message(), "open edge");
  EXPECT_EQ(outcome.failed().exit_code(), 3);
  EXPECT_EQ(outcome.failed().task(), 7U);
  EXPECT_EQ(outcome.failed().attempt(), 3U);
  EXPECT_GT(outcome.failed().peak_rss_bytes(), 100'000U) << "bytes, not kilobytes";
  EXPECT_THAT(outcome.failed().log(),
              ::testing::MatchesRegex(" +[0-9.]+ s  hello\n +[0-9.]+ s  failed: open edge\n"));
  const wire::Envelope done = run_script(say(done_with("x", 1)));
  EXPECT_THAT(done.done().log(),
              ::testing::MatchesRegex(" +[0-9.]+ s  done, peak memory [0-9]+ MiB\n"));
}

TEST(ChildTask, frames_begin_with_their_length) {
  wire::Envelope envelope;
  envelope.mutable_done()->set_log(std::string(300, 'x'));
  const std::string frame = frame_of(envelope);
  const std::size_t length = envelope.ByteSizeLong();
  ASSERT_EQ(frame.size(), length + 4);
  EXPECT_EQ(static_cast<unsigned char>(frame[0]), length % 256);
  EXPECT_EQ(static_cast<unsigned char>(frame[1]), length / 256);
  EXPECT_EQ(frame[2], 0);
  EXPECT_EQ(frame[3], 0);
}

}  // namespace
}  // namespace tetfarm
