#include "store/disk_room.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(DiskRoomFigures, are_those_of_the_file_system_that_the_path_or_a_folder_above_it_lies_on) {
  const TempFolder folder;
  const auto space = std::filesystem::space(folder.path());
  const DiskRoom room = disk_room(folder.path());
  EXPECT_EQ(room.total_bytes, space.capacity);
  EXPECT_LE(room.free_bytes, space.free);
  EXPECT_GT(room.free_bytes, 0U);
  EXPECT_EQ(disk_room(folder.path() / "not/yet/there").total_bytes, space.capacity);
  std::ofstream(folder.path() / "file") << "x";
  try {
    disk_room(folder.path() / "file/below");
    ADD_FAILURE() << "there is nothing below a file";
  } catch (const IoError& error) {
    EXPECT_EQ(error.what(), (folder.path() / "file/below").string() +
                                ": cannot tell how much room the disk has: Not a directory");
  }
}

TEST(DiskRoomFigures, leave_a_reserve_alone) {
  constexpr std::uint64_t mib = 1U << 20U;
  EXPECT_EQ((DiskRoom{0, 100 * mib}).reserve(), 5 * mib) << "a 20th of a small disk";
  EXPECT_EQ((DiskRoom{0, 1280 * mib}).reserve(), 64 * mib);
  EXPECT_EQ((DiskRoom{0, 1'000'000 * mib}).reserve(), 64 * mib);
  const DiskRoom room{70 * mib, 100'000 * mib};
  EXPECT_TRUE(room.has(6 * mib));
  EXPECT_FALSE(room.has(6 * mib + 1));
  EXPECT_FALSE((DiskRoom{63 * mib, 100'000 * mib}).has(0));
  EXPECT_TRUE((DiskRoom{0, 0}).has(1'000'000 * mib)) << "nothing is known";
}

}  // namespace
}  // namespace tetfarm
