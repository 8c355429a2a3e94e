#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>

#include "base/clock.h"
#include "base/counted.h"
#include "base/mebibytes.h"
#include "base/retry_on_eintr.h"

namespace tetfarm {
namespace {

TEST(Counted, is_one_thing_or_several) {
  EXPECT_EQ(counted(0, "worker"), "0 workers");
  EXPECT_EQ(counted(1, "worker"), "1 worker");
  EXPECT_EQ(counted(2, "worker"), "2 workers");
  EXPECT_EQ(counted(1, "loss", "losses"), "1 loss");
  EXPECT_EQ(counted(11, "loss", "losses"), "11 losses");
}

TEST(Mebibytes, are_rounded_down) {
  EXPECT_EQ(mebibytes(0), "0 MiB");
  EXPECT_EQ(mebibytes((1U << 20U) - 1), "0 MiB");
  EXPECT_EQ(mebibytes(1U << 20U), "1 MiB");
  EXPECT_EQ(mebibytes(38'797'312), "37 MiB");
}

TEST(RetryOnEintr, makes_the_call_until_no_signal_interrupts_it) {
  int calls = 0;
  EXPECT_EQ(retry_on_eintr([&]() -> ssize_t {
              errno = EINTR;
              return ++calls < 3 ? -1 : 7;
            }),
            7);
  EXPECT_EQ(calls, 3);
  calls = 0;
  EXPECT_EQ(retry_on_eintr([&]() -> ssize_t {
              errno = EIO;
              ++calls;
              return -1;
            }),
            -1);
  EXPECT_EQ(calls, 1);
}

TEST(Clock, counts_milliseconds) {
  const std::int64_t steady = steady_ms();
  const std::int64_t wall = wall_ms();
  EXPECT_GE(steady_ms(), steady);
  EXPECT_LE(steady_ms() - steady, 10'000);
  EXPECT_LE(std::abs(wall - static_cast<std::int64_t>(std::time(nullptr)) * 1000), 10'000);
}

}  // namespace
}  // namespace tetfarm
