#include "worker/task_cache.h"

#include <gtest/gtest.h>

#include <chrono>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// Three files of ten bytes that were used one after the other.
class TaskCacheTest : public ::testing::Test {
 protected:
  TaskCacheTest() {
    const auto now = std::filesystem::file_time_type::clock::now();
    for (const auto& [file, age] : {std::pair(&oldest_, 3), {&middle_, 2}, {&newest_, 1}}) {
      std::filesystem::last_write_time(cache_.store().path_of(*file),
                                       now - std::chrono::hours(age));
    }
  }
  std::string publish(char digit) const {
    return cache_.store().publish(std::string(10, digit)).hash;
  }
  bool has(const std::string& hash) const { return cache_.store().has(hash, 10); }

  TempFolder folder_;
  TaskCache cache_{folder_.path(), 30};
  std::string oldest_ = publish('a');
  std::string middle_ = publish('b');
  std::string newest_ = publish('c');
};

TEST_F(TaskCacheTest, what_fits_stays) {
  cache_.make_room(0, {});
  EXPECT_TRUE(has(oldest_) && has(middle_) && has(newest_));
}

TEST_F(TaskCacheTest, makes_room_by_what_was_not_used_for_longest) {
  cache_.make_room(1, {});
  EXPECT_FALSE(has(oldest_));
  EXPECT_TRUE(has(middle_) && has(newest_));
  cache_.make_room(20, {});
  EXPECT_FALSE(has(middle_));
  EXPECT_TRUE(has(newest_));
}

TEST_F(TaskCacheTest, what_is_needed_stays_however_old_and_however_full_it_is) {
  cache_.make_room(1, {oldest_});
  EXPECT_TRUE(has(oldest_));
  EXPECT_FALSE(has(middle_));
  EXPECT_TRUE(has(newest_));
  cache_.make_room(1'000, {oldest_});
  EXPECT_TRUE(has(oldest_));
  EXPECT_FALSE(has(newest_));
}

TEST_F(TaskCacheTest, what_is_touched_is_the_newest) {
  cache_.touch(oldest_);
  cache_.make_room(1, {});
  EXPECT_TRUE(has(oldest_));
  EXPECT_FALSE(has(middle_));
}

TEST_F(TaskCacheTest, what_was_found_damaged_goes_and_a_name_that_is_none_is_passed_over) {
  cache_.drop(newest_);
  EXPECT_FALSE(has(newest_));
  cache_.drop("../worker.lock");
  EXPECT_TRUE(has(oldest_) && has(middle_));
}

TEST_F(TaskCacheTest, two_workers_have_folders_of_their_own_and_the_next_finds_what_is_left) {
  {
    const TaskCache other(folder_.path(), 30);
    EXPECT_NE(other.store().folder(), cache_.store().folder());
    other.store().publish("left");
  }
  const TaskCache next(folder_.path(), 30);
  EXPECT_EQ(count_files(next.store().folder() / "artifacts"), 1U);
}

}  // namespace
}  // namespace tetfarm
