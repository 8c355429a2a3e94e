// A real coordinator that is killed, and its jobs that wait, end and are forgotten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <thread>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/child_coordinator.h"
#include "tests/coordinator/store_messages.h"

namespace tetfarm {
namespace {

using test::ChildCoordinator;
using test::Dealer;
using testing::HasSubstr;

class EndedJobs : public testing::Test, protected test::WithStore {
 protected:
  void start(const CoordinatorOptions& options) {
    coordinator_.reset();  // kill -9
    coordinator_ = std::make_unique<ChildCoordinator>(folder_.path(), options);
  }
  CoordinatorOptions with_program(const std::string& body) {
    const std::filesystem::path path = folder_.path() / "job_ended";
    write_file_atomically(path, "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + body);
    ::chmod(path.c_str(), 0755);
    CoordinatorOptions options;
    options.on_job_end = path;
    return options;
  }
  wire::Envelope ask(const wire::Envelope& question) const {
    return Dealer(coordinator_->endpoint()).ask(question);
  }
  wire::JobStatus status(const std::string& job) const {
    wire::Envelope question;
    question.mutable_status_request()->set_job(job);
    const wire::Envelope answer = ask(question);
    return answer.status_reply().jobs_size() > 0 ? answer.status_reply().jobs(0)
                                                 : wire::JobStatus();
  }
  void cancel(const std::string& job) const {
    wire::Envelope envelope;
    envelope.mutable_cancel()->set_job(job);
    EXPECT_TRUE(ask(envelope).cancelled().found());
  }
  wire::Envelope submission_after(const std::string& key, const std::string& job) const {
    wire::Envelope envelope = submission(key);
    envelope.mutable_submit()->add_after(job);
    return envelope;
  }
  /// Whether the file comes to have these contents.
  bool has_contents(const std::string& name, const std::string& wanted) const {
    std::string text;
    for (int i = 0; i < 400 && text != wanted; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
      std::ifstream file(folder_.path() / name);
      text = {std::istreambuf_iterator<char>(file), {}};
    }
    EXPECT_EQ(text, wanted);
    return text == wanted;
  }

  std::unique_ptr<ChildCoordinator> coordinator_;
};

TEST_F(EndedJobs, that_others_wait_for_are_known_after_a_crash_and_end_those_too) {
  start({});
  EXPECT_EQ(ask(submission("first")).submitted().job(), "job-1");
  EXPECT_EQ(ask(submission_after("second", "job-1")).submitted().job(), "job-2");
  start({});
  EXPECT_EQ(status("job-2").state(), "waiting");
  EXPECT_EQ(status("job-2").message(), "waits for job-1 (wing), which is running");
  ASSERT_EQ(status("job-2").waits_for_size(), 1);
  cancel("job-1");
  EXPECT_EQ(status("job-2").state(), "cancelled");
  start({});
  EXPECT_THAT(status("job-2").message(), HasSubstr("it waited for job-1 (wing)"));
}

TEST_F(EndedJobs, are_told_to_a_program_once_each_also_after_a_crash) {
  const CoordinatorOptions options = with_program("echo $TETFARM_JOB $TETFARM_JOB_STATE >> told\n");
  start(options);
  ask(submission("first"));
  ask(submission_after("second", "job-1"));
  cancel("job-1");
  ASSERT_TRUE(has_contents("told", "job-1 cancelled\njob-2 cancelled\n"));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  start(options);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_TRUE(has_contents("told", "job-1 cancelled\njob-2 cancelled\n"));
}

TEST_F(EndedJobs, whose_program_was_running_when_the_coordinator_was_killed_are_told_again) {
  start(
      with_program("echo x >> began\nif [ ! -e go ]; then sleep 60; exit 1; fi\n"
                   "echo $TETFARM_JOB > told\n"));
  ask(submission("first"));
  cancel("job-1");
  ASSERT_TRUE(has_contents("began", "x\n"));
  EXPECT_EQ(status("job-1").state(), "cancelled") << "nobody waits for the program";
  write_file_atomically(folder_.path() / "go", "");
  CoordinatorOptions again;
  again.on_job_end = folder_.path() / "job_ended";
  start(again);
  EXPECT_TRUE(has_contents("told", "job-1\n"));
}

TEST_F(EndedJobs, are_forgotten_with_age_and_their_files_go) {
  start({});
  const wire::Envelope first = submission("first");
  ask(first);
  cancel("job-1");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CoordinatorOptions options;
  options.keep_ms = 10;
  start(options);
  for (int i = 0; i < 400 && !status("job-1").job().empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  EXPECT_EQ(status("job-1").job(), "");
  const wire::Artifact& surface = first.submit().inputs(0);
  for (int i = 0; i < 400 && store_.has(surface.hash(), surface.size()); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  EXPECT_FALSE(store_.has(surface.hash(), surface.size()));
  start({});
  EXPECT_EQ(ask(submission("first")).submitted().job(), "job-2") << "no number is given out twice";
}

}  // namespace
}  // namespace tetfarm
