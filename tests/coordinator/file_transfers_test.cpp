#include "coordinator/file_transfers.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "base/hash.h"
#include "proto/file_chunks.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::SizeIs;

const std::string job_bytes = "job";
const std::string surface_bytes(3 * chunk_bytes + 5, 's');

/// Workers that hold an attempt each of one of many jobs, and a store to carry orders out in.
class FileTransfersTest : public ::testing::Test {
 protected:
  WorkerId lease() {
    Submission submission;
    const StoredArtifact surface = store_.publish(surface_bytes);
    submission.given = {{store_.publish(job_bytes).hash, job_bytes.size()},
                        TaskFile{surface.hash, surface.size},
                        std::nullopt};
    state_.submit(submission, now_);
    const std::string process = "process-" + std::to_string(state_.worker_count());
    const WorkerId worker = state_.add_worker({.host = "h", .nonce = process}, {}, {}, now_);
    state_.worker_is_ready(worker, now_);
    state_.tick(now_);
    return worker;
  }
  template <class Body>
  static void name(Body& body, std::uint64_t number, const std::string& hash) {
    body.set_task(number);
    body.set_attempt(number);
    body.set_hash(hash);
  }
  /// Worker, task and attempt n.
  bool fetch(std::uint64_t n, std::uint64_t offset, const std::string& bytes = surface_bytes) {
    wire::Envelope envelope;
    name(*envelope.mutable_fetch_file(), n, hash128(bytes).hex());
    envelope.mutable_fetch_file()->set_offset(offset);
    return take(n, envelope);
  }
  bool offer(std::uint64_t n, const std::string& bytes) {
    wire::Envelope envelope;
    name(*envelope.mutable_offer_file(), n, hash128(bytes).hex());
    envelope.mutable_offer_file()->set_size(bytes.size());
    return take(n, envelope);
  }
  bool send(std::uint64_t n, const std::string& bytes, std::uint64_t offset,
            const std::string& part) {
    wire::Envelope envelope;
    wire::FileChunk& chunk = *envelope.mutable_file_chunk();
    name(chunk, n, hash128(bytes).hex());
    chunk.set_offset(offset);
    fill_chunk(chunk, part);
    return take(n, envelope);
  }
  bool take(std::uint64_t n, const wire::Envelope& envelope) {
    return transfers_.take("c" + std::to_string(n), WorkerId{n}, envelope, state_, now_);
  }
  std::vector<FileAnswer> carry_out_all() {
    std::vector<FileAnswer> answers;
    for (const FileOrder& order : transfers_.take_orders(state_, now_)) {
      answers.push_back(carry_out(order, store_));
      transfers_.note_answer(order.connection);
    }
    return answers;
  }
  /// What FileStored says to the only order.
  wire::FileStored stored() {
    const std::vector<FileAnswer> answers = carry_out_all();
    EXPECT_THAT(answers, SizeIs(1));
    return answers.empty() ? wire::FileStored() : answers[0].envelope.file_stored();
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  Moment now_{1000, 1000};
  JobState state_{{}, {}, [](const ArtifactRef&) { return true; }, now_};
  FileTransfers transfers_{2};
};

TEST_F(FileTransfersTest, an_input_comes_chunk_by_chunk) {
  lease();
  for (std::uint64_t offset = 0; offset < surface_bytes.size(); offset += chunk_bytes) {
    EXPECT_TRUE(fetch(1, offset));
  }
  std::string got;
  for (const FileAnswer& answer : carry_out_all()) {
    EXPECT_TRUE(is_intact(answer.envelope.file_chunk()));
    got += answer.envelope.file_chunk().bytes();
  }
  EXPECT_EQ(got, surface_bytes);
}

TEST_F(FileTransfersTest, only_inputs_of_the_attempt_that_the_worker_holds) {
  lease();
  store_.publish("secret");
  EXPECT_FALSE(fetch(1, 0, "secret"));
  EXPECT_FALSE(fetch(1, 1)) << "no chunk begins there";
  EXPECT_FALSE(fetch(2, 0)) << "another attempt";
  state_.worker_left(WorkerId{1}, true, now_);
  EXPECT_FALSE(fetch(1, 0)) << "the attempt is over";
  EXPECT_FALSE(send(1, "output", 0, "output")) << "not offered";
}

TEST_F(FileTransfersTest, an_attempt_can_offer_more_files_than_any_task_makes_but_not_without_end) {
  lease();
  int offers = 0;
  while (offers < 1'000'000 && offer(1, std::to_string(offers))) {
    ++offers;
    for (const FileOrder& order : transfers_.take_orders(state_, now_)) {
      transfers_.note_answer(order.connection);
    }
  }
  EXPECT_EQ(offers, 10'000);
  EXPECT_TRUE(offer(1, "0")) << "one that was offered may be again";
}

TEST_F(FileTransfersTest, far_behind_the_end_of_a_file_there_is_nothing) {
  lease();
  EXPECT_TRUE(fetch(1, chunk_bytes << 40U));
  EXPECT_TRUE(carry_out_all().at(0).envelope.file_chunk().missing());
}

TEST_F(FileTransfersTest, a_missing_or_cut_file_is_said_to_be_missing) {
  lease();
  write_file_atomically(store_.path_of(hash128(surface_bytes).hex()), "short");
  fetch(1, 0);
  EXPECT_TRUE(carry_out_all().at(0).envelope.file_chunk().missing());
}

TEST_F(FileTransfersTest, an_output_goes_on_where_it_was_and_is_published_when_whole_and_sound) {
  lease();
  const std::string bytes(2 * chunk_bytes, 'o');
  const std::string hash = hash128(bytes).hex();
  const std::string part(chunk_bytes, 'o');
  offer(1, bytes);
  EXPECT_TRUE(stored().resend());
  send(1, bytes, 0, part);
  EXPECT_EQ(stored().bytes(), chunk_bytes);
  send(1, bytes, 0, part);
  EXPECT_EQ(stored().bytes(), chunk_bytes) << "sent twice";
  transfers_.forget_connections();
  offer(1, bytes);
  EXPECT_EQ(stored().bytes(), chunk_bytes) << "after a break";
  EXPECT_FALSE(store_.has(hash, bytes.size()));
  send(1, bytes, chunk_bytes, part);
  EXPECT_TRUE(stored().whole());
  EXPECT_NO_THROW(store_.verify(hash, bytes.size()));
}

TEST_F(FileTransfersTest, a_file_that_is_not_what_was_announced_is_not_published) {
  lease();
  offer(1, "output");
  stored();
  send(1, "output", 0, "outpux");
  const wire::FileStored answer = stored();
  EXPECT_TRUE(answer.resend());
  EXPECT_EQ(answer.bytes(), 0U);
  EXPECT_FALSE(store_.has(hash128("outpux").hex(), 6));
}

TEST_F(FileTransfersTest, what_came_of_an_attempt_that_is_over_is_removed) {
  lease();
  const std::string bytes(2 * chunk_bytes, 'o');
  offer(1, bytes);
  stored();
  send(1, bytes, 0, std::string(chunk_bytes, 'o'));
  stored();
  const auto path = upload_path(store_, AttemptId{1}, hash128(bytes).hex());
  ASSERT_TRUE(size_of_file(path));
  state_.worker_left(WorkerId{1}, true, now_);
  EXPECT_FALSE(offer(1, bytes)) << "fenced";
  carry_out_all();
  EXPECT_FALSE(size_of_file(path));
}

TEST_F(FileTransfersTest, after_a_restart_only_uploads_of_running_attempts_stay) {
  for (const std::uint64_t attempt : {7, 8}) {
    append_to_file(upload_path(store_, AttemptId{attempt}, std::string(32, 'a')), 0, "part");
  }
  drop_uploads_but({AttemptId{8}}, store_);
  EXPECT_FALSE(size_of_file(upload_path(store_, AttemptId{7}, std::string(32, 'a'))));
  EXPECT_TRUE(size_of_file(upload_path(store_, AttemptId{8}, std::string(32, 'a'))));
}

TEST_F(FileTransfersTest, serves_few_at_once_and_the_others_in_turn) {
  for (int i = 0; i < 3; ++i) lease();
  for (const std::uint64_t n : {3, 1, 2}) EXPECT_TRUE(fetch(n, 0));
  EXPECT_THAT(carry_out_all(), SizeIs(2));
  EXPECT_THAT(carry_out_all(), SizeIs(0)) << "the two may go on";
  now_.steady_ms += 3 * chunk_again_ms;
  const std::vector<FileAnswer> answers = carry_out_all();
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_EQ(answers[0].connection, "c2");
}

TEST_F(FileTransfersTest, more_than_a_window_is_not_heard) {
  lease();
  const std::string bytes(chunk_bytes, 'o');
  offer(1, bytes);
  int heard = 0;
  for (std::uint64_t i = 0; i < 100; ++i) heard += send(1, bytes, i * chunk_bytes, "x") ? 1 : 0;
  EXPECT_LE(heard, static_cast<int>(2 * chunks_at_once));
  EXPECT_LE(carry_out_all().size(), chunks_at_once);
}

}  // namespace
}  // namespace tetfarm
