#include "worker/solver_process.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include "base/file_system.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

class SolverProcess : public testing::Test {
 protected:
  SolverProcess() { fs::create_directories(folder_); }
  ~SolverProcess() override { fs::remove_all(folder_); }
  SolverCommand command(const std::string& text, std::int64_t limit_ms = 20'000) const {
    return {text, folder_, folder_ / "log", {{"CYCLE", "3"}}, limit_ms};
  }
  std::string log() const { return read_file(folder_ / "log"); }
  static bool runs(pid_t process) { return ::kill(process, 0) == 0; }
  pid_t process_in(const char* file) const {
    for (int i = 0; i < 2000 && !fs::exists(folder_ / file); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::atoi(read_file(folder_ / file).c_str());
  }
  static void expect_ended(pid_t process) {
    for (int i = 0; i < 2000 && runs(process); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_FALSE(runs(process));
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("solver_" + std::to_string(::getpid()));
};

TEST_F(SolverProcess, works_in_its_folder_and_all_it_says_is_kept) {
  const SolverEnd end = run_solver(command("pwd; echo cycle $CYCLE >&2; read x; exit 7"), [] {});
  EXPECT_EQ(end.exit_code, 7);
  EXPECT_EQ(end.signal, 0);
  EXPECT_FALSE(end.is_overdue);
  EXPECT_EQ(log(), fs::canonical(folder_).string() + "\ncycle 3\n");
}

TEST_F(SolverProcess, that_is_killed_is_told_by_its_signal) {
  EXPECT_EQ(run_solver(command("kill -SEGV $$"), [] {}).signal, SIGSEGV);
}

TEST_F(SolverProcess, ends_at_its_limit_with_all_that_it_has_started) {
  const SolverEnd end =
      run_solver(command("sleep 600 & echo $! > child; sleep 600; true", 300), [] {});
  EXPECT_TRUE(end.is_overdue);
  expect_ended(process_in("child"));
}

TEST_F(SolverProcess, leaves_nothing_behind_in_the_background) {
  EXPECT_EQ(run_solver(command("sleep 600 & echo $! > child; exit 0"), [] {}).exit_code, 0);
  expect_ended(process_in("child"));
}

TEST_F(SolverProcess, ends_with_the_process_that_started_it) {
  const SolverCommand solver =
      command("sleep 600 & echo $! > part; mv part child; sleep 600; true");
  const pid_t task = ::fork();
  if (task == 0) {
    run_solver(solver, [] {});
    ::_exit(0);
  }
  const pid_t child = process_in("child");
  EXPECT_TRUE(runs(child));
  ::kill(task, SIGKILL);
  ::waitpid(task, nullptr, 0);
  expect_ended(child);
}

}  // namespace
}  // namespace tetfarm
