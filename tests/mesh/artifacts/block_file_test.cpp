#include "mesh/artifacts/block_file.h"

#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <random>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string some_content(std::size_t size) {
  std::mt19937 random(7);
  std::string content(size, '\0');
  for (char& byte : content) byte = static_cast<char>(random());
  return content;
}

std::string flipped(std::string bytes, std::size_t place) {
  bytes.at(place) = static_cast<char>(bytes.at(place) ^ 4);
  return bytes;
}

class BlockFiles : public testing::Test {
 protected:
  BlockFile open(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return {path_, "the file"};
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "file";
};

TEST_F(BlockFiles, give_every_part_as_it_is) {
  for (const std::size_t size : {0U, 1U, 4095U, 4096U, 4097U, 8192U, 500'000U}) {
    const std::string content = some_content(size);
    const std::string bytes = with_block_checksums(content);
    EXPECT_EQ(content_of_blocks(bytes, "f"), content) << size;
    BlockFile file = open(bytes);
    ASSERT_EQ(file.size(), size);
    EXPECT_EQ(file.read(0, size), content);
    EXPECT_EQ(file.read(size / 3, size / 2), content.substr(size / 3, size / 2));
  }
}

TEST_F(BlockFiles, give_items_that_lie_across_blocks) {
  std::string content = some_content(3);
  std::vector<std::array<std::int64_t, 3>> items(2000);
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].fill(static_cast<std::int64_t>(i) * 0x123456789a);
    content.append(reinterpret_cast<const char*>(items[i].data()), sizeof items[i]);
  }
  BlockFile file = open(with_block_checksums(content));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::size_t other = i * 977 % items.size();
    EXPECT_EQ((file.item<std::array<std::int64_t, 3>>(3, other)), items[other]);
  }
}

TEST_F(BlockFiles, of_which_a_part_is_read_are_not_read_whole) {
  BlockFile file = open(with_block_checksums(some_content(1'000'000)));
  EXPECT_EQ(file.bytes_read(), 0U);
  file.read(100'000, 16);
  EXPECT_EQ(file.bytes_read(), block_size);
  for (std::uint64_t i = 0; i < 100; ++i) file.item<std::uint32_t>(100'000, i);
  EXPECT_EQ(file.bytes_read(), block_size) << "a block is kept";
  file.read(2 * block_size - 1, 2);
  EXPECT_EQ(file.bytes_read(), 3 * block_size);
}

TEST_F(BlockFiles, keep_some_blocks_and_not_all_that_were_read) {
  constexpr std::uint64_t blocks = 100;
  BlockFile file = open(with_block_checksums(some_content(blocks * block_size)));
  for (std::uint64_t i = 0; i < blocks; ++i) file.read(i * block_size, 1);
  EXPECT_EQ(file.bytes_read(), blocks * block_size);
  file.read(0, 1);
  EXPECT_EQ(file.bytes_read(), (blocks + 1) * block_size) << "the first is kept no longer";
}

TEST_F(BlockFiles, that_are_damaged_are_refused_where_the_damage_is_read_and_only_there) {
  const std::string bytes = with_block_checksums(some_content(3 * block_size));
  BlockFile content_damaged = open(flipped(bytes, block_size + 9));
  EXPECT_NO_THROW(content_damaged.read(0, block_size));
  EXPECT_NO_THROW(content_damaged.read(2 * block_size, block_size));
  EXPECT_THAT([&] { content_damaged.read(block_size + 500, 1); },
              ThrowsMessage<CorruptFile>(HasSubstr("the file: has a wrong checksum for block 1")));
  BlockFile checksum_damaged = open(flipped(bytes, 3 * block_size + 2 * 16 + 15));
  EXPECT_NO_THROW(checksum_damaged.read(0, 2 * block_size));
  EXPECT_THROW(checksum_damaged.read(2 * block_size, 1), CorruptFile);
}

TEST_F(BlockFiles, with_blocks_changed_about_are_refused) {
  const std::string content = some_content(2 * block_size);
  const std::string bytes = with_block_checksums(content);
  BlockFile file = open(content.substr(block_size) + content.substr(0, block_size) +
                        bytes.substr(2 * block_size));
  EXPECT_THROW(file.read(0, 1), CorruptFile);
  EXPECT_THROW(file.read(block_size, 1), CorruptFile);
}

TEST_F(BlockFiles, that_were_cut_short_are_refused_whatever_is_read) {
  const std::string bytes = with_block_checksums(some_content(2 * block_size + 300));
  for (std::size_t size = 1; size < bytes.size(); size += 97) {
    EXPECT_THROW(open(bytes.substr(0, size)).read(0, 1), CorruptFile) << size;
  }
  BlockFile whole = open(bytes);
  EXPECT_THROW(whole.read(2 * block_size, 301), CorruptFile);
  EXPECT_THROW(whole.read(~std::uint64_t{0}, 2), CorruptFile);
  EXPECT_THROW(whole.item<std::uint64_t>(0, block_size), CorruptFile);
}

TEST(Blocks, that_are_damaged_or_cut_short_anywhere_are_refused_when_all_is_read) {
  const std::string bytes = with_block_checksums(some_content(block_size + 70));
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    EXPECT_THROW(content_of_blocks(flipped(bytes, place), "f"), CorruptFile) << place;
    if (place == 0) continue;
    EXPECT_THROW(content_of_blocks(std::string_view(bytes).substr(0, place), "f"), CorruptFile)
        << place;
  }
  EXPECT_THROW(content_of_blocks(bytes + '\0', "f"), CorruptFile);
}

TEST(Blocks, no_file_is_a_file_without_content) {
  EXPECT_EQ(with_block_checksums(""), "");
  EXPECT_EQ(content_of_blocks("", "f"), "");
}

TEST_F(BlockFiles, that_are_not_there_are_told_by_their_path) {
  EXPECT_THROW(BlockFile(folder_.path() / "none", "f"), IoError);
}

TEST_F(BlockFiles, are_cut_short_for_who_reads_beyond_all_numbers) {
  BlockFile file = open(with_block_checksums("some bytes"));
  for (const std::uint64_t offset : {~std::uint64_t{0}, ~std::uint64_t{0} - 7, std::uint64_t{11}}) {
    EXPECT_THROW(file.item<std::uint64_t>(offset, 0), CorruptFile) << offset;
    EXPECT_THROW(file.read(offset, 8), CorruptFile) << offset;
  }
}

}  // namespace
}  // namespace tetfarm
