#include "cli/member_life.h"

#include <gtest/gtest.h>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(MemberLife, of_who_ends_at_once_again_and_again_pauses_ever_longer) {
  MemberLife life;
  std::int64_t now = 1'000;
  int lives = 0;
  for (const std::int64_t pause : {100, 200, 400, 800, 1'600, 1'600, 1'600}) {
    life.started_ms = now;
    now += 1'999;
    life.note_death(true, now);
    EXPECT_EQ(life.short_lives, ++lives);
    EXPECT_EQ(life.start_again_ms, now + pause);
  }
}

TEST(MemberLife, that_was_long_or_ended_by_a_signal_is_no_reason_to_wait) {
  MemberLife life;
  life.short_lives = 3;
  life.started_ms = 1'000;
  life.note_death(true, 3'000);
  EXPECT_EQ(life.short_lives, 0);
  EXPECT_EQ(life.start_again_ms, 3'050);
  life.short_lives = 3;
  life.note_death(false, 1'001);
  EXPECT_EQ(life.short_lives, 0);
}

TEST(LastError, of_a_log_is_the_last_that_it_names) {
  const TempFolder folder;
  const std::filesystem::path log = folder.path() / "workers.log";
  EXPECT_EQ(last_error(log), "") << "there is no log";
  write_file_atomically(log, "");
  EXPECT_EQ(last_error(log), "");
  write_file_atomically(log, "all is well\n");
  EXPECT_EQ(last_error(log), "");
  write_file_atomically(log, "error: first\nerror: second\nhelp: do this\n");
  EXPECT_EQ(last_error(log), "second");
  write_file_atomically(log, "error: without an end");
  EXPECT_EQ(last_error(log), "without an end");
  write_file_atomically(log, "error: long ago\n" + std::string(4'000, 'x'));
  EXPECT_EQ(last_error(log), "");
}

}  // namespace
}  // namespace tetfarm
