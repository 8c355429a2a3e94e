#include "worker/output_upload.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/file_chunks.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

const std::string bytes = std::string(chunk_bytes, 'a') + std::string(chunk_bytes / 2, 'b');

/// An output of two chunks lies in the cache, and the coordinator has nothing of it.
class OutputUploadTest : public ::testing::Test {
 protected:
  OutputUpload upload() const {
    wire::Envelope outcome;
    wire::Artifact& output = *outcome.mutable_done()->add_outputs();
    output.set_hash(file_.hash);
    output.set_size(file_.size);
    outcome.mutable_done()->set_attempt(attempt);
    return {cache_, outcome};
  }
  wire::FileStored stored(std::uint64_t there, bool resend, bool whole = false) const {
    wire::FileStored message;
    message.set_attempt(attempt);
    message.set_hash(file_.hash);
    message.set_bytes(there);
    message.set_resend(resend);
    message.set_whole(whole);
    return message;
  }
  std::filesystem::path path() const { return cache_.store().path_of(file_.hash); }

  static constexpr std::uint64_t attempt = 7;
  /// Long enough for a second demand to send again to be heard.
  static constexpr std::int64_t later_ms = 2000;
  TempFolder folder_;
  TaskCache cache_{folder_.path(), 1U << 30U};
  StoredArtifact file_ = cache_.store().publish(bytes);
};

TEST_F(OutputUploadTest, is_complete_when_the_coordinator_has_every_chunk) {
  OutputUpload sent = upload();
  EXPECT_EQ(sent.due(0).size(), 1U) << "the offer";
  sent.take(stored(0, true), 0);
  EXPECT_EQ(sent.due(1).size(), 2U);
  sent.take(stored(bytes.size(), false, true), 1);
  EXPECT_TRUE(sent.is_complete());
}

TEST_F(OutputUploadTest, a_sound_file_is_sent_again_from_where_a_chunk_was_lost) {
  OutputUpload sent = upload();
  sent.due(0);
  sent.take(stored(0, true), 0);
  EXPECT_EQ(sent.due(1).size(), 2U);
  sent.take(stored(chunk_bytes, true), later_ms);
  const std::vector<wire::Envelope> again = sent.due(later_ms);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].file_chunk().offset(), chunk_bytes);
}

TEST_F(OutputUploadTest, a_file_damaged_in_the_cache_is_dropped_and_told_not_sent_for_ever) {
  std::string damaged = bytes;
  damaged[50] = 'x';
  write_file_atomically(path(), damaged);
  OutputUpload sent = upload();
  sent.due(0);
  sent.take(stored(0, true), 0);
  EXPECT_EQ(sent.due(1).size(), 2U);
  EXPECT_THROW(sent.take(stored(0, true), later_ms), CorruptFile);
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(OutputUploadTest, a_file_refused_at_once_is_looked_at_when_it_is_offered_again) {
  std::string damaged = bytes;
  damaged[50] = 'x';
  write_file_atomically(path(), damaged);
  OutputUpload sent = upload();
  sent.due(0);
  sent.take(stored(0, true), 0);
  EXPECT_EQ(sent.due(1).size(), 2U);
  sent.take(stored(0, true), 2);
  const std::int64_t again_ms = chunk_again_ms + 10;
  EXPECT_TRUE(sent.due(again_ms).front().has_offer_file());
  EXPECT_THROW(sent.take(stored(0, true), again_ms), CorruptFile);
}

TEST_F(OutputUploadTest, a_file_that_has_become_shorter_is_dropped_and_told) {
  write_file_atomically(path(), bytes.substr(0, 100));
  OutputUpload sent = upload();
  sent.due(0);
  sent.take(stored(0, true), 0);
  EXPECT_THROW(sent.due(1), CorruptFile);
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(OutputUploadTest, an_answer_to_another_attempt_says_nothing_about_this_one) {
  OutputUpload sent = upload();
  sent.due(0);
  wire::FileStored late = stored(bytes.size(), false, true);
  late.set_attempt(attempt - 1);
  sent.take(late, 0);
  EXPECT_FALSE(sent.is_complete());
  late = stored(0, true);
  late.set_attempt(attempt - 1);
  sent.take(late, 0);
  EXPECT_TRUE(sent.due(1).empty()) << "it is not known yet where to begin";
}

TEST_F(OutputUploadTest, a_new_connection_that_has_lost_a_part_is_given_it_again) {
  OutputUpload sent = upload();
  sent.due(0);
  sent.take(stored(0, true), 0);
  sent.due(1);
  sent.take(stored(chunk_bytes, false), 1);
  sent.ask_again();
  EXPECT_TRUE(sent.due(2).front().has_offer_file());
  sent.take(stored(0, true), later_ms);
  EXPECT_EQ(sent.due(later_ms).front().file_chunk().offset(), 0U);
}

}  // namespace
}  // namespace tetfarm
