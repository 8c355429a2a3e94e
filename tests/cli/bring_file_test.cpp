#include "cli/bring_file.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "proto/file_chunks.h"
#include "tests/cli/fake_coordinator.h"

namespace tetfarm {
namespace {

std::string bytes_of_three_chunks() {
  std::string bytes(2 * chunk_bytes + 1000, ' ');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  return bytes;
}

/// Takes a file into `taken`, of which it has `there` bytes already.
class Taker {
 public:
  Taker(std::string taken, std::size_t size) : taken_(std::move(taken)), size_(size) {}

  std::vector<wire::Envelope> answer(const wire::Envelope& said) {
    if (said.has_file_chunk()) {
      const wire::FileChunk& chunk = said.file_chunk();
      EXPECT_EQ(chunk.attempt(), 0U);
      EXPECT_TRUE(is_intact(chunk));
      if (chunk.offset() == taken_.size()) taken_ += chunk.bytes();
      ++chunks_;
    }
    wire::Envelope envelope;
    wire::FileStored& stored = *envelope.mutable_file_stored();
    stored.set_hash(said.has_file_chunk() ? said.file_chunk().hash() : said.offer_file().hash());
    stored.set_resend(said.has_offer_file());
    stored.set_bytes(taken_.size());
    stored.set_whole(taken_.size() == size_);
    return {envelope};
  }
  const std::string& taken() const { return taken_; }
  int chunks() const { return chunks_; }

 private:
  std::string taken_;
  std::size_t size_;
  int chunks_ = 0;
};

/// What is brought to a coordinator that has so much of it.
void expect_brought(std::size_t there, int chunks) {
  const std::string bytes = bytes_of_three_chunks();
  Taker taker(bytes.substr(0, there), bytes.size());
  FakeCoordinator coordinator([&taker](const wire::Envelope& said) { return taker.answer(said); });
  CoordinatorConnection connection(coordinator.endpoint());
  const StoredArtifact file =
      bring_file(connection, bytes, "wing.stl", {5'000, ProgressStyle::none});
  EXPECT_EQ(file.hash, hash128(bytes).hex());
  EXPECT_EQ(file.size, bytes.size());
  EXPECT_EQ(taker.taken(), bytes);
  EXPECT_EQ(taker.chunks(), chunks);
  EXPECT_EQ(coordinator.heard().front().offer_file().hash(), file.hash);
  EXPECT_EQ(coordinator.heard().front().offer_file().size(), file.size);
}

TEST(BringFile, sends_all_of_it_chunk_by_chunk) { expect_brought(0, 3); }

TEST(BringFile, sends_nothing_of_what_is_there) {
  expect_brought(chunk_bytes, 2);
  expect_brought(bytes_of_three_chunks().size(), 0);
}

}  // namespace
}  // namespace tetfarm
