#include "worker/file_receive.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

const std::string bytes = std::string(2 * chunk_bytes, 'a') + std::string(chunk_bytes / 2, 'b');

class FileReceiveTest : public ::testing::Test {
 protected:
  FileReceive receive(const std::string& hash_of = bytes) const {
    return FileReceive(path_, {hash128(hash_of).hex(), hash_of.size()});
  }
  static wire::FileChunk chunk(std::uint64_t offset) {
    wire::FileChunk message;
    message.set_hash(hash128(bytes).hex());
    message.set_offset(offset);
    fill_chunk(message, bytes.substr(offset, chunk_size(bytes.size(), offset)));
    return message;
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "growing";
};

TEST_F(FileReceiveTest, a_file_is_whole_when_its_chunks_have_come_in_order) {
  FileReceive file = receive();
  EXPECT_EQ(file.next(0), 0U);
  EXPECT_EQ(file.next(0), chunk_bytes);
  EXPECT_FALSE(file.take(chunk(chunk_bytes), 1));
  EXPECT_TRUE(file.take(chunk(0), 1));
  EXPECT_FALSE(file.take(chunk(0), 1));
  EXPECT_TRUE(file.take(chunk(chunk_bytes), 1));
  EXPECT_EQ(file.state(), FileReceive::State::coming);
  EXPECT_TRUE(file.take(chunk(2 * chunk_bytes), 1));
  EXPECT_EQ(file.state(), FileReceive::State::whole);
  EXPECT_EQ(read_file(path_), bytes);
}

TEST_F(FileReceiveTest, another_process_goes_on_behind_the_last_whole_chunk) {
  write_file_atomically(path_, bytes.substr(0, chunk_bytes + 100));
  FileReceive file = receive();
  EXPECT_EQ(file.found(), chunk_bytes);
  EXPECT_EQ(file.next(0), chunk_bytes);
  EXPECT_TRUE(file.take(chunk(chunk_bytes), 1));
  EXPECT_TRUE(file.take(chunk(2 * chunk_bytes), 1));
  EXPECT_EQ(file.state(), FileReceive::State::whole);
  EXPECT_EQ(read_file(path_), bytes);
}

TEST_F(FileReceiveTest, what_was_there_and_is_wrong_is_found_out) {
  write_file_atomically(path_, std::string(chunk_bytes, 'x'));
  FileReceive file = receive();
  EXPECT_TRUE(file.take(chunk(chunk_bytes), 1));
  EXPECT_TRUE(file.take(chunk(2 * chunk_bytes), 1));
  EXPECT_EQ(file.state(), FileReceive::State::damaged);
  write_file_atomically(path_, std::string(bytes.size(), 'x'));
  EXPECT_EQ(receive().state(), FileReceive::State::damaged);
  write_file_atomically(path_, bytes + "more");
  EXPECT_EQ(receive().found(), 0U);
}

TEST_F(FileReceiveTest, a_chunk_that_was_damaged_on_its_way_is_asked_for_again) {
  FileReceive file = receive();
  wire::FileChunk wrong = chunk(0);
  (*wrong.mutable_bytes())[7] = 'x';
  EXPECT_EQ(file.next(0), 0U);
  EXPECT_FALSE(file.take(wrong, 1));
  while (file.next(1)) {
  }
  EXPECT_EQ(file.next(chunk_again_ms + 1), 0U);
}

TEST_F(FileReceiveTest, a_chunk_of_another_file_is_not_taken) {
  FileReceive file = receive();
  EXPECT_EQ(file.next(0), 0U);
  wire::FileChunk other = chunk(0);
  other.set_hash(hash128("another").hex());
  EXPECT_FALSE(file.take(other, 1));
  other.set_missing(true);
  EXPECT_FALSE(file.take(other, 1));
  EXPECT_EQ(file.state(), FileReceive::State::coming);
  EXPECT_EQ(file.there(), 0U);
  EXPECT_TRUE(file.take(chunk(0), 1));
}

TEST_F(FileReceiveTest, an_empty_file_needs_no_chunk_and_a_missing_one_gets_none) {
  EXPECT_EQ(receive("").state(), FileReceive::State::whole);
  FileReceive file = receive();
  wire::FileChunk missing;
  missing.set_hash(hash128(bytes).hex());
  missing.set_missing(true);
  EXPECT_TRUE(file.take(missing, 1));
  EXPECT_EQ(file.state(), FileReceive::State::missing);
  EXPECT_FALSE(file.next(10'000));
}

}  // namespace
}  // namespace tetfarm
