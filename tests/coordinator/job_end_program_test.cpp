#include "coordinator/job_end_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "base/clock.h"
#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

JobRow ended_job(std::uint64_t id) {
  JobRow job;
  job.id = JobId{id};
  job.name = "wing; rm -rf $HOME";
  job.phase = JobPhase::failed;
  job.exit_code = 3;
  job.message = "open edge\nat (0, 0, 1)";
  job.created_ms = 1'000;
  job.finished_ms = 8'500;
  return job;
}

class JobEndProgramTest : public testing::Test {
 protected:
  std::filesystem::path script(const std::string& body) const {
    const std::filesystem::path path = folder_.path() / "program";
    write_file_atomically(path, "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + body);
    ::chmod(path.c_str(), 0755);
    return path;
  }
  JobEndOptions options(const std::string& body) const {
    return {.program = script(body),
            .store = "/farm",
            .endpoint = "tcp://127.0.0.1:5555",
            .limit_ms = 10'000,
            .grace_ms = 200,
            .again_ms = 10,
            .tries = 3};
  }
  std::string contents(const std::string& name) const {
    std::ifstream file(folder_.path() / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static std::vector<ToldEnd> told_by(JobEndProgram& program) {
    for (int i = 0; i < 4'000; ++i) {
      std::vector<ToldEnd> told = program.take_told();
      if (!told.empty()) return told;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {};
  }

  const TempFolder folder_;
};

TEST_F(JobEndProgramTest, gets_what_there_is_to_know_as_it_is_and_no_arguments) {
  JobEndProgram program(options(
      "printf '%s\\n' "
      "\"$#|$TETFARM_JOB|$TETFARM_JOB_NAME|$TETFARM_JOB_STATE|$TETFARM_JOB_EXIT_CODE|"
      "$TETFARM_JOB_MESSAGE|$TETFARM_JOB_SECONDS|$TETFARM_STORE|$TETFARM_COORDINATOR\" > told\n"));
  program.give(ended_job(7));
  const std::vector<ToldEnd> told = told_by(program);
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_EQ(told[0].job, JobId{7});
  EXPECT_EQ(told[0].finished_ms, 8'500);
  EXPECT_EQ(told[0].trouble, "");
  EXPECT_EQ(contents("told"),
            "0|job-7|wing; rm -rf $HOME|failed|3|open edge\\nat (0, 0, 1)|7|/farm|"
            "tcp://127.0.0.1:5555\n");
}

TEST_F(JobEndProgramTest, has_nothing_open_and_hears_signals) {
  ::setenv("TETFARM_SECRET", "x", 1);
  JobEndProgram program(
      options("ls /proc/self/fd > open\necho \"$TETFARM_SECRET\" > secret\n"
              "grep SigBlk /proc/self/status > blocked\n"));
  program.give(ended_job(7));
  told_by(program);
  // 3 is the folder that `ls` reads.
  EXPECT_EQ(contents("open"), "0\n1\n2\n3\n");
  EXPECT_EQ(contents("secret"), "\n") << "of the environment only what is named";
  EXPECT_THAT(contents("blocked"), HasSubstr("0000000000000000"));
}

TEST_F(JobEndProgramTest, is_started_once_for_an_end_and_for_one_end_after_the_other) {
  JobEndProgram program(options("echo $TETFARM_JOB >> told\n"));
  for (const std::uint64_t id : {7U, 8U}) {
    for (int i = 0; i < 3; ++i) program.give(ended_job(id));
  }
  std::size_t count = told_by(program).size();
  if (count < 2) count += told_by(program).size();
  EXPECT_EQ(count, 2U);
  EXPECT_EQ(contents("told"), "job-7\njob-8\n");
  program.give(ended_job(7));
  EXPECT_THAT(told_by(program), SizeIs(1)) << "it may end again";
}

TEST_F(JobEndProgramTest, that_fails_is_tried_again_and_given_up_with_what_it_said) {
  JobEndProgram program(options("echo x >> tries\necho no mail server >&2\nexit 4\n"));
  program.give(ended_job(7));
  const std::vector<ToldEnd> told = told_by(program);
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].trouble, HasSubstr("for job-7 ended with exit code 4; it said: no mail"));
  EXPECT_THAT(told[0].trouble, HasSubstr("given up after 3 tries"));
  EXPECT_EQ(contents("tries"), "x\nx\nx\n");
  EXPECT_THAT(program.take_troubles(), SizeIs(2));
  EXPECT_THAT(program.take_troubles(), IsEmpty());
}

TEST_F(JobEndProgramTest, that_takes_too_long_is_ended_with_its_children) {
  JobEndOptions slow =
      options("trap '' TERM\n(trap '' TERM; sleep 1.5; echo late > late) &\nsleep 60\n");
  slow.limit_ms = 100;
  slow.tries = 1;
  const std::int64_t start_ms = steady_ms();
  JobEndProgram program(slow);
  program.give(ended_job(7));
  const std::vector<ToldEnd> told = told_by(program);
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].trouble, HasSubstr("took longer than 100 ms"));
  EXPECT_LT(steady_ms() - start_ms, 10'000);
  std::this_thread::sleep_for(std::chrono::milliseconds(1'700));
  EXPECT_EQ(contents("late"), "");
}

TEST_F(JobEndProgramTest, that_runs_when_the_coordinator_stops_is_ended_and_has_told_nothing) {
  const std::int64_t start_ms = steady_ms();
  {
    JobEndProgram program(options("echo x > began\nsleep 60\necho x > told\n"));
    program.give(ended_job(7));
    while (contents("began").empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_THAT(program.take_told(), IsEmpty());
  }
  EXPECT_LT(steady_ms() - start_ms, 10'000);
  EXPECT_EQ(contents("told"), "");
}

TEST_F(JobEndProgramTest, must_be_a_program_that_not_everybody_may_write_to) {
  const std::filesystem::path path = script("true\n");
  EXPECT_EQ(checked_job_end_program(path), path);
  ::chmod(path.c_str(), 0644);
  EXPECT_THROW(checked_job_end_program(path), UsageError);
  ::chmod(path.c_str(), 0757);
  EXPECT_THROW(checked_job_end_program(path), UsageError);
  EXPECT_THROW(checked_job_end_program(folder_.path()), UsageError);
  EXPECT_THROW(checked_job_end_program(folder_.path() / "none"), UsageError);
}

TEST_F(JobEndProgramTest, that_cannot_be_started_is_told_so) {
  JobEndOptions gone = options("true\n");
  gone.tries = 1;
  std::filesystem::remove(gone.program);
  JobEndProgram program(gone);
  program.give(ended_job(7));
  const std::vector<ToldEnd> told = told_by(program);
  ASSERT_THAT(told, SizeIs(1));
  EXPECT_THAT(told[0].trouble, HasSubstr("cannot be started: No such file"));
}

}  // namespace
}  // namespace tetfarm
