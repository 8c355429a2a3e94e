#include "worker/file_exchange.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "proto/file_chunks.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(FileExchange, an_input_that_the_task_found_damaged_is_kept_no_longer) {
  const TempFolder folder;
  FileExchange exchange(folder.path(), 1U << 20U);
  const StoredArtifact damaged = exchange.store().publish("an input");
  const StoredArtifact sound = exchange.store().publish("another");
  wire::Envelope outcome;
  outcome.mutable_failed()->add_damaged_inputs(damaged.hash);
  exchange.send_outputs(outcome);
  EXPECT_FALSE(exchange.store().has(damaged.hash, damaged.size));
  EXPECT_TRUE(exchange.store().has(sound.hash, sound.size));
}

TEST(FileExchange, that_has_nothing_to_send_is_not_sending) {
  const TempFolder folder;
  FileExchange exchange(folder.path(), 1U << 20U);
  EXPECT_FALSE(exchange.is_fetching());
  EXPECT_TRUE(exchange.due(0).empty());
  wire::Envelope outcome;
  outcome.mutable_failed();
  exchange.send_outputs(outcome);
  EXPECT_FALSE(exchange.is_sending());
  EXPECT_TRUE(exchange.due(0).empty());
}

/// A file of two chunks, and a task that reads it.
class FileExchangeFlow : public testing::Test {
 protected:
  FileExchangeFlow() {
    assign_.set_task(5);
    assign_.set_attempt(7);
    wire::Artifact& input = *assign_.add_inputs();
    input.set_name("mesh");
    input.set_hash(hash128(bytes_).hex());
    input.set_size(bytes_.size());
  }
  wire::Envelope chunk(std::uint64_t offset, std::uint64_t attempt = 7) const {
    wire::Envelope envelope;
    wire::FileChunk& chunk = *envelope.mutable_file_chunk();
    chunk.set_task(5);
    chunk.set_attempt(attempt);
    chunk.set_hash(hash128(bytes_).hex());
    chunk.set_offset(offset);
    fill_chunk(chunk, bytes_.substr(offset, chunk_size(bytes_.size(), offset)));
    return envelope;
  }

  const std::string bytes_ = std::string(chunk_bytes, 'a') + "end";
  const TempFolder folder_;
  FileExchange exchange_{folder_.path(), 10U << 20U};
  wire::Assign assign_;
};

TEST_F(FileExchangeFlow, asks_for_the_inputs_chunk_by_chunk_until_they_are_whole) {
  EXPECT_TRUE(exchange_.has_room());
  exchange_.fetch_inputs(assign_);
  EXPECT_TRUE(exchange_.is_fetching());
  const std::vector<wire::Envelope> asked = exchange_.due(0);
  ASSERT_EQ(asked.size(), 2U);
  EXPECT_EQ(asked[0].fetch_file().task(), 5U);
  EXPECT_EQ(asked[0].fetch_file().attempt(), 7U);
  EXPECT_EQ(asked[0].fetch_file().offset(), 0U);
  EXPECT_EQ(asked[1].fetch_file().offset(), chunk_bytes);
  EXPECT_TRUE(exchange_.due(1).empty());
  exchange_.ask_again();
  EXPECT_EQ(exchange_.due(2).size(), 2U) << "the connection is new";
  exchange_.take(chunk(0, 8), 3);
  exchange_.take(chunk(chunk_bytes), 3);
  exchange_.take(chunk(0), 4);
  EXPECT_TRUE(exchange_.is_fetching());
  exchange_.take(chunk(chunk_bytes), 5);
  EXPECT_FALSE(exchange_.is_fetching());
  EXPECT_EQ(exchange_.damaged_input(), "");
  EXPECT_EQ(exchange_.store().read(hash128(bytes_).hex(), bytes_.size()), bytes_);
  exchange_.fetch_inputs(assign_);
  EXPECT_FALSE(exchange_.is_fetching()) << "it is there already";
}

TEST_F(FileExchangeFlow, names_an_input_that_nobody_has) {
  exchange_.fetch_inputs(assign_);
  wire::Envelope missing = chunk(0);
  missing.mutable_file_chunk()->set_missing(true);
  exchange_.take(missing, 1);
  EXPECT_EQ(exchange_.damaged_input(), hash128(bytes_).hex());
  exchange_.forget_task();
  EXPECT_EQ(exchange_.damaged_input(), "");
  EXPECT_FALSE(exchange_.is_fetching());
}

TEST_F(FileExchangeFlow, offers_the_outputs_and_sends_them_from_where_it_is_told) {
  const StoredArtifact made = exchange_.store().publish(bytes_);
  wire::Envelope outcome;
  outcome.mutable_done()->set_task(5);
  outcome.mutable_done()->set_attempt(7);
  wire::Artifact& output = *outcome.mutable_done()->add_outputs();
  output.set_hash(made.hash);
  output.set_size(made.size);
  exchange_.send_outputs(outcome);
  EXPECT_TRUE(exchange_.is_sending());
  std::vector<wire::Envelope> sent = exchange_.due(0);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].offer_file().ShortDebugString(),
            "task: 5 attempt: 7 hash: \"" + made.hash + "\" size: " + std::to_string(made.size));
  wire::Envelope stored;
  stored.mutable_file_stored()->set_attempt(7);
  stored.mutable_file_stored()->set_hash(made.hash);
  stored.mutable_file_stored()->set_bytes(chunk_bytes);
  stored.mutable_file_stored()->set_resend(true);
  exchange_.take(stored, 1);
  sent = exchange_.due(2);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].file_chunk().offset(), chunk_bytes);
  EXPECT_EQ(sent[0].file_chunk().bytes(), "end");
  EXPECT_TRUE(is_intact(sent[0].file_chunk()));
  stored.mutable_file_stored()->set_whole(true);
  exchange_.take(stored, 3);
  EXPECT_FALSE(exchange_.is_sending());
}

}  // namespace
}  // namespace tetfarm
