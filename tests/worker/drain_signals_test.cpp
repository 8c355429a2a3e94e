#include "worker/drain_signals.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>

namespace tetfarm {
namespace {

/// In a process of its own: which signals are blocked outlives the object.
[[noreturn]] void raise_each() {
  const DrainSignals signals(true);
  if (signals.fd() < 0 || signals.take_one()) ::_exit(1);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2}) {
    ::raise(signal);
    pollfd waiting{signals.fd(), POLLIN, 0};
    if (::poll(&waiting, 1, 0) != 1) ::_exit(2);
    if (!signals.take_one()) ::_exit(3);
    if (signals.take_one()) ::_exit(4);
  }
  ::_exit(0);
}

TEST(DrainSignals, are_five_and_each_is_taken_once) {
  EXPECT_EXIT(raise_each(), testing::ExitedWithCode(0), "");
}

TEST(DrainSignals, that_are_not_wanted_are_left_alone) {
  sigset_t before;
  sigset_t after;
  ::sigprocmask(SIG_BLOCK, nullptr, &before);
  const DrainSignals signals(false);
  ::sigprocmask(SIG_BLOCK, nullptr, &after);
  EXPECT_EQ(signals.fd(), -1);
  EXPECT_FALSE(signals.take_one());
  EXPECT_EQ(::sigismember(&after, SIGTERM), ::sigismember(&before, SIGTERM));
}

}  // namespace
}  // namespace tetfarm
