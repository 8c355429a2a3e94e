// A program of the administrator's is started when a job has ended, whatever becomes of the
// coordinator.
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Ended;
using ::testing::HasSubstr;

class JobEndPrograms : public test::Daemon {
 protected:
  void restart_with_program(const std::string& body) {
    const std::filesystem::path program = folder_.path() / "job_ended";
    test::write_contents(program, "#!/bin/sh\ncd '" + folder_.path().string() + "'\n" + body);
    ::chmod(program.c_str(), 0755);
    more_ = {"--on-job-end", "job_ended"};
    restart();
  }
  void restart() {
    coordinator_->signal(SIGKILL);
    coordinator_->wait();
    coordinator_ = start_coordinator(endpoint_);
  }
  std::string contents(const std::string& name) const {
    std::ifstream file(folder_.path() / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool has_contents(const std::string& name, const std::string& wanted) const {
    for (int i = 0; i < 600 && contents(name) != wanted; ++i) pause_ms(50);
    return contents(name) == wanted;
  }
};

TEST_F(JobEndPrograms, are_told_of_each_end_once) {
  restart_with_program("echo $TETFARM_JOB $TETFARM_JOB_STATE $TETFARM_JOB_EXIT_CODE >> told\n");
  const std::string first = submit(test::sphere_in_box(folder_.path(), 4, 1));
  EXPECT_EQ(ask({"cancel", first}).code, 0);
  EXPECT_TRUE(has_contents("told", first + " cancelled 0\n"));
  const auto worker = start_worker();
  const std::string second = submit(test::sphere_in_box(folder_.path(), 5, 1), 1);
  EXPECT_EQ(wait_for(second).code, 0);
  EXPECT_TRUE(has_contents("told", first + " cancelled 0\n" + second + " done 0\n"));
  for (int i = 0; i < 200; ++i) {
    if (ask({"events", second, "--json"}).out.find("end told") != std::string::npos) break;
    pause_ms(50);
  }
  restart();
  EXPECT_EQ(ask({"jobs"}).code, 0);
  pause_ms(500);
  EXPECT_EQ(contents("told"), first + " cancelled 0\n" + second + " done 0\n")
      << "what was told is durable";
}

TEST_F(JobEndPrograms, that_were_killed_with_their_coordinator_are_started_by_the_next) {
  restart_with_program(
      "echo x >> began\nif [ ! -e go ]; then sleep 60; exit 1; fi\necho $TETFARM_JOB > told\n");
  const std::string job = submit(test::sphere_in_box(folder_.path(), 4, 1));
  EXPECT_EQ(ask({"cancel", job}).code, 0);
  ASSERT_TRUE(has_contents("began", "x\n"));
  EXPECT_EQ(ask({"status", job}).code, 0) << "nobody waits for the program";
  test::write_contents(folder_.path() / "go", "");
  restart();
  EXPECT_TRUE(has_contents("told", job + "\n"));
}

TEST_F(JobEndPrograms, that_cannot_be_started_are_refused_at_once) {
  const Ended none = test::run_program(
      {"coordinator", "--store", "other", "--listen", "tcp://127.0.0.1:*", "--on-job-end", "none"},
      folder_.path());
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("--on-job-end: No such file"));
}

}  // namespace
}  // namespace tetfarm
