// What a worker without the store brings is believed when its bytes are what they were said to be.
#include "coordinator/file_orders.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/hash.h"
#include "proto/file_chunks.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

class FileOrders : public testing::Test {
 protected:
  FileOrders() : store_(folder_.path()) {
    order_.attempt = AttemptId{1};
    order_.file.hash = hash128(text_).hex();
    order_.file.size = text_.size();
  }
  const std::string text_ = "a mesh";
  const TempFolder folder_;
  ArtifactStore store_;
  FileOrder order_;
};

TEST_F(FileOrders, a_chunk_that_arrives_with_other_bytes_is_not_kept_and_is_sent_again) {
  // The first of two: the checksum of the whole file would tell only at the end.
  order_.file.size = chunk_bytes + 1;
  order_.kind = FileOrder::Kind::append;
  fill_chunk(order_.chunk, std::string(chunk_bytes, 'x'));
  order_.chunk.mutable_bytes()->front() = 'y';
  const wire::FileStored damaged = carry_out(order_, store_).envelope.file_stored();
  EXPECT_TRUE(damaged.resend());
  EXPECT_EQ(damaged.bytes(), 0U);
  order_.chunk.mutable_bytes()->front() = 'x';
  EXPECT_EQ(carry_out(order_, store_).envelope.file_stored().bytes(), chunk_bytes);
}

TEST_F(FileOrders, what_lies_damaged_under_the_name_of_a_file_is_not_taken_for_it) {
  store_.publish(text_);
  order_.kind = FileOrder::Kind::open;
  EXPECT_TRUE(carry_out(order_, store_).envelope.file_stored().whole());
  std::ofstream(store_.path_of(order_.file.hash), std::ios::binary) << "a mash";
  EXPECT_FALSE(carry_out(order_, store_).envelope.file_stored().whole());
}

TEST_F(FileOrders, a_damaged_file_is_put_aside_and_a_missing_one_counts_as_damaged) {
  using Verdict = CheckedFile::Verdict;
  store_.publish(text_);
  order_.kind = FileOrder::Kind::check;
  EXPECT_EQ(carry_out(order_, store_).checked->verdict, Verdict::sound);
  std::ofstream(store_.path_of(order_.file.hash), std::ios::binary) << "a mash";
  const FileAnswer answer = carry_out(order_, store_);
  EXPECT_EQ(answer.checked->verdict, Verdict::damaged);
  EXPECT_EQ(answer.checked->attempt, order_.attempt);
  EXPECT_NE(answer.trouble, "") << "the log shall name it";
  EXPECT_FALSE(std::filesystem::exists(store_.path_of(order_.file.hash)));
  EXPECT_EQ(carry_out(order_, store_).checked->verdict, Verdict::damaged);
}

TEST_F(FileOrders, a_damaged_file_that_cannot_be_put_aside_is_not_called_damaged) {
  order_.kind = FileOrder::Kind::check;
  std::filesystem::create_directories(store_.path_of(order_.file.hash).parent_path());
  std::ofstream(store_.path_of(order_.file.hash)) << "a mash";
  std::ofstream(folder_.path() / "damaged") << "a file where the folder would be";
  const FileAnswer answer = carry_out(order_, store_);
  EXPECT_EQ(answer.checked->verdict, CheckedFile::Verdict::unknown);
  EXPECT_NE(answer.trouble, "");
}

}  // namespace
}  // namespace tetfarm
