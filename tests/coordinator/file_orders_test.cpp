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
  /// The bytes as they arrive, with the checksum of what was sent.
  wire::FileStored append(const std::string& bytes) {
    order_.kind = FileOrder::Kind::append;
    fill_chunk(order_.chunk, text_);
    order_.chunk.set_bytes(bytes);
    return carry_out(order_, store_).envelope.file_stored();
  }

  const std::string text_ = "a mesh";
  const TempFolder folder_;
  ArtifactStore store_;
  FileOrder order_;
};

TEST_F(FileOrders, a_chunk_that_arrives_with_other_bytes_is_not_kept_and_is_sent_again) {
  const wire::FileStored damaged = append("a mash");
  EXPECT_TRUE(damaged.resend());
  EXPECT_EQ(damaged.bytes(), 0U);
  EXPECT_FALSE(std::filesystem::exists(upload_path(store_, order_.attempt, order_.file.hash)));
  EXPECT_TRUE(append(text_).whole());
  EXPECT_TRUE(store_.has(order_.file.hash, text_.size()));
}

TEST_F(FileOrders, what_lies_damaged_under_the_name_of_a_file_is_not_taken_for_it) {
  store_.publish(text_);
  order_.kind = FileOrder::Kind::open;
  EXPECT_TRUE(carry_out(order_, store_).envelope.file_stored().whole());
  std::ofstream(store_.path_of(order_.file.hash), std::ios::binary) << "a mash";
  EXPECT_FALSE(carry_out(order_, store_).envelope.file_stored().whole());
}

}  // namespace
}  // namespace tetfarm
