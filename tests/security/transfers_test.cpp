// Files over the connection: a worker that asks for what is not its own, or sends what it has not
// announced.
#include "base/hash.h"
#include "proto/file_chunks.h"
#include "tasks/failure_cause.h"
#include "tests/security/raw_worker.h"

namespace tetfarm {
namespace {

using test::RawPeer;
using test::RawWorker;

namespace fs = std::filesystem;

constexpr std::uint64_t largest = ~std::uint64_t{0};

class Transfers : public test::WithOneJob {
 protected:
  Transfers() : worker_(farm(), farm().keys_of("node"), "far away") {}

  void SetUp() override {
    WithOneJob::SetUp();
    held_ = worker_.take_task();
  }
  wire::Envelope fetch(const std::string& hash, std::uint64_t offset = 0) const {
    wire::Envelope envelope;
    wire::FetchFile& fetch = *envelope.mutable_fetch_file();
    fetch.set_task(held_.task());
    fetch.set_attempt(held_.attempt());
    fetch.set_hash(hash);
    fetch.set_offset(offset);
    return envelope;
  }
  wire::Envelope offer(const std::string& hash, std::uint64_t size) const {
    wire::Envelope envelope;
    wire::OfferFile& offer = *envelope.mutable_offer_file();
    offer.set_task(held_.task());
    offer.set_attempt(held_.attempt());
    offer.set_hash(hash);
    offer.set_size(size);
    return envelope;
  }
  wire::Envelope chunk(const std::string& hash, std::uint64_t offset,
                       const std::string& bytes) const {
    wire::Envelope envelope;
    wire::FileChunk& chunk = *envelope.mutable_file_chunk();
    chunk.set_task(held_.task());
    chunk.set_attempt(held_.attempt());
    chunk.set_hash(hash);
    chunk.set_offset(offset);
    fill_chunk(chunk, bytes);
    return envelope;
  }
  /// No answer, and so many more are counted as senseless.
  void expect_senseless(const wire::Envelope& message) {
    const std::uint64_t before = counted("senseless");
    worker_.peer().send(message);
    EXPECT_TRUE(worker_.peer().hears_nothing());
    EXPECT_EQ(counted("senseless"), before + 1);
  }
  static bool is_published(const std::string& hash) {
    for (const auto& file : fs::recursive_directory_iterator(farm().store() / "artifacts")) {
      const std::string name = file.path().filename();
      if (file.is_regular_file() && hash.ends_with(name)) return true;
    }
    return false;
  }
  static std::uintmax_t scratch_bytes() {
    std::uintmax_t bytes = 0;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(farm().store() / "scratch", error)) {
      if (file.is_regular_file()) bytes += file.file_size();
    }
    return bytes;
  }

  RawWorker worker_;
  wire::Assign held_;
};

TEST_F(Transfers, the_inputs_of_its_task_are_fetched_whole) {
  const wire::Artifact& input = held_.inputs(0);
  const wire::Envelope answer = worker_.peer().ask(fetch(input.hash()));
  EXPECT_EQ(hash128(answer.file_chunk().bytes()).hex(), input.hash());
}

TEST_F(Transfers, what_is_no_input_of_its_task_cannot_be_fetched) {
  expect_senseless(fetch(hash128("no such file").hex()));
  expect_senseless(fetch("../../keys/coordinator.key"));
  expect_senseless(fetch(""));
}

TEST_F(Transfers, a_file_of_another_job_cannot_be_fetched) {
  RawPeer anna = peer("anna");
  wire::Envelope other = test::submission(farm(), "other job");
  other.mutable_submit()->set_job_toml(test::good_job("secret plans"));
  const std::string job = anna.ask(other).submitted().job();
  const std::string hash = hash128(test::good_job("secret plans")).hex();
  EXPECT_TRUE(is_published(hash)) << "it is there";
  expect_senseless(fetch(hash));
  EXPECT_EQ(farm().ask({"cancel", job}, "anna").code, 0);
}

TEST_F(Transfers, the_files_of_another_workers_task_cannot_be_fetched) {
  RawWorker thief(farm(), farm().keys_of("spare"), "thief");
  const wire::Envelope answer = thief.peer().ask(fetch(held_.inputs(0).hash()));
  EXPECT_FALSE(answer.accepted().taken()) << answer.ShortDebugString();
  EXPECT_TRUE(thief.peer().hears_nothing());
}

TEST_F(Transfers, offsets_that_cannot_be_bring_nothing) {
  const std::string hash = held_.inputs(0).hash();
  expect_senseless(fetch(hash, 1));
  expect_senseless(fetch(hash, largest));
  EXPECT_TRUE(worker_.peer().ask(fetch(hash, chunk_bytes << 40U)).file_chunk().missing());
}

TEST_F(Transfers, a_chunk_of_a_file_that_was_not_offered_is_senseless) {
  expect_senseless(chunk(hash128("unasked").hex(), 0, "unasked"));
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, a_file_under_the_name_of_a_path_is_senseless) {
  expect_senseless(offer("../../../planted", 7));
  expect_senseless(chunk("../../../planted", 0, "planted"));
  EXPECT_FALSE(fs::exists(farm().folder() / "planted"));
}

TEST_F(Transfers, chunks_out_of_order_are_asked_for_anew_and_not_written) {
  const std::string hash = hash128("two chunks").hex();
  worker_.peer().ask(offer(hash, 2 * chunk_bytes));
  const wire::Envelope answer =
      worker_.peer().ask(chunk(hash, chunk_bytes, std::string(chunk_bytes, 'b')));
  EXPECT_TRUE(answer.file_stored().resend());
  EXPECT_EQ(answer.file_stored().bytes(), 0U);
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, a_chunk_with_another_checksum_is_not_written) {
  const std::string hash = hash128("checked").hex();
  worker_.peer().ask(offer(hash, 7));
  wire::Envelope wrong = chunk(hash, 0, "checked");
  wrong.mutable_file_chunk()->set_bytes("wrecked");
  EXPECT_TRUE(worker_.peer().ask(wrong).file_stored().resend());
  wrong.mutable_file_chunk()->set_checksum("");
  EXPECT_TRUE(worker_.peer().ask(wrong).file_stored().resend());
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, a_chunk_larger_or_smaller_than_a_chunk_is_not_written) {
  const std::string hash = hash128("large").hex();
  worker_.peer().ask(offer(hash, 8 * chunk_bytes));
  for (const std::uint64_t size : {4 * chunk_bytes, std::uint64_t{1}, std::uint64_t{0}}) {
    const wire::Envelope answer = worker_.peer().ask(chunk(hash, 0, std::string(size, 'x')));
    EXPECT_TRUE(answer.file_stored().resend()) << size;
  }
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, a_file_that_is_not_what_its_name_says_is_not_published) {
  const std::string hash = hash128("honest").hex();
  worker_.peer().ask(offer(hash, 6));
  const wire::Envelope answer = worker_.peer().ask(chunk(hash, 0, "forged"));
  EXPECT_FALSE(answer.file_stored().whole());
  EXPECT_FALSE(is_published(hash));
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, a_chunk_that_overlaps_what_is_there_changes_nothing) {
  const std::string bytes(chunk_bytes + 10, 'a');
  const std::string hash = hash128(bytes).hex();
  worker_.peer().ask(offer(hash, bytes.size()));
  worker_.peer().ask(chunk(hash, 0, bytes.substr(0, chunk_bytes)));
  const wire::Envelope again = worker_.peer().ask(chunk(hash, 0, std::string(chunk_bytes, 'z')));
  EXPECT_EQ(again.file_stored().bytes(), chunk_bytes);
  EXPECT_FALSE(again.file_stored().whole());
  EXPECT_TRUE(
      worker_.peer().ask(chunk(hash, chunk_bytes, std::string(10, 'a'))).file_stored().whole());
  EXPECT_TRUE(is_published(hash));
}

TEST_F(Transfers, files_of_unheard_of_sizes_are_only_as_large_as_what_was_sent) {
  const std::string hash = hash128("endless").hex();
  for (const std::uint64_t size : {largest, largest >> 1U, std::uint64_t{1} << 60U}) {
    worker_.peer().send(offer(hash, size));
    for (std::uint64_t i = 0; i < 4; ++i) {
      worker_.peer().send(chunk(hash, i * chunk_bytes, std::string(chunk_bytes, 'e')));
    }
  }
  while (worker_.peer().hear(test::deaf_ms)) continue;
  EXPECT_LE(scratch_bytes(), 16 * chunk_bytes);
  EXPECT_FALSE(is_published(hash));
}

TEST_F(Transfers, what_came_of_a_file_is_gone_when_the_attempt_is_over) {
  const std::string hash = hash128("half").hex();
  worker_.peer().ask(offer(hash, 2 * chunk_bytes));
  worker_.peer().ask(chunk(hash, 0, std::string(chunk_bytes, 'h')));
  EXPECT_EQ(scratch_bytes(), chunk_bytes);
  wire::Envelope killed = test::failed_message(held_.task(), held_.attempt());
  killed.mutable_failed()->set_cause(on_wire(FailureCause::killed));
  EXPECT_TRUE(worker_.is_taken(killed));
  for (int i = 0; i < 400 && scratch_bytes() > 0; ++i) farm().status();
  EXPECT_EQ(scratch_bytes(), 0U);
}

TEST_F(Transfers, thirty_thousand_offers_cost_a_bounded_amount_of_memory) {
  for (int i = 0; i < 30'000; ++i) {
    ASSERT_TRUE(worker_.peer().send(offer(hash128(std::to_string(i)).hex(), 1)));
    if (i % 50 == 0) {
      while (worker_.peer().hear(0)) continue;
    }
  }
  EXPECT_GT(counted("senseless"), 0U);
}

TEST_F(Transfers, requests_beyond_the_window_are_not_heard) {
  const std::string hash = held_.inputs(0).hash();
  for (int i = 0; i < 2000; ++i) ASSERT_TRUE(worker_.peer().send(fetch(hash)));
  while (worker_.peer().hear(test::deaf_ms)) continue;
  EXPECT_EQ(worker_.peer().ask(fetch(hash)).file_chunk().hash(), hash);
}

}  // namespace
}  // namespace tetfarm
