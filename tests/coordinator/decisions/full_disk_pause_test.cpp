#include "coordinator/decisions/full_disk_pause.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(FullDiskPause, is_over_after_a_while) {
  FullDiskPause pause(100, 350);
  EXPECT_EQ(pause.wait_ms(0), 0);
  EXPECT_TRUE(pause.begin("no room", 0));
  EXPECT_EQ(pause.wait_ms(0), 100);
  EXPECT_EQ(pause.wait_ms(100), 0);
  EXPECT_TRUE(pause.is_stuck()) << "until something is done";
}

TEST(FullDiskPause, is_doubled_each_time_up_to_the_longest) {
  FullDiskPause pause(100, 350);
  pause.begin("", 0);
  EXPECT_TRUE(pause.begin("", 100));
  EXPECT_EQ(pause.wait_ms(100), 200);
  EXPECT_TRUE(pause.begin("", 300));
  EXPECT_EQ(pause.wait_ms(300), 350);
}

TEST(FullDiskPause, who_finds_the_disk_full_within_it_tells_nothing_new) {
  FullDiskPause pause(100, 350);
  pause.begin("first", 0);
  EXPECT_FALSE(pause.begin("second", 99));
  EXPECT_EQ(pause.wait_ms(99), 1);
  EXPECT_EQ(pause.message(), "second");
}

TEST(FullDiskPause, ends_with_the_first_task_that_is_done_and_is_short_again) {
  FullDiskPause pause(100, 350);
  pause.begin("no room", 0);
  pause.begin("no room", 100);
  pause.end();
  EXPECT_FALSE(pause.is_stuck());
  EXPECT_EQ(pause.wait_ms(150), 0);
  EXPECT_EQ(pause.message(), "");
  pause.begin("no room", 200);
  EXPECT_EQ(pause.wait_ms(200), 100);
}

}  // namespace
}  // namespace tetfarm
