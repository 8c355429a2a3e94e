#include "mesh/assemble/file_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Larger than what is read at once.
std::string long_text() {
  std::string text(3'000'000, ' ');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * 37 / 11);
  return text;
}

FileRange range_of(const std::string& text, std::size_t offset, std::size_t size) {
  return {static_cast<std::int64_t>(offset), static_cast<std::int64_t>(size),
          hash128(std::string_view(text).substr(offset, size))};
}

TEST(FileRanges, are_right_where_the_file_holds_what_they_say) {
  const TempFolder folder;
  const std::string text = long_text();
  write_file_atomically(folder.path() / "a", text);
  const std::vector<FileRange> ranges = {range_of(text, 0, 10), range_of(text, 10, 2'000'000),
                                         range_of(text, 2'000'500, 7),
                                         range_of(text, 2'100'000, 900'000)};
  const ReadThrough read = read_through(folder.path() / "a", ranges);
  EXPECT_THAT(read.wrong, IsEmpty());
  EXPECT_EQ(read.size, std::ssize(text));
  EXPECT_EQ(read.hash, hash128(text));
}

TEST(FileRanges, are_wrong_with_one_other_byte_and_behind_the_end) {
  const TempFolder folder;
  const std::string text = long_text();
  std::string damaged = text;
  damaged[1'900'000] = static_cast<char>(damaged[1'900'000] ^ 4);
  damaged.resize(2'999'990);
  write_file_atomically(folder.path() / "a", damaged);
  const std::vector<FileRange> ranges = {range_of(text, 0, 10), range_of(text, 10, 2'000'000),
                                         range_of(text, 2'000'500, 7),
                                         range_of(text, 2'100'000, 900'000)};
  EXPECT_THAT(read_through(folder.path() / "a", ranges).wrong, ElementsAre(1, 3));
  EXPECT_THROW(read_through(folder.path() / "b", ranges), IoError);
}

}  // namespace
}  // namespace tetfarm
