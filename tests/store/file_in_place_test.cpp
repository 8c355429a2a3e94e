#include "store/file_in_place.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using State = FileInPlace::State;

class FileInPlaceTest : public testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& bytes = "the same bytes") const {
    std::ofstream(folder_.path() / name) << bytes;
    return folder_.path() / name;
  }
  TempFolder folder_;
};

TEST_F(FileInPlaceTest, that_is_written_to_is_still_the_same) {
  const FileInPlace opened(file("a"));
  std::ofstream(opened.path(), std::ios::app) << "more";
  EXPECT_EQ(opened.look(), State::there);
}

TEST_F(FileInPlaceTest, that_was_moved_away_is_removed_until_it_is_back) {
  const FileInPlace opened(file("a"));
  fs::rename(opened.path(), folder_.path() / "elsewhere");
  EXPECT_EQ(opened.look(), State::removed);
  fs::rename(folder_.path() / "elsewhere", opened.path());
  EXPECT_EQ(opened.look(), State::there);
}

TEST_F(FileInPlaceTest, is_replaced_by_another_whatever_its_bytes) {
  const FileInPlace opened(file("a"));
  fs::rename(file("b"), opened.path());
  EXPECT_EQ(opened.look(), State::replaced);
}

TEST_F(FileInPlaceTest, is_removed_with_its_folder) {
  fs::create_directory(folder_.path() / "folder");
  const FileInPlace opened(file("folder/a"));
  fs::remove_all(folder_.path() / "folder");
  EXPECT_EQ(opened.look(), State::removed);
}

TEST_F(FileInPlaceTest, has_to_be_there_first) {
  EXPECT_THROW(FileInPlace(folder_.path() / "nothing"), IoError);
}

}  // namespace
}  // namespace tetfarm
