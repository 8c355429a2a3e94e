#include "base/child_process.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace tetfarm {
namespace {

/// The exit code of a child that runs `body`; -1 where a signal ended it.
template <class Body>
int exit_code_of_child(Body&& body) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(body());
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(ChildProcess, lives_in_a_group_of_its_own_with_no_signal_blocked_and_dies_with_its_parent) {
  sigset_t blocked;
  sigset_t before;
  ::sigemptyset(&blocked);
  ::sigaddset(&blocked, SIGUSR1);
  ::sigaddset(&blocked, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &blocked, &before);
  const pid_t parent = ::getpid();
  const int code = exit_code_of_child([parent] {
    live_with_parent(parent);
    sigset_t now;
    ::sigprocmask(SIG_SETMASK, nullptr, &now);
    int at_death = 0;
    ::prctl(PR_GET_PDEATHSIG, &at_death);
    if (::sigismember(&now, SIGUSR1) != 0 || ::sigismember(&now, SIGTERM) != 0) return 1;
    if (::getpgrp() != ::getpid()) return 2;
    return at_death == SIGKILL ? 0 : 3;
  });
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(code, 0);
}

TEST(ChildProcess, ends_at_once_when_its_parent_is_gone_already) {
  const pid_t another = ::getppid();
  EXPECT_EQ(exit_code_of_child([another] {
              live_with_parent(another);
              return 0;
            }),
            127);
}

TEST(ChildProcess, arguments_are_the_words_and_an_end) {
  const std::vector<std::string> words = {"mesh", "", "a b"};
  const std::vector<char*> arguments = exec_arguments(words);
  ASSERT_EQ(arguments.size(), 4U);
  EXPECT_STREQ(arguments[0], "mesh");
  EXPECT_STREQ(arguments[1], "");
  EXPECT_STREQ(arguments[2], "a b");
  EXPECT_EQ(arguments[3], nullptr);
}

}  // namespace
}  // namespace tetfarm
