#include "coordinator/stop_signals.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

bool is_default(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_DFL;
}

TEST(StopSignals, either_of_the_two_is_noted_and_does_not_end_the_process) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const StopSignals signals(true);
    EXPECT_FALSE(signals.stopped()) << "left over from before";
    std::raise(signal);
    EXPECT_TRUE(signals.stopped()) << signal;
  }
}

TEST(StopSignals, a_file_that_grows_too_large_does_not_end_the_process) {
  const StopSignals signals(true);
  std::raise(SIGXFSZ);
  EXPECT_FALSE(signals.stopped());
}

TEST(StopSignals, are_left_as_they_were_found) {
  { const StopSignals signals(true); }
  for (const int signal : {SIGTERM, SIGINT, SIGXFSZ}) EXPECT_TRUE(is_default(signal)) << signal;
}

TEST(StopSignals, unwanted_ones_are_not_touched) {
  const StopSignals signals(false);
  for (const int signal : {SIGTERM, SIGINT, SIGXFSZ}) EXPECT_TRUE(is_default(signal)) << signal;
  EXPECT_FALSE(signals.stopped());
}

}  // namespace
}  // namespace tetfarm
