#include "mesh/formats/scratch_file.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

std::string content_of(const ScratchFile& file) {
  std::string bytes(static_cast<std::size_t>(file.size()), '?');
  file.read(0, bytes.data(), bytes.size());
  return bytes;
}

TEST(ScratchFile, has_what_was_written_and_zeros_between) {
  const TempFolder folder;
  ScratchFile file(folder.path());
  file.append("tet", 3);
  file.write(5, "farm", 4);
  file.write(0, "T", 1);
  EXPECT_EQ(content_of(file), std::string("Tet\0\0farm", 9));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "it has no name";
}

TEST(ScratchFile, goes_on_where_it_was_when_it_is_moved) {
  const TempFolder folder;
  ScratchFile first(folder.path());
  first.append("tet", 3);
  ScratchFile second(std::move(first));
  second.append("far", 3);
  ScratchFile third;
  EXPECT_FALSE(third.is_open());
  third = std::move(second);
  third.append("m", 1);
  EXPECT_EQ(content_of(third), "tetfarm");
}

TEST(ScratchFile, tells_of_a_folder_that_is_not_there_and_of_bytes_that_are_not) {
  const TempFolder folder;
  EXPECT_THROW(ScratchFile(folder.path() / "none"), IoError);
  const ScratchFile file(folder.path());
  char byte = 0;
  EXPECT_THROW(file.read(0, &byte, 1), IoError);
}

}  // namespace
}  // namespace tetfarm
