#include "worker/file_send.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A file of four chunks and a bit.
class FileSendTest : public testing::Test {
 protected:
  wire::FileStored stored(std::uint64_t bytes, bool resend = false, bool whole = false) const {
    wire::FileStored message;
    message.set_hash("hash");
    message.set_bytes(bytes);
    message.set_resend(resend);
    message.set_whole(whole);
    return message;
  }
  static constexpr std::uint64_t chunk = chunk_bytes;
  FileSend send_{{"hash", 4 * chunk + 5}};
};

TEST_F(FileSendTest, is_offered_and_sent_from_where_the_answer_says) {
  const FileSend::Due first = send_.due(0);
  EXPECT_TRUE(first.offer);
  EXPECT_THAT(first.chunks, IsEmpty()) << "nobody has said yet where to begin";
  EXPECT_FALSE(send_.due(1).offer) << "once is enough";
  EXPECT_TRUE(send_.take(stored(chunk, true), 10));
  EXPECT_EQ(send_.there(), chunk);
  EXPECT_THAT(send_.due(11).chunks, ElementsAre(chunk, 2 * chunk)) << "two at first";
  EXPECT_THAT(send_.due(12).chunks, IsEmpty());
  EXPECT_EQ(send_.setbacks(), 0);
}

TEST_F(FileSendTest, goes_on_as_chunks_arrive_until_it_is_whole) {
  send_.due(0);
  send_.take(stored(0, true), 1);
  EXPECT_THAT(send_.due(2).chunks, ElementsAre(0, chunk));
  EXPECT_TRUE(send_.take(stored(2 * chunk), 3));
  EXPECT_EQ(send_.there(), 2 * chunk);
  EXPECT_THAT(send_.due(4).chunks, ElementsAre(2 * chunk, 3 * chunk, 4 * chunk));
  EXPECT_TRUE(send_.take(stored(chunk), 5)) << "an old answer";
  EXPECT_EQ(send_.there(), 2 * chunk);
  EXPECT_FALSE(send_.is_whole());
  EXPECT_TRUE(send_.take(stored(0, false, true), 6));
  EXPECT_TRUE(send_.is_whole());
  EXPECT_EQ(send_.there(), 4 * chunk + 5);
  EXPECT_FALSE(send_.due(100'000).offer);
  EXPECT_FALSE(send_.take(stored(0, true), 7)) << "it is over";
}

TEST_F(FileSendTest, goes_back_once_for_all_that_say_so_within_half_a_second) {
  send_.due(0);
  send_.take(stored(0, true), 1000);
  send_.due(1001);
  EXPECT_TRUE(send_.take(stored(chunk, true), 1499));
  EXPECT_EQ(send_.setbacks(), 0) << "the answers to what was on the way";
  EXPECT_EQ(send_.there(), 0U);
  EXPECT_TRUE(send_.take(stored(chunk, true), 1500));
  EXPECT_EQ(send_.setbacks(), 1);
  EXPECT_EQ(send_.there(), chunk);
  EXPECT_THAT(send_.due(1501).chunks, ElementsAre(chunk, 2 * chunk));
}

TEST_F(FileSendTest, is_offered_again_when_nothing_was_heard_for_a_while) {
  EXPECT_TRUE(send_.due(0).offer);
  EXPECT_FALSE(send_.due(chunk_again_ms).offer);
  EXPECT_TRUE(send_.due(chunk_again_ms + 1).offer);
  send_.take(stored(0, true), 3000);
  EXPECT_FALSE(send_.due(3000 + chunk_again_ms).offer) << "it was heard at 3000";
  const FileSend::Due again = send_.due(3000 + chunk_again_ms + 1);
  EXPECT_TRUE(again.offer);
  EXPECT_THAT(again.chunks, IsEmpty()) << "where to go on is to be said first";
  send_.take(stored(chunk, true), 6000);
  send_.ask_again();
  EXPECT_TRUE(send_.due(6001).offer) << "on a new connection at once";
}

TEST_F(FileSendTest, hears_nothing_of_other_files) {
  send_.due(0);
  wire::FileStored other = stored(chunk, true, true);
  other.set_hash("another");
  EXPECT_FALSE(send_.take(other, 1));
  EXPECT_FALSE(send_.is_whole());
  EXPECT_EQ(send_.there(), 0U);
}

}  // namespace
}  // namespace tetfarm
