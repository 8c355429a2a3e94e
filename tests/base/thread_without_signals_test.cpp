#include "base/thread_without_signals.h"

#include <gtest/gtest.h>

#include <csignal>

namespace tetfarm {
namespace {

bool blocks(int signal) {
  sigset_t mask;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &mask);
  return sigismember(&mask, signal) == 1;
}

TEST(ThreadWithoutSignals, takes_none_and_leaves_its_starter_as_it_was) {
  bool does_block = false;
  thread_without_signals([&] { does_block = blocks(SIGTERM) && blocks(SIGINT); }).join();
  EXPECT_TRUE(does_block);
  EXPECT_FALSE(blocks(SIGTERM));
}

}  // namespace
}  // namespace tetfarm
