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

}  // namespace
}  // namespace tetfarm
