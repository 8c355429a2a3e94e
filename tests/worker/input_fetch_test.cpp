#include "worker/input_fetch.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "proto/file_chunks.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string bytes = std::string(chunk_bytes, 'a') + std::string(chunk_bytes, 'b') + "end";

/// A task with one input of three chunks, of which nothing is there yet.
class InputFetchTest : public ::testing::Test {
 protected:
  InputFetchTest() {
    assign_.set_attempt(attempt);
    wire::Artifact& input = *assign_.add_inputs();
    input.set_hash(hash_);
    input.set_size(bytes.size());
  }
  wire::FileChunk chunk(std::uint64_t offset, const std::string& of = bytes) const {
    wire::FileChunk message;
    message.set_attempt(attempt);
    message.set_hash(hash_);
    message.set_offset(offset);
    fill_chunk(message, of.substr(offset, chunk_size(of.size(), offset)));
    return message;
  }
  void take_all(InputFetch& fetch, const std::string& of = bytes) const {
    for (std::uint64_t offset = 0; offset < of.size(); offset += chunk_bytes) {
      fetch.take(chunk(offset, of), 1);
    }
  }
  static std::vector<std::uint64_t> asked(const std::vector<wire::Envelope>& messages) {
    std::vector<std::uint64_t> offsets;
    for (const wire::Envelope& message : messages) offsets.push_back(message.fetch_file().offset());
    return offsets;
  }

  static constexpr std::uint64_t attempt = 7;
  TempFolder folder_;
  TaskCache cache_{folder_.path(), 1U << 30U};
  const std::string hash_ = hash128(bytes).hex();
  wire::Assign assign_;
};

TEST_F(InputFetchTest, is_complete_when_every_chunk_has_come) {
  InputFetch fetch(cache_, assign_);
  EXPECT_THAT(asked(fetch.due(0)), ElementsAre(0U, chunk_bytes));
  fetch.take(chunk(0), 1);
  EXPECT_FALSE(fetch.is_complete());
  take_all(fetch);
  EXPECT_TRUE(fetch.is_complete());
  EXPECT_EQ(fetch.damaged(), "");
  EXPECT_EQ(cache_.store().read(hash_, bytes.size()), bytes);
}

TEST_F(InputFetchTest, a_file_that_is_not_what_its_checksum_says_is_told_and_not_kept) {
  InputFetch fetch(cache_, assign_);
  take_all(fetch, std::string(bytes.size(), 'x'));
  EXPECT_EQ(fetch.damaged(), hash_);
  EXPECT_FALSE(std::filesystem::exists(cache_.store().path_of(hash_)));
  EXPECT_THAT(fetch.due(10'000), IsEmpty());
  EXPECT_EQ(count_files(cache_.store().scratch_folder()), 0U);
}

TEST_F(InputFetchTest, a_file_that_the_coordinator_does_not_have_is_told) {
  InputFetch fetch(cache_, assign_);
  wire::FileChunk missing;
  missing.set_attempt(attempt);
  missing.set_hash(hash_);
  missing.set_missing(true);
  fetch.take(missing, 1);
  EXPECT_EQ(fetch.damaged(), hash_);
}

TEST_F(InputFetchTest, a_chunk_that_comes_too_early_is_passed_over) {
  InputFetch fetch(cache_, assign_);
  fetch.take(chunk(chunk_bytes), 1);
  take_all(fetch);
  EXPECT_TRUE(fetch.is_complete());
  EXPECT_EQ(fetch.damaged(), "");
}

TEST_F(InputFetchTest, chunks_for_another_attempt_are_passed_over) {
  InputFetch fetch(cache_, assign_);
  wire::FileChunk late = chunk(0);
  late.set_attempt(attempt - 1);
  late.set_missing(true);
  fetch.take(late, 1);
  take_all(fetch);
  EXPECT_TRUE(fetch.is_complete());
  EXPECT_EQ(fetch.damaged(), "");
}

TEST_F(InputFetchTest, what_did_not_come_is_asked_for_again) {
  InputFetch fetch(cache_, assign_);
  fetch.due(0);
  EXPECT_THAT(fetch.due(chunk_again_ms), IsEmpty());
  EXPECT_THAT(asked(fetch.due(chunk_again_ms + 1)), Contains(0U));
  fetch.ask_again();
  EXPECT_THAT(asked(fetch.due(chunk_again_ms + 2)), Contains(0U));
}

TEST_F(InputFetchTest, inputs_that_are_there_are_not_asked_for_and_stay_for_those_that_come) {
  const StoredArtifact here = cache_.store().publish("here");
  wire::Artifact& input = *assign_.add_inputs();
  input.set_hash(here.hash);
  input.set_size(here.size);
  const TempFolder small;
  const TaskCache no_room(small.path(), 1);
  no_room.store().publish("here");
  no_room.store().publish("of another task");
  InputFetch fetch(no_room, assign_);
  for (const wire::Envelope& message : fetch.due(0)) {
    EXPECT_EQ(message.fetch_file().hash(), hash_);
  }
  EXPECT_TRUE(no_room.store().has(here.hash, here.size));
  EXPECT_EQ(count_files(no_room.store().folder() / "artifacts"), 1U);
}

TEST_F(InputFetchTest, who_gives_up_leaves_no_half_file) {
  {
    InputFetch fetch(cache_, assign_);
    fetch.take(chunk(0), 1);
    EXPECT_EQ(count_files(cache_.store().scratch_folder()), 1U);
  }
  EXPECT_EQ(count_files(cache_.store().scratch_folder()), 0U);
}

}  // namespace
}  // namespace tetfarm
