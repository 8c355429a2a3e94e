#include "proto/file_chunks.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(FileChunks, are_of_one_size_but_for_the_last) {
  EXPECT_EQ(chunk_bytes, 262'144U);
  const std::uint64_t size = 2 * chunk_bytes + 5;
  EXPECT_EQ(chunk_size(size, 0), chunk_bytes);
  EXPECT_EQ(chunk_size(size, chunk_bytes), chunk_bytes);
  EXPECT_EQ(chunk_size(size, 2 * chunk_bytes), 5U);
  EXPECT_EQ(chunk_size(size, size - 1), 1U);
  EXPECT_EQ(chunk_size(size, size), 0U);
  EXPECT_EQ(chunk_size(size, size + 1), 0U);
  EXPECT_EQ(chunk_size(0, 0), 0U);
  EXPECT_EQ(chunk_size(chunk_bytes, 0), chunk_bytes);
}

TEST(FileChunks, are_intact_when_they_are_what_was_filled_in) {
  wire::FileChunk chunk;
  fill_chunk(chunk, "some bytes");
  EXPECT_EQ(chunk.bytes(), "some bytes");
  EXPECT_EQ(chunk.checksum().size(), 32U);
  EXPECT_TRUE(is_intact(chunk));
  chunk.set_bytes("some bytez");
  EXPECT_FALSE(is_intact(chunk));
  chunk.set_bytes("some bytes");
  chunk.set_checksum(std::string(32, '0'));
  EXPECT_FALSE(is_intact(chunk));
  EXPECT_FALSE(is_intact({})) << "nothing has a checksum too";
  fill_chunk(chunk, "");
  EXPECT_TRUE(is_intact(chunk));
  fill_chunk(chunk, std::string(chunk_bytes, 'x'));
  EXPECT_TRUE(is_intact(chunk));
  fill_chunk(chunk, std::string(chunk_bytes + 1, 'x'));
  EXPECT_FALSE(is_intact(chunk)) << "it is no chunk";
}

}  // namespace
}  // namespace tetfarm
