#include "cli/seen_times.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(SeenTimes, a_range_has_two_digits_and_a_unit_that_suits) {
  EXPECT_EQ(range_text(19.8, 91), "20 to 91 s");
  EXPECT_EQ(range_text(0.123, 0.47), "0.12 to 0.47 s");
  EXPECT_EQ(range_text(123, 456), "120 to 460 s");
  EXPECT_EQ(range_text(66, 1200), "1.1 to 20 min");
  EXPECT_EQ(range_text(3600, 36000), "1 to 10 h");
  EXPECT_EQ(range_text(9.96, 100), "10 to 100 s");
  EXPECT_EQ(range_text(0, 0), "0 s");
}

TEST(SeenTimes, ends_that_read_the_same_are_one_number) {
  EXPECT_EQ(range_text(2.01, 2.04), "2 s");
}

TEST(SeenTimes, without_a_store_nothing_is_learnt) {
  EXPECT_EQ(times_seen_in("", "").learnt(), 0U);
}

TEST(SeenTimes, a_folder_that_is_no_store_is_not_found) {
  const TempFolder folder;
  try {
    times_seen_in(folder.path().string(), "");
    FAIL() << "took an empty folder for a store";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
  }
}

}  // namespace
}  // namespace tetfarm
