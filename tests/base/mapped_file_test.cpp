#include "base/mapped_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

class Mapped : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& bytes) const {
    const std::filesystem::path path = folder_.path() / "file";
    write_file_atomically(path, bytes);
    return path;
  }
  TempFolder folder_;
};

TEST_F(Mapped, has_the_bytes_of_the_file_even_when_that_is_gone) {
  const std::string bytes(10'000, 'x');
  const MappedFile file(written(bytes));
  std::filesystem::remove(folder_.path() / "file");
  EXPECT_EQ(file.bytes(), bytes);
  file.let_go(9'000);
  EXPECT_EQ(file.bytes(), bytes) << "what was let go comes back";
}

TEST_F(Mapped, an_empty_file_has_no_bytes) {
  const MappedFile file(written(""));
  file.let_go(10);
  EXPECT_TRUE(file.bytes().empty());
  EXPECT_TRUE(MappedFile().bytes().empty());
}

TEST_F(Mapped, moves_leave_the_bytes_where_they_are) {
  MappedFile file(written("abc"));
  const char* const place = file.bytes().data();
  MappedFile moved = std::move(file);
  EXPECT_EQ(moved.bytes().data(), place);
  MappedFile other;
  other = std::move(moved);
  EXPECT_EQ(other.bytes(), "abc");
}

TEST_F(Mapped, a_file_that_is_not_there_or_a_folder_is_refused) {
  EXPECT_THROW(MappedFile(folder_.path() / "none"), IoError);
  EXPECT_THROW(MappedFile(folder_.path()), IoError);
}

}  // namespace
}  // namespace tetfarm
