#include "coordinator/client_files.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const std::string mesh_bytes(3 * chunk_bytes + 5, 'm');
const std::string secret_bytes = "the surface of somebody else";
const std::string surface_bytes(2 * chunk_bytes + 7, 's');

/// Clients of a coordinator whose job-1 has one result.
class ClientFilesTest : public ::testing::Test {
 protected:
  static ClientSender sender(const std::string& connection, const std::string& key = "anna") {
    return {connection, client_name(key)};
  }
  void fetch(std::uint64_t offset, const std::string& connection = "c1", std::uint64_t job = 1,
             const std::string& bytes = mesh_bytes) {
    wire::FetchFile message;
    message.set_task(job);
    message.set_hash(hash128(bytes).hex());
    message.set_offset(offset);
    const auto files = [this](JobId number) {
      ++looked_up_;
      return number == JobId{1} ? std::optional(std::vector<StoredArtifact>{mesh_}) : std::nullopt;
    };
    clients_.fetch(sender(connection), message, files, now_);
  }
  void offer(const std::string& bytes, const ClientSender& from) {
    wire::OfferFile message;
    message.set_hash(hash128(bytes).hex());
    message.set_size(bytes.size());
    clients_.offer(from, message, now_);
  }
  bool send(const std::string& bytes, std::uint64_t offset, const ClientSender& from) {
    wire::FileChunk message;
    message.set_hash(hash128(bytes).hex());
    message.set_offset(offset);
    fill_chunk(message, bytes.substr(offset, chunk_size(bytes.size(), offset)));
    return clients_.append(from, message, now_);
  }
  std::vector<FileAnswer> carry_out_all() {
    std::vector<FileAnswer> answers;
    for (const FileOrder& order : clients_.take_orders(now_)) {
      answers.push_back(carry_out(order, store_));
      clients_.note_answer(answers.back());
    }
    return answers;
  }
  wire::FileStored stored() {
    const std::vector<FileAnswer> answers = carry_out_all();
    EXPECT_THAT(answers, SizeIs(1));
    return answers.empty() ? wire::FileStored() : answers[0].envelope.file_stored();
  }
  static ExitCode code_of(const std::function<void()>& action) {
    try {
      action();
      return ExitCode::ok;
    } catch (const Error& error) {
      return error.code();
    }
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  StoredArtifact mesh_ = store_.publish(mesh_bytes);
  StoredArtifact secret_ = store_.publish(secret_bytes);
  Moment now_{1000, 1000};
  int looked_up_ = 0;
  ClientFiles clients_{{.lines = {.served = 2, .under_way = 2},
                        .surfaces = 3,
                        .surfaces_of_client = 2,
                        .kept_ms = 60'000}};
};

TEST_F(ClientFilesTest, a_result_comes_chunk_by_chunk_and_is_looked_up_once) {
  std::string bytes;
  for (std::uint64_t offset = 0; offset < mesh_bytes.size(); offset += chunk_bytes) {
    fetch(offset);
    for (const FileAnswer& answer : carry_out_all()) {
      EXPECT_TRUE(is_intact(answer.envelope.file_chunk()));
      bytes += answer.envelope.file_chunk().bytes();
    }
  }
  EXPECT_EQ(bytes, mesh_bytes);
  EXPECT_EQ(looked_up_, 1);
}

TEST_F(ClientFilesTest, gives_nothing_but_files_of_the_job_named) {
  EXPECT_EQ(code_of([&] { fetch(0, "c1", 1, secret_bytes); }), ExitCode::not_found);
  EXPECT_EQ(code_of([&] { fetch(0, "c1", 2); }), ExitCode::not_found);
  fetch(0);
  EXPECT_EQ(code_of([&] { fetch(0, "c1", 1, secret_bytes); }), ExitCode::not_found);
  EXPECT_EQ(code_of([&] { fetch(0, "c1", 2); }), ExitCode::not_found);
  EXPECT_EQ(code_of([&] { fetch(1); }), ExitCode::usage);
  EXPECT_THAT(carry_out_all(), SizeIs(1));
}

TEST_F(ClientFilesTest, says_that_a_result_is_gone_or_cut) {
  write_file_atomically(store_.path_of(mesh_.hash), "cut");
  fetch(0);
  const auto answers = carry_out_all();
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_TRUE(answers[0].envelope.file_chunk().missing());
}

TEST_F(ClientFilesTest, serves_few_clients_at_once_with_little_under_way_each) {
  for (const char* connection : {"c1", "c2", "c3"}) {
    for (std::uint64_t i = 0; i < 4; ++i) fetch(i * chunk_bytes, connection);
  }
  const std::vector<FileOrder> orders = clients_.take_orders(now_);
  EXPECT_THAT(orders, SizeIs(4));
  for (const FileOrder& order : orders) EXPECT_NE(order.connection, "c3");
  EXPECT_THAT(clients_.take_orders(now_), IsEmpty());
}

TEST_F(ClientFilesTest, a_surface_goes_on_behind_what_is_there_and_is_published_when_whole) {
  offer(surface_bytes, sender("c1"));
  EXPECT_TRUE(stored().resend());
  EXPECT_TRUE(send(surface_bytes, 0, sender("c1")));
  EXPECT_EQ(stored().bytes(), chunk_bytes);
  // The coordinator is another one, and so is the connection.
  clients_ = ClientFiles();
  clients_.remember(begun_surfaces(store_), now_);
  EXPECT_FALSE(send(surface_bytes, chunk_bytes, sender("c2")));
  offer(surface_bytes, sender("c2"));
  EXPECT_EQ(stored().bytes(), chunk_bytes);
  EXPECT_TRUE(send(surface_bytes, chunk_bytes, sender("c2")));
  EXPECT_FALSE(stored().whole());
  EXPECT_TRUE(send(surface_bytes, 2 * chunk_bytes, sender("c2")));
  EXPECT_TRUE(stored().whole());
  EXPECT_EQ(store_.read(hash128(surface_bytes).hex(), surface_bytes.size()), surface_bytes);
  EXPECT_THAT(begun_surfaces(store_), IsEmpty());
}

TEST_F(ClientFilesTest, a_client_cannot_spoil_the_surface_of_another) {
  offer(surface_bytes, sender("c1", "anna"));
  carry_out_all();
  offer(surface_bytes, sender("c2", "bert"));
  carry_out_all();
  const std::string wrong(chunk_bytes, 'x');
  wire::FileChunk message;
  message.set_hash(hash128(surface_bytes).hex());
  fill_chunk(message, wrong);
  EXPECT_TRUE(clients_.append(sender("c2", "bert"), message, now_));
  EXPECT_FALSE(clients_.append(sender("c2", "anna"), message, now_));
  EXPECT_EQ(stored().bytes(), chunk_bytes);
  for (std::uint64_t offset = 0; offset < surface_bytes.size(); offset += chunk_bytes) {
    EXPECT_TRUE(send(surface_bytes, offset, sender("c1", "anna")));
    carry_out_all();
  }
  EXPECT_EQ(store_.read(hash128(surface_bytes).hex(), surface_bytes.size()), surface_bytes);
}

TEST_F(ClientFilesTest, a_surface_that_is_not_what_was_announced_begins_anew) {
  const std::string announced(10, 'a');
  offer(announced, sender("c1"));
  carry_out_all();
  wire::FileChunk message;
  message.set_hash(hash128(announced).hex());
  fill_chunk(message, std::string(10, 'b'));
  EXPECT_TRUE(clients_.append(sender("c1"), message, now_));
  const wire::FileStored answer = stored();
  EXPECT_TRUE(answer.resend());
  EXPECT_EQ(answer.bytes(), 0U);
  EXPECT_FALSE(store_.has(hash128(announced).hex(), announced.size()));
}

TEST_F(ClientFilesTest, large_and_many_surfaces_are_refused) {
  wire::OfferFile message;
  message.set_hash(hash128("large").hex());
  message.set_size(max_brought_bytes + 1);
  EXPECT_EQ(code_of([&] { clients_.offer(sender("c1"), message, now_); }), ExitCode::usage);
  message.set_hash("../../x");
  message.set_size(5);
  EXPECT_EQ(code_of([&] { clients_.offer(sender("c1"), message, now_); }), ExitCode::usage);
  const auto offers = [&](const char* bytes, const char* key) {
    return code_of([&] { offer(bytes, sender("c1", key)); });
  };
  EXPECT_EQ(offers("1", "anna"), ExitCode::ok);
  EXPECT_EQ(offers("2", "anna"), ExitCode::ok);
  EXPECT_EQ(offers("2", "anna"), ExitCode::ok);
  EXPECT_EQ(offers("3", "anna"), ExitCode::out_of_resources);
  EXPECT_EQ(offers("1", "bert"), ExitCode::ok);
  EXPECT_EQ(offers("1", "carl"), ExitCode::out_of_resources);
}

TEST_F(ClientFilesTest, a_surface_of_which_no_more_comes_is_removed) {
  offer(surface_bytes, sender("c1"));
  carry_out_all();
  EXPECT_TRUE(send(surface_bytes, 0, sender("c1")));
  carry_out_all();
  EXPECT_THAT(begun_surfaces(store_), SizeIs(1));
  now_.steady_ms += 60'001;
  carry_out_all();
  EXPECT_THAT(begun_surfaces(store_), IsEmpty());
  EXPECT_FALSE(send(surface_bytes, chunk_bytes, sender("c1")));
}

}  // namespace
}  // namespace tetfarm
