#include "cli/transfer_display.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(TransferDisplay, amounts_have_a_unit_that_suits) {
  EXPECT_EQ(bytes_text(0), "0 B");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(1000), "1 kB");
  EXPECT_EQ(bytes_text(999'400), "999 kB");
  EXPECT_EQ(bytes_text(1'000'000), "1.0 MB");
  EXPECT_EQ(bytes_text(1'340'000), "1.3 MB");
  EXPECT_EQ(bytes_text(1'000'000'000), "1.00 GB");
  EXPECT_EQ(bytes_text(4'050'000'000), "4.05 GB");
}

TEST(TransferDisplay, says_nothing_of_what_has_only_begun_nor_when_it_is_not_wanted) {
  ::testing::internal::CaptureStderr();
  {
    TransferDisplay plain(ProgressStyle::plain);
    plain.show("fetching wing.vtkhdf", 5, 10);
    plain.show("fetching wing.vtkhdf", 6, 10);
    TransferDisplay none(ProgressStyle::none);
    none.show("fetching wing.vtkhdf", 5, 10);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(TransferDisplay, says_how_much_is_there_and_how_fast_it_comes) {
  EXPECT_EQ(transfer_text("fetching wing.vtkhdf", 1'300'000'000, 4'050'000'000, 300'000'000, 2'000),
            "fetching wing.vtkhdf  1.30 GB of 4.05 GB  500.0 MB/s");
  EXPECT_EQ(transfer_text("sending a.stl", 5, 1'000, 5, 0), "sending a.stl  5 B of 1 kB");
}

TEST(TransferDisplay, has_a_bar_that_is_full_when_all_is_there) {
  const auto full = [](std::uint64_t there) {
    const std::string bar = transfer_bar(there, 240);
    std::size_t filled = 0;
    for (std::size_t at = bar.find("█"); at != std::string::npos; at = bar.find("█", at + 1)) {
      ++filled;
    }
    EXPECT_EQ(bar.size(), 24 * std::string("─").size());
    return filled;
  };
  EXPECT_EQ(full(0), 0U);
  EXPECT_EQ(full(10), 1U);
  EXPECT_EQ(full(120), 12U);
  EXPECT_EQ(full(240), 24U);
}

}  // namespace
}  // namespace tetfarm
