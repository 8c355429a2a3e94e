#include "worker/task_host.h"

#include "base/sanitizers.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>

#include "tests/base/temp_folder.h"
#include "worker/child_task.h"

namespace tetfarm {
namespace {

class TaskHosts : public ::testing::Test {
 protected:
  TaskHosts() : null_(::open("/dev/null", O_RDWR | O_CLOEXEC)) {}
  ~TaskHosts() override { ::close(null_); }
  void SetUp() override {
    if (has_thread_sanitizer) {
      GTEST_SKIP() << "hosts copy themselves behind the C library's back, which ThreadSanitizer "
                      "does not follow: there is none in such a build";
    }
  }

  std::optional<pid_t> start(TaskHost& host, const std::string& script, int patience_ms = 10'000) {
    return host.start(script, {null_, null_, null_}, 0, patience_ms);
  }
  /// The exit code of a task that is a child of this process, or -1.
  static int exit_code(std::optional<pid_t> task) {
    int status = -1;
    if (!task || ::waitpid(*task, &status, 0) != *task || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
  }
  static bool is_there(pid_t process) { return ::kill(process, 0) == 0; }

  int null_;
  TaskHost host_{{TETFARM_TASK_HOST}};
};

TEST_F(TaskHosts, the_task_is_a_child_of_the_worker_and_not_of_the_host) {
  const auto task = start(host_, "exit 7");
  EXPECT_EQ(exit_code(task), 7);
  EXPECT_NE(host_.process(), *task);
}

TEST_F(TaskHosts, a_host_that_was_prepared_is_the_one_that_starts_tasks) {
  host_.prepare();
  const pid_t prepared = host_.process();
  ASSERT_GT(prepared, 0);
  host_.prepare();
  EXPECT_EQ(exit_code(start(host_, "exit 7")), 7);
  EXPECT_EQ(host_.process(), prepared);
}

TEST_F(TaskHosts, one_host_starts_many_tasks_side_by_side) {
  const auto first = start(host_, "sleep 1000");
  ASSERT_TRUE(first);
  const pid_t host = host_.process();
  for (int code = 0; code < 20; ++code) {
    EXPECT_EQ(exit_code(start(host_, "exit " + std::to_string(code))), code);
  }
  EXPECT_EQ(host_.process(), host);
  ::kill(*first, SIGKILL);
  EXPECT_EQ(exit_code(first), -1);
}

TEST_F(TaskHosts, the_task_has_its_pipes_and_no_other_descriptor) {
  std::array<int, 2> words{};
  ASSERT_EQ(::pipe(words.data()), 0);
  const auto task = host_.start("cat; echo said; echo frame >&3; ls /proc/self/fd | wc -l >&2",
                                {null_, words[1], words[1]}, 0);
  ::close(words[1]);
  std::array<char, 200> text{};
  std::string all;
  for (ssize_t n = 0; (n = ::read(words[0], text.data(), text.size())) > 0;) {
    all.append(text.data(), static_cast<std::size_t>(n));
  }
  ::close(words[0]);
  EXPECT_EQ(exit_code(task), 0);
  // 0 to 3 and the folder that ls reads; its own output is a pipe of the shell's.
  EXPECT_EQ(all, "said\nframe\n5\n");
}

TEST_F(TaskHosts, the_task_has_a_group_of_its_own_and_the_limit_of_memory) {
  if (has_address_sanitizer) GTEST_SKIP() << "a sanitizer's shadow is larger than any limit";
  const auto task =
      host_.start("[ $(ulimit -d) = 262144 ]", {null_, null_, null_}, std::uint64_t{256} << 20U);
  EXPECT_EQ(exit_code(task), 0);
  const auto sleeper = start(host_, "sleep 1000");
  ASSERT_TRUE(sleeper);
  // The copy leaves the host's group a moment after it was told of.
  for (int i = 0; i < 1000 && ::getpgid(*sleeper) != *sleeper; ++i) ::usleep(1000);
  EXPECT_EQ(::getpgid(*sleeper), *sleeper);
  ::kill(*sleeper, SIGKILL);
  ::waitpid(*sleeper, nullptr, 0);
}

TEST_F(TaskHosts, a_host_that_was_killed_is_replaced_and_its_tasks_live_on) {
  const auto sleeper = start(host_, "sleep 0.3; exit 3");
  const pid_t old = host_.process();
  ASSERT_GT(old, 0);
  ::kill(old, SIGKILL);
  EXPECT_EQ(exit_code(start(host_, "exit 4")), 4);
  EXPECT_NE(host_.process(), old);
  EXPECT_EQ(exit_code(sleeper), 3);
}

TEST_F(TaskHosts, a_task_asked_of_a_stopped_host_runs_once_from_another) {
  const TempFolder folder;
  const std::string file = folder.path() / "runs";
  EXPECT_EQ(exit_code(start(host_, "exit 0")), 0);
  const pid_t old = host_.process();
  ASSERT_GT(old, 0);
  ::kill(old, SIGSTOP);
  EXPECT_EQ(exit_code(start(host_, "echo run >>" + file, 2'000)), 0);
  EXPECT_FALSE(is_there(old));
  std::ifstream runs(file);
  std::string line;
  int count = 0;
  while (std::getline(runs, line)) ++count;
  EXPECT_EQ(count, 1);
}

TEST_F(TaskHosts, a_host_ends_with_its_owner_and_its_tasks_do_not) {
  pid_t process = -1;
  std::optional<pid_t> task;
  {
    TaskHost host({TETFARM_TASK_HOST});
    task = start(host, "sleep 0.3; exit 5");
    process = host.process();
    ASSERT_TRUE(is_there(process));
  }
  EXPECT_FALSE(is_there(process));
  EXPECT_EQ(exit_code(task), 5);
}

TEST_F(TaskHosts, nothing_starts_without_a_program_that_answers) {
  TaskHost none({});
  EXPECT_FALSE(start(none, "exit 0"));
  TaskHost missing({"/nowhere/tetfarm"});
  EXPECT_FALSE(start(missing, "exit 0"));
  TaskHost silent({"/bin/sleep", "1000"});
  EXPECT_FALSE(start(silent, "exit 0", 50));
  EXPECT_EQ(silent.process(), -1);
}

TEST_F(TaskHosts, a_child_task_runs_as_a_copy_or_else_as_its_program) {
  wire::Assign assign;
  const auto end_of = [&](TaskHost& host) {
    ChildTask child({.command = {"/bin/sh", "-c", "exit 8"}, .store = "exit 9", .host = &host},
                    assign);
    while (true) {
      if (const auto outcome = child.poll([](const wire::Doing&) {})) {
        return outcome->failed().message();
      }
      ::usleep(1000);
    }
  };
  EXPECT_THAT(end_of(host_), ::testing::HasSubstr("ended with code 9"));
  TaskHost missing({"/nowhere/tetfarm"});
  EXPECT_THAT(end_of(missing), ::testing::HasSubstr("ended with code 8"));
}

TEST_F(TaskHosts, that_fail_now_and_then_are_replaced_however_often) {
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(exit_code(start(host_, "exit 4")), 4) << i;
    const pid_t old = host_.process();
    ASSERT_GT(old, 0);
    ::kill(old, SIGKILL);
    ::waitid(P_PID, static_cast<id_t>(old), nullptr, WEXITED | WNOWAIT);
  }
}

TEST_F(TaskHosts, that_fail_again_and_again_are_tried_no_more) {
  const TempFolder folder;
  const std::string file = folder.path() / "starts";
  TaskHost host({"/bin/sh", "-c", "echo start >>" + file});
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(start(host, "exit 0", 2'000));
  std::ifstream starts(file);
  std::string line;
  int count = 0;
  while (std::getline(starts, line)) ++count;
  EXPECT_EQ(count, 3);
}

TEST_F(TaskHosts, are_not_asked_for_a_store_of_a_longer_name_than_they_take) {
  EXPECT_EQ(exit_code(start(host_, "exit 3 #" + std::string(4096 - 8, 'x'))), 3);
  EXPECT_FALSE(start(host_, "exit 3 #" + std::string(4097 - 8, 'x')));
}

}  // namespace
}  // namespace tetfarm
