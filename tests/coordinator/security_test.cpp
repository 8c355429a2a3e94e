// Nobody gets in who should not: real sockets, real keys, a coordinator in a process of its own.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <map>
#include <random>

#include "base/clock.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/program_identity.h"
#include "base/program_version.h"
#include "proto/authorized_keys.h"
#include "store/artifact_store.h"
#include "tasks/failure_cause.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/child_coordinator.h"

namespace tetfarm {
namespace {

using test::ChildCoordinator;
using test::Dealer;
using test::patience_ms;
using testing::HasSubstr;

constexpr int deaf_ms = 300;

wire::Envelope message(void (*fill)(wire::Envelope&)) {
  wire::Envelope envelope;
  fill(envelope);
  return envelope;
}
wire::Envelope status_request() {
  return message([](wire::Envelope& e) { e.mutable_status_request(); });
}
wire::Envelope ready() {
  return message([](wire::Envelope& e) { e.mutable_ready(); });
}

/// A TCP connection without ZeroMQ.
class RawSocket {
 public:
  explicit RawSocket(const std::string& endpoint)
      : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    const int port = std::stoi(endpoint.substr(endpoint.rfind(':') + 1));
    address.sin_port = ::htons(static_cast<std::uint16_t>(port));
    EXPECT_EQ(::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~RawSocket() { ::close(descriptor_); }
  RawSocket(const RawSocket&) = delete;
  RawSocket& operator=(const RawSocket&) = delete;

  void send(const std::string& bytes) const {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count =
          ::send(descriptor_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;  // cut off
      sent += static_cast<std::size_t>(count);
    }
  }
  /// Whether the other side closes the connection.
  bool is_closed() const {
    std::string bytes(4096, '\0');
    pollfd waiting{descriptor_, POLLIN, 0};
    while (::poll(&waiting, 1, patience_ms) > 0) {
      if (::recv(descriptor_, bytes.data(), bytes.size(), 0) <= 0) return true;
    }
    return false;
  }

 private:
  int descriptor_;
};

class Security : public testing::Test {
 protected:
  Security() : store_(folder_.path() / "store") {
    coordinator_key_ = write_new_key(keys_folder(), "coordinator").public_key;
    anna_ = peer("anna", Role::submitter);
    worker_ = peer("node-1", Role::worker);
    viewer_ = peer("viewer", Role::viewer);
  }

  std::filesystem::path keys_folder() const { return folder_.path() / "keys"; }
  PeerKeys stranger() const { return {make_key_pair(), coordinator_key_}; }
  PeerKeys peer(const std::string& name, Role role) const {
    const PeerKeys keys = stranger();
    authorize(authorized_keys_path(keys_folder()), {keys.own.public_key, role, name});
    return keys;
  }
  void start(CoordinatorOptions options = {}) {
    options.endpoints = {"tcp://127.0.0.1:*"};
    options.keys = keys_folder();
    coordinator_.emplace(store_.folder(), options);
  }
  const std::string& endpoint() const { return coordinator_->endpoint(); }

  wire::Envelope hello() const {
    wire::Envelope envelope;
    envelope.mutable_hello()->set_host("here");
    envelope.mutable_hello()->set_nonce("one process");
    envelope.mutable_hello()->set_store_probe(store_.probe());
    return envelope;
  }
  wire::Envelope submission(const std::string& key) const {
    const StoredArtifact surface = store_.publish("solid wing");
    wire::Envelope envelope;
    wire::Submit& submit = *envelope.mutable_submit();
    submit.set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
    submit.set_key(key);
    submit.add_inputs()->set_name("input_surface");
    submit.mutable_inputs(0)->set_hash(surface.hash);
    submit.mutable_inputs(0)->set_size(surface.size);
    return envelope;
  }
  /// How many files and folders there are.
  std::ptrdiff_t artifacts() const {
    return std::distance(
        std::filesystem::recursive_directory_iterator(store_.folder() / "artifacts"), {});
  }
  /// A good client is served: the status it gets.
  wire::StatusReply status() const {
    Dealer client(endpoint(), viewer_);
    return client.ask(status_request()).status_reply();
  }
  /// Waits until so many are counted: handshakes end when they end.
  void expect_refused(const std::string& kind, std::uint64_t count) const {
    std::uint64_t refused = 0;
    for (int waited = 0; waited < patience_ms; waited += 20) {
      refused = status().refused().at(kind);
      if (refused >= count) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << kind << ": " << refused << " counted, not " << count;
  }

  TempFolder folder_;
  ArtifactStore store_;
  PublicKey coordinator_key_;
  PeerKeys anna_, worker_, viewer_;
  std::optional<ChildCoordinator> coordinator_;
};

TEST_F(Security, those_of_the_list_are_served_each_in_its_role) {
  start();
  Dealer anna(endpoint(), anna_);
  Dealer worker(endpoint(), worker_);
  EXPECT_TRUE(worker.ask(hello()).has_welcome());
  EXPECT_TRUE(anna.ask(submission("k")).has_submitted());
  EXPECT_TRUE(worker.ask(ready()).has_assign());
  const wire::StatusReply reply = status();
  EXPECT_EQ(reply.security(), "keys");
  EXPECT_EQ(reply.authorized_keys(), 3U);
  EXPECT_EQ(reply.dropped_messages(), 0U);
  EXPECT_EQ(reply.program_version(), program_version);
  EXPECT_EQ(reply.program(), program_identity());
  EXPECT_LT(std::abs(reply.wall_ms() - wall_ms()), 60'000);
}

TEST_F(Security, a_wrong_key_is_turned_away_and_told_so) {
  start();
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  secure(socket, stranger());
  HandshakeWatch watch(context, socket);
  socket.connect(endpoint());
  auto outcome = HandshakeWatch::Outcome::none;
  for (int waited = 0; waited < patience_ms && outcome == HandshakeWatch::Outcome::none;
       waited += 5) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    outcome = watch.take();
  }
  EXPECT_EQ(outcome, HandshakeWatch::Outcome::turned_away);
  Dealer other(endpoint(), stranger());
  other.send(status_request());
  EXPECT_TRUE(other.hears_nothing(deaf_ms));
  expect_refused("unknown_key", 2);
}

TEST_F(Security, no_key_is_turned_away) {
  start();
  Dealer plain(endpoint());
  plain.send(status_request());
  EXPECT_TRUE(plain.hears_nothing(deaf_ms));
  expect_refused("broken_handshake", 1);
}

TEST_F(Security, who_takes_another_for_the_coordinator_says_nothing_to_it) {
  start();
  PeerKeys deceived = anna_;
  deceived.coordinator = make_key_pair().public_key;
  Dealer client(endpoint(), deceived);
  client.send(status_request());
  EXPECT_TRUE(client.hears_nothing(deaf_ms));
  expect_refused("broken_handshake", 1);
}

TEST_F(Security, a_key_authorised_while_it_runs_is_let_in) {
  start();
  Dealer late(endpoint(), peer("late", Role::viewer));
  EXPECT_TRUE(late.ask(status_request()).has_status_reply());
}

TEST_F(Security, a_revoked_key_is_refused_at_the_next_message_of_an_open_connection) {
  start();
  Dealer anna(endpoint(), anna_);
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
  revoke(authorized_keys_path(keys_folder()), "anna");
  const wire::Envelope answer = anna.ask(submission("k"));
  EXPECT_THAT(answer.refused().reason(), HasSubstr("no longer authorised"));
  EXPECT_FALSE(answer.refused().hello_again());
  const wire::StatusReply reply = status();
  EXPECT_EQ(reply.jobs_size(), 0);
  EXPECT_EQ(reply.refused().at("revoked_key"), 1U);
  Dealer again(endpoint(), anna_);
  again.send(status_request());
  EXPECT_TRUE(again.hears_nothing(deaf_ms));
}

TEST_F(Security, a_revoked_worker_loses_its_task_to_another_at_once) {
  start();
  Dealer anna(endpoint(), anna_);
  anna.ask(submission("k"));
  Dealer bad(endpoint(), worker_);
  bad.ask(hello());
  const wire::Assign held = bad.ask(ready()).assign();
  const PeerKeys good_keys = peer("node-2", Role::worker);
  Dealer good(endpoint(), good_keys);
  EXPECT_TRUE(good.ask(hello()).has_welcome());
  good.send(ready());
  revoke(authorized_keys_path(keys_folder()), "node-1");
  EXPECT_TRUE(bad.receive().has_refused()) << "without a message of its own";
  EXPECT_EQ(good.receive().assign().task(), held.task()) << "long before the lease of a minute";
  wire::Envelope done;
  done.mutable_done()->set_task(held.task());
  done.mutable_done()->set_attempt(held.attempt());
  EXPECT_TRUE(bad.ask(done).has_refused());
}

TEST_F(Security, a_key_whose_role_changes_is_a_worker_no_longer) {
  start();
  Dealer worker(endpoint(), worker_);
  worker.ask(hello());
  const auto list = authorized_keys_path(keys_folder());
  revoke(list, "node-1");
  authorize(list, {worker_.own.public_key, Role::viewer, "node-1"});
  EXPECT_TRUE(worker.receive().has_refused());
  EXPECT_EQ(status().workers(), 0U);
}

TEST_F(Security, an_unreadable_list_lets_nobody_in) {
  start();
  Dealer anna(endpoint(), anna_);
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
  const auto list = authorized_keys_path(keys_folder());
  const std::string good = read_file(list);
  std::filesystem::permissions(list, std::filesystem::perms::all);
  EXPECT_TRUE(anna.ask(status_request()).has_refused());
  std::filesystem::remove(list);
  EXPECT_TRUE(anna.ask(status_request()).has_refused());
  write_file_atomically(list, good);
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
}

TEST_F(Security, another_roles_command_is_refused_and_changes_nothing) {
  start();
  std::map<std::string, PeerKeys> keys = {
      {"anna", anna_}, {"node-1", worker_}, {"viewer", viewer_}};
  const std::map<std::string, Role> roles = {
      {"anna", Role::submitter}, {"node-1", Role::worker}, {"viewer", Role::viewer}};
  std::vector<wire::Envelope> all = {hello(), ready(), submission("k"), status_request()};
  all.push_back(message([](wire::Envelope& e) { e.mutable_done(); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_failed(); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_heartbeat(); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_goodbye(); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_cancel()->set_job("job-1"); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_fetch_file()->set_task(1); }));
  all.push_back(message([](wire::Envelope& e) { e.mutable_fetch_file()->set_attempt(1); }));
  std::uint64_t refused = 0;
  for (const auto& [name, role] : roles) {
    Dealer dealer(endpoint(), keys.at(name));
    for (const wire::Envelope& envelope : all) {
      if (may_send(role, envelope)) continue;
      const wire::Envelope answer = dealer.ask(envelope);
      EXPECT_THAT(answer.refused().reason(),
                  HasSubstr(name + " may not send " + name_of(envelope.body_case())));
      ++refused;
    }
  }
  const wire::StatusReply reply = status();
  EXPECT_EQ(refused, 4U + 7U + 10U);
  EXPECT_EQ(reply.refused().at("wrong_role"), refused);
  EXPECT_EQ(reply.jobs_size(), 0);
  EXPECT_EQ(reply.workers(), 0U);
}

TEST_F(Security, a_submitter_fetches_no_file_that_is_not_a_result_of_the_job) {
  start();
  Dealer anna(endpoint(), anna_);
  const wire::Envelope submitted = submission("k");
  EXPECT_EQ(anna.ask(submitted).submitted().job(), "job-1");
  const auto refused_for = [&](std::uint64_t job, const std::string& hash) {
    wire::Envelope fetch;
    fetch.mutable_fetch_file()->set_task(job);
    fetch.mutable_fetch_file()->set_hash(hash);
    const wire::Refused refused = anna.ask(fetch).refused();
    EXPECT_EQ(refused.exit_code(), static_cast<int>(ExitCode::not_found));
    return refused.reason();
  };
  const std::string surface = submitted.submit().inputs(0).hash();
  EXPECT_EQ(refused_for(1, surface), "job-1 has no such file");
  EXPECT_EQ(refused_for(2, surface), "no job job-2");
  EXPECT_EQ(refused_for(0, surface), "no job job-0");
  EXPECT_EQ(refused_for(1, "../tetfarm.db"), "job-1 has no such file");
  expect_refused("no_result", 4);
}

TEST_F(Security, nobody_can_speak_under_the_name_of_anothers_connection) {
  start();
  Dealer worker(endpoint(), worker_, "its-name");
  EXPECT_TRUE(worker.ask(hello()).has_welcome());
  Dealer thief(endpoint(), peer("node-2", Role::worker), "its-name");
  thief.send(message([](wire::Envelope& e) { e.mutable_goodbye(); }));
  EXPECT_TRUE(thief.hears_nothing(deaf_ms));
  EXPECT_EQ(status().workers(), 1U);
  Dealer anna(endpoint(), anna_);
  anna.ask(submission("k"));
  EXPECT_TRUE(worker.ask(ready()).has_assign()) << "the answer goes to whom the name belongs";
}

TEST_F(Security, an_old_attempts_message_sent_again_is_stale) {
  start();
  Dealer anna(endpoint(), anna_);
  anna.ask(submission("k"));
  Dealer worker(endpoint(), worker_);
  worker.ask(hello());
  const wire::Assign first = worker.ask(ready()).assign();
  wire::Envelope failed;
  failed.mutable_failed()->set_task(first.task());
  failed.mutable_failed()->set_attempt(first.attempt());
  failed.mutable_failed()->set_cause(on_wire(FailureCause::killed));
  EXPECT_TRUE(worker.ask(failed).accepted().taken());
  const wire::Assign second = worker.ask(ready()).assign();
  EXPECT_EQ(second.task(), first.task());
  wire::Envelope replayed;
  replayed.mutable_done()->set_task(first.task());
  replayed.mutable_done()->set_attempt(first.attempt());
  EXPECT_FALSE(worker.ask(replayed).accepted().taken());
  const wire::StatusReply reply = status();
  EXPECT_EQ(reply.refused().at("stale"), 1U);
  EXPECT_EQ(reply.jobs(0).tasks_done(), 0U);
}

TEST_F(Security, who_knows_the_nonce_of_another_key_gets_nothing_of_its_attempt) {
  start();
  Dealer anna(endpoint(), anna_);
  anna.ask(submission("k"));
  Dealer rightful(endpoint(), worker_);
  rightful.ask(hello());
  const wire::Assign held = rightful.ask(ready()).assign();
  Dealer thief(endpoint(), peer("node-2", Role::worker));
  wire::Envelope claim = hello();
  claim.mutable_hello()->set_running_task(held.task());
  claim.mutable_hello()->set_running_attempt(held.attempt());
  const wire::Envelope welcome = thief.ask(claim);
  ASSERT_TRUE(welcome.has_welcome());
  EXPECT_FALSE(welcome.welcome().keep_running());
  wire::Envelope failed;
  failed.mutable_failed()->set_task(held.task());
  failed.mutable_failed()->set_attempt(held.attempt());
  EXPECT_FALSE(thief.ask(failed).accepted().taken());
  EXPECT_EQ(rightful.ask(ready()).assign().attempt(), held.attempt()) << "it still holds it";
  Dealer again(endpoint(), worker_);
  EXPECT_TRUE(again.ask(claim).welcome().keep_running()) << "the same process, connected anew";
}

TEST_F(Security, the_database_is_for_its_owner_and_knows_no_nonce) {
  start();
  Dealer anna(endpoint(), anna_);
  anna.ask(submission("k"));
  Dealer worker(endpoint(), worker_);
  wire::Envelope greeting = hello();
  greeting.mutable_hello()->set_nonce("a nonce that nobody else may know");
  worker.ask(greeting);
  ASSERT_TRUE(worker.ask(ready()).has_assign());
  for (const char* part : {"", "-wal", "-shm"}) {
    const std::filesystem::path file = store_.folder() / (std::string("tetfarm.db") + part);
    struct stat about {};
    ASSERT_EQ(::stat(file.c_str(), &about), 0) << file;
    EXPECT_EQ(about.st_mode & 07777U, 0600U) << file;
    EXPECT_THAT(read_file(file), testing::Not(HasSubstr("nobody else may know")));
  }
}

TEST_F(Security, a_submissions_key_stands_for_its_content_and_is_its_submitters_own) {
  start();
  Dealer anna(endpoint(), anna_);
  const std::string first = anna.ask(submission("k")).submitted().job();
  wire::Envelope other = submission("k");
  other.mutable_submit()->set_job_toml("[geometry]\nsurface = \"b.stl\"\n");
  EXPECT_THAT(anna.ask(other).refused().reason(), HasSubstr(first));
  EXPECT_EQ(status().jobs_size(), 1);
  EXPECT_TRUE(anna.ask(submission("k")).submitted().existed());
  Dealer ben(endpoint(), peer("ben", Role::submitter));
  const wire::Submitted of_ben = ben.ask(other).submitted();
  EXPECT_FALSE(of_ben.existed());
  EXPECT_NE(of_ben.job(), first);
  const wire::Submitted same_as_annas = ben.ask(submission("x")).submitted();
  EXPECT_FALSE(same_as_annas.existed());
  coordinator_->stop(SIGKILL);
  start();
  Dealer later(endpoint(), anna_);
  EXPECT_EQ(later.ask(submission("k")).submitted().job(), first);
  EXPECT_TRUE(later.ask(other).has_refused());
}

/// A listener that passes on what a client sends, and keeps it.
class Eavesdropper {
 public:
  explicit Eavesdropper(const std::string& endpoint)
      : onward_(endpoint), listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    endpoint_ = "tcp://127.0.0.1:" + std::to_string(::ntohs(address.sin_port));
    thread_ = std::thread([this] { pass_on(); });
  }
  ~Eavesdropper() {
    if (thread_.joinable()) thread_.join();
    ::close(listener_);
  }
  Eavesdropper(const Eavesdropper&) = delete;
  Eavesdropper& operator=(const Eavesdropper&) = delete;

  const std::string& endpoint() const { return endpoint_; }
  /// What the client said; once it has hung up.
  std::string heard() {
    thread_.join();
    return heard_;
  }

 private:
  void pass_on() {
    const int client = ::accept(listener_, nullptr, nullptr);
    const int server = onward_socket();
    std::array<pollfd, 2> both = {{{client, POLLIN, 0}, {server, POLLIN, 0}}};
    std::string bytes(65536, '\0');
    while (::poll(both.data(), both.size(), patience_ms) > 0) {
      const bool from_client = both[0].revents != 0;
      const ssize_t count = ::recv(from_client ? client : server, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      const auto size = static_cast<std::size_t>(count);
      if (from_client) heard_.append(bytes, 0, size);
      ::send(from_client ? server : client, bytes.data(), size, MSG_NOSIGNAL);
    }
    ::close(client);
    ::close(server);
  }
  int onward_socket() const {
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    address.sin_port =
        ::htons(static_cast<std::uint16_t>(std::stoi(onward_.substr(onward_.rfind(':') + 1))));
    ::connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address);
    return server;
  }

  std::string onward_;
  int listener_;
  std::string endpoint_;
  std::string heard_;
  std::thread thread_;
};

TEST_F(Security, a_recorded_conversation_is_unreadable_and_worth_nothing_when_sent_again) {
  start();
  std::string heard;
  {
    Eavesdropper eve(endpoint());
    {
      Dealer anna(eve.endpoint(), anna_);
      EXPECT_TRUE(anna.ask(submission("a secret name")).has_submitted());
    }
    heard = eve.heard();
  }
  EXPECT_GT(heard.size(), 400U);
  EXPECT_THAT(heard, testing::Not(HasSubstr("a secret name")));
  const wire::StatusReply before = status();
  RawSocket replay(endpoint());
  replay.send(heard);
  EXPECT_TRUE(replay.is_closed());
  expect_refused("broken_handshake", before.refused().at("broken_handshake") + 1);
  EXPECT_EQ(status().jobs_size(), 1);
}

TEST_F(Security, garbage_without_a_handshake_is_counted_and_does_no_harm) {
  start();
  std::mt19937 random(11);
  std::vector<std::string> rubbish = {"GET / HTTP/1.1\r\nHost: farm\r\n\r\n",
                                      std::string(100'000, '\0'), std::string(100, '\xff'),
                                      std::string("\xff\0\0\0\0\0\0\0\1\x7f\3\1CURVE", 17)};
  for (int i = 0; i < 40; ++i) {
    std::string bytes(1 + random() % 3000, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    rubbish.push_back(bytes);
  }
  for (const std::string& bytes : rubbish) RawSocket(endpoint()).send(bytes);
  expect_refused("broken_handshake", 1);
  Dealer worker(endpoint(), worker_);
  EXPECT_TRUE(worker.ask(hello()).has_welcome());
}

TEST_F(Security, who_says_nothing_is_cut_off) {
  CoordinatorOptions options;
  options.handshake_ms = 200;
  start(options);
  const RawSocket silent(endpoint());
  EXPECT_TRUE(silent.is_closed());
  expect_refused("broken_handshake", 1);
}

TEST_F(Security, garbage_of_one_with_a_key_is_counted_and_does_no_harm) {
  start();
  Dealer anna(endpoint(), anna_);
  std::mt19937 random(7);
  const std::string good = encode(submission("k"));
  for (int i = 0; i < 200; ++i) {
    std::string bytes = good;
    if (i % 2 == 0) bytes.resize(random() % 100);
    for (char& byte : bytes) byte = static_cast<char>(random());
    anna.send_bytes(bytes);
  }
  anna.send_bytes(good.substr(0, good.size() / 2));  // cut short
  wire::Envelope answer = anna.ask(status_request());
  while (answer.has_refused()) answer = anna.receive();
  EXPECT_EQ(answer.status_reply().jobs_size(), 0);
  const auto& refused = answer.status_reply().refused();
  EXPECT_GE(refused.at("garbage") + refused.at("wrong_version") + refused.at("senseless"), 201U);
}

TEST_F(Security, a_frame_that_is_cut_short_does_no_harm) {
  coordinator_.emplace(store_.folder() / "plain", [] {
    CoordinatorOptions options;
    options.endpoints = {"tcp://127.0.0.1:*"};
    return options;
  }());
  // A handshake of ZMTP 3.0 without security as a DEALER, then a frame of 1000 bytes of which 9
  // come.
  std::string greeting("\xff\0\0\0\0\0\0\0\1\x7f\3\0NULL", 16);
  greeting.resize(64, '\0');
  const std::string body("\5READY\13Socket-Type\0\0\0\6DEALER", 28);
  RawSocket half(endpoint());
  half.send(greeting + '\4' + static_cast<char>(body.size()) + body);
  half.send(std::string("\2\0\0\0\0\0\0\3\xe8", 9) + "truncated");
  Dealer client(endpoint());
  EXPECT_TRUE(client.ask(status_request()).has_status_reply());
}

TEST_F(Security, messages_that_are_too_large_are_refused_or_cut_off) {
  start();
  Dealer anna(endpoint(), anna_);
  anna.send_bytes(std::string(max_message_size + 1, 'x'));
  EXPECT_THAT(anna.receive().refused().reason(), HasSubstr(std::to_string(max_message_size)));
  expect_refused("too_large", 1);
  Dealer large(endpoint(), anna_);
  large.send_bytes(std::string(4 * max_message_size, 'x'));
  EXPECT_TRUE(large.hears_nothing(deaf_ms));
  EXPECT_EQ(status().refused().at("too_large"), 1U) << "it never arrived";
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
}

TEST_F(Security, another_version_is_refused_and_counted) {
  start();
  Dealer anna(endpoint(), anna_);
  wire::Envelope future = status_request();
  future.set_version(protocol_version + 1);
  anna.send_bytes(future.SerializeAsString());
  EXPECT_THAT(anna.receive().refused().reason(), HasSubstr("version"));
  EXPECT_EQ(status().refused().at("wrong_version"), 1U);
}

TEST_F(Security, what_only_the_coordinator_says_is_senseless) {
  start();
  Dealer worker(endpoint(), worker_);
  worker.send(message([](wire::Envelope& e) { e.mutable_welcome(); }));
  worker.send(message([](wire::Envelope& e) { e.mutable_assign(); }));
  EXPECT_TRUE(worker.ask(hello()).has_welcome());
  EXPECT_EQ(status().refused().at("senseless"), 2U);
}

TEST_F(Security, there_are_no_more_connections_than_allowed) {
  CoordinatorOptions options;
  options.max_connections = 2;
  start(options);
  {
    Dealer first(endpoint(), anna_);
    EXPECT_TRUE(first.ask(status_request()).has_status_reply());
    Dealer second(endpoint(), viewer_);
    EXPECT_TRUE(second.ask(status_request()).has_status_reply());
    Dealer third(endpoint(), viewer_);
    third.send(status_request());
    EXPECT_TRUE(third.hears_nothing(deaf_ms));
    EXPECT_GE(second.ask(status_request()).status_reply().refused().at("too_many_connections"), 1U);
  }
  EXPECT_GE(status().refused().at("too_many_connections"), 1U) << "there is room again";
}

TEST_F(Security, there_are_no_more_workers_than_allowed) {
  CoordinatorOptions options;
  options.max_workers = 1;
  start(options);
  Dealer first(endpoint(), worker_);
  EXPECT_TRUE(first.ask(hello()).has_welcome());
  Dealer second(endpoint(), worker_);
  EXPECT_THAT(second.ask(hello()).refused().reason(), HasSubstr("workers"));
  EXPECT_EQ(status().refused().at("too_many_workers"), 1U);
  first.send(message([](wire::Envelope& e) { e.mutable_goodbye(); }));
  wire::Envelope answer = second.ask(hello());
  for (int i = 0; i < 100 && !answer.has_welcome(); ++i) answer = second.ask(hello());
  EXPECT_TRUE(answer.has_welcome());
}

TEST_F(Security, surfaces_are_taken_out_of_the_allowed_folders_only) {
  std::filesystem::create_directories(folder_.path() / "allowed");
  for (const char* name : {"allowed/wing.stl", "wing.stl"}) {
    std::ofstream(folder_.path() / name) << "solid wing";
  }
  CoordinatorOptions options;
  options.allowed_roots = {folder_.path() / "allowed"};
  start(options);
  Dealer anna(endpoint(), anna_);
  wire::Envelope submit;
  submit.mutable_submit()->set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
  submit.mutable_submit()->set_surface_path((folder_.path() / "allowed/wing.stl").string());
  const wire::Envelope first = anna.ask(submit);
  ASSERT_TRUE(first.has_submitted()) << first.refused().reason();
  EXPECT_TRUE(anna.ask(submit).submitted().existed()) << "the same job again";
  submit.mutable_submit()->set_surface_path((folder_.path() / "wing.stl").string());
  const wire::Envelope refusal = anna.ask(submit);
  EXPECT_THAT(refusal.refused().reason(), HasSubstr((folder_.path() / "wing.stl").string()));
  EXPECT_THAT(refusal.refused().reason(), HasSubstr((folder_.path() / "allowed").string()));
  EXPECT_EQ(status().refused().at("outside_roots"), 1U);
}

TEST_F(Security, no_path_leads_to_the_coordinators_own_files) {
  CoordinatorOptions options;
  options.allowed_roots = {folder_.path()};  // the store and its keys lie in it
  start(options);
  const std::filesystem::path key = secret_key_path(keys_folder(), "coordinator");
  std::filesystem::create_hard_link(key, folder_.path() / "wing.stl");
  std::filesystem::create_symlink(key, folder_.path() / "link.stl");
  const std::string held = std::to_string(::open(key.c_str(), O_RDONLY | O_CLOEXEC));
  const std::string store = store_.folder().string();
  const auto before = artifacts();
  Dealer anna(endpoint(), anna_);
  for (const std::string& path :
       {key.string(), store + "/tetfarm.db", store + "/tetfarm.db-wal", store + "/coordinator.log",
        store + "/store_id", folder_.path().string() + "/wing.stl",
        folder_.path().string() + "/link.stl",
        "/proc/" + std::to_string(::getpid()) + "/fd/" + held, key.string() + '\0' + "/wing.stl"}) {
    wire::Envelope submit;
    submit.mutable_submit()->set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
    submit.mutable_submit()->set_surface_path(path);
    EXPECT_EQ(anna.ask(submit).refused().exit_code(), 2) << path;
  }
  EXPECT_EQ(artifacts(), before);
  EXPECT_EQ(status().jobs_size(), 0);
}

class Start : public Security {
 protected:
  CoordinatorOptions options() const {
    CoordinatorOptions options;
    options.store = store_.folder();
    options.keys = keys_folder();
    options.endpoints = {"tcp://127.0.0.1:*"};
    options.handle_signals = false;
    return options;
  }
};

TEST_F(Start, is_refused_with_a_coordinators_key_that_others_may_read) {
  std::filesystem::permissions(secret_key_path(keys_folder(), "coordinator"),
                               static_cast<std::filesystem::perms>(0644));
  EXPECT_THROW(run_coordinator(options()), UsageError);
}

TEST_F(Start, is_refused_with_a_list_that_others_may_write) {
  std::filesystem::permissions(authorized_keys_path(keys_folder()),
                               static_cast<std::filesystem::perms>(0666));
  EXPECT_THROW(run_coordinator(options()), UsageError);
}

TEST_F(Start, is_refused_when_the_folder_of_keys_has_none) {
  CoordinatorOptions wrong = options();
  wrong.keys = folder_.path() / "none";
  EXPECT_THROW(run_coordinator(wrong), UsageError);
}

TEST_F(Start, is_refused_with_the_database_of_another_store) {
  CoordinatorOptions wrong = options();
  wrong.database = folder_.path() / "database";
  std::filesystem::create_directories(wrong.database);
  std::ofstream(wrong.database / "store_id") << "other";
  EXPECT_THROW(run_coordinator(wrong), UsageError);
}

TEST_F(Start, insecure_is_plain_in_spite_of_keys_and_says_so) {
  CoordinatorOptions open = options();
  open.insecure = true;
  open.endpoints = {"tcp://0.0.0.0:*"};
  coordinator_.emplace(store_.folder(), open);
  const std::string port = endpoint().substr(endpoint().rfind(':'));
  Dealer client("tcp://127.0.0.1" + port);
  EXPECT_EQ(client.ask(status_request()).status_reply().security(), "insecure");
  EXPECT_THAT(read_file(store_.folder() / "coordinator.log"), HasSubstr("INSECURE"));
}

}  // namespace
}  // namespace tetfarm
