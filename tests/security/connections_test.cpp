// Who has no key, the wrong one, or no manners: nothing gets past the handshake, and others are
// served all the while.
#include <random>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

using test::deaf_ms;
using test::RawConnection;
using test::RawPeer;
using test::status_request;
using ::testing::HasSubstr;
using ::testing::Not;

class Connections : public test::FarmUnderAttack {
 protected:
  static RawPeer with(const std::optional<PeerKeys>& keys, zmq::socket_type type) {
    RawPeer::Manner manner;
    manner.type = type;
    return {farm().endpoint(), keys, manner};
  }
};

/// The greeting of ZMTP 3.0 for a mechanism.
std::string greeting(const std::string& mechanism, char major = '\3') {
  std::string text("\xff\0\0\0\0\0\0\0\1\x7f", 10);
  text += major;
  text += '\0';
  text += mechanism;
  text.resize(64, '\0');
  return text;
}

/// A command frame.
std::string command(const std::string& body) {
  return '\4' + std::string(1, static_cast<char>(body.size())) + body;
}

TEST_F(Connections, a_peer_without_a_key_is_turned_away) {
  RawPeer plain(farm().endpoint(), std::nullopt);
  plain.send(status_request());
  EXPECT_TRUE(plain.hears_nothing());
  expect_counted("broken_handshake", 1);
}

TEST_F(Connections, an_unknown_key_is_turned_away) {
  RawPeer stranger(farm().endpoint(), farm().stranger());
  stranger.send(status_request());
  EXPECT_TRUE(stranger.hears_nothing());
  expect_counted("unknown_key", 1);
}

TEST_F(Connections, a_guess_of_the_coordinators_key_gets_no_answer) {
  PeerKeys keys = farm().keys_of("anna");
  keys.coordinator = make_key_pair().public_key;
  RawPeer deceived(farm().endpoint(), keys);
  deceived.send(status_request());
  EXPECT_TRUE(deceived.hears_nothing());
  expect_counted("broken_handshake", 1);
}

TEST_F(Connections, anothers_public_key_without_its_secret_half_is_turned_away) {
  PeerKeys forged = farm().stranger();
  forged.own.public_key = farm().keys_of("anna").own.public_key;
  RawPeer thief(farm().endpoint(), forged);
  thief.send(status_request());
  EXPECT_TRUE(thief.hears_nothing());
  expect_counted("broken_handshake", 1);
}

TEST_F(Connections, a_name_and_a_password_are_no_key) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  socket.set(zmq::sockopt::plain_username, "anna");
  socket.set(zmq::sockopt::plain_password, "secret");
  socket.set(zmq::sockopt::linger, 0);
  socket.connect(farm().endpoint());
  socket.send(zmq::buffer(encode(status_request())), zmq::send_flags::dontwait);
  zmq::pollitem_t item{socket.handle(), 0, ZMQ_POLLIN, 0};
  EXPECT_EQ(zmq::poll(&item, 1, std::chrono::milliseconds(deaf_ms)), 0);
  expect_counted("broken_handshake", 1);
}

TEST_F(Connections, a_revoked_key_is_refused_at_its_next_message_and_kept_out_afterwards) {
  const PeerKeys keys = farm().newcomer("leaver", Role::submitter);
  RawPeer leaver(farm().endpoint(), keys);
  EXPECT_TRUE(leaver.ask(status_request()).has_status_reply());
  revoke(authorized_keys_path(farm().keys_folder()), "leaver");
  EXPECT_THAT(leaver.ask(test::submission(farm(), "too late")).refused().reason(),
              HasSubstr("no longer authorised"));
  RawPeer again(farm().endpoint(), keys);
  again.send(status_request());
  EXPECT_TRUE(again.hears_nothing());
  expect_counted("revoked_key", 1);
  expect_counted("unknown_key", 1);
}

TEST_F(Connections, a_recorded_conversation_is_unreadable_and_worth_nothing_when_sent_again) {
  const std::string said =
      test::recorded_conversation(farm().endpoint(), [&](const std::string& between) {
        RawPeer anna(between, farm().keys_of("anna"));
        EXPECT_TRUE(anna.ask(test::submission(farm(), "once only")).has_submitted());
      });
  EXPECT_GT(said.size(), 400U);
  EXPECT_THAT(said, Not(HasSubstr("once only")));
  const int jobs = farm().status().jobs_size();
  const RawConnection replay(farm().port());
  replay.send(said);
  EXPECT_TRUE(replay.is_cut_off());
  expect_counted("broken_handshake", 1);
  EXPECT_EQ(farm().status().jobs_size(), jobs);
}

TEST_F(Connections, bytes_that_are_not_zeromq_are_cut_off) {
  std::mt19937 random(3);
  std::string noise(3000, '\0');
  for (char& byte : noise) byte = static_cast<char>(random());
  const std::vector<std::string> all = {
      "GET / HTTP/1.1\r\nHost: farm\r\n\r\n",
      "SSH-2.0-OpenSSH_9.6\r\n",
      std::string("\x16\3\1\2\0\1\0\1\xfc\3\3", 11) + std::string(500, 'r'),
      std::string(100'000, '\0'),
      std::string(100'000, '\xff'),
      noise,
  };
  for (const std::string& bytes : all) {
    const RawConnection connection(farm().port());
    connection.send(bytes);
    connection.end_sending();
    EXPECT_TRUE(connection.is_cut_off()) << bytes.substr(0, 20);
  }
  expect_counted("broken_handshake",
                 1);  // of what is cut off at its first byte ZeroMQ says nothing
}

TEST_F(Connections, a_greeting_in_plain_or_of_another_version_is_cut_off) {
  const std::vector<std::string> all = {greeting("NULL"), greeting("PLAIN"), greeting("GSSAPI"),
                                        greeting("CURVE", '\1'), greeting(std::string(20, 'C'))};
  for (const std::string& bytes : all) {
    const RawConnection connection(farm().port());
    connection.send(bytes + command("\5READY"));
    connection.end_sending();
    EXPECT_TRUE(connection.is_cut_off()) << bytes.substr(12, 20);
  }
  expect_counted("broken_handshake", 3);
}

TEST_F(Connections, handshake_commands_out_of_order_or_of_a_false_length_are_cut_off) {
  const std::vector<std::string> commands = {
      command("\5READY"),
      command(std::string("\10INITIATE") + std::string(200, 'x')),
      command("\7MESSAGE" + std::string(100, 'x')),
      command("\5HELLO"),
      command("\5HELLO" + std::string(194, '\0')),
      std::string("\6\x7f\xff\xff\xff\xff\xff\xff\xff", 9),  // a command of 2^63 - 1 bytes
      std::string("\2\x7f\xff\xff\xff\xff\xff\xff\xff", 9),  // a message of as many
      std::string("\0\0", 2),
  };
  for (const std::string& bytes : commands) {
    const RawConnection connection(farm().port());
    connection.send(greeting("CURVE") + bytes);
    connection.end_sending();
    EXPECT_TRUE(connection.is_cut_off()) << bytes.substr(0, 12);
  }
  expect_counted("broken_handshake", commands.size() / 2);
}

TEST_F(Connections, a_handshake_cut_after_each_of_its_first_bytes_does_no_harm) {
  const std::string whole = greeting("CURVE") + command("\5HELLO" + std::string(194, 'k'));
  for (std::size_t length = 0; length < whole.size(); length += 3) {
    const RawConnection connection(farm().port());
    EXPECT_TRUE(connection.send(whole.substr(0, length)));
  }
  expect_counted("broken_handshake", 50);
}

TEST_F(Connections, three_hundred_silent_ones_keep_nobody_out) {
  std::vector<RawConnection> silent;
  for (int i = 0; i < 300; ++i) {
    silent.emplace_back(farm().port());
    EXPECT_TRUE(silent.back().is_open());
  }
  EXPECT_EQ(farm().ask({"status"}, "anna").code, 0);
  EXPECT_GE(farm().status().connections(), 300U);
}

TEST_F(Connections, forty_handshakes_with_unknown_keys_keep_nobody_out) {
  std::vector<std::unique_ptr<RawPeer>> strangers;
  const PeerKeys keys = farm().stranger();
  for (int i = 0; i < 40; ++i) {
    strangers.push_back(std::make_unique<RawPeer>(farm().endpoint(), keys));
    strangers.back()->send(status_request());
  }
  EXPECT_TRUE(strangers.front()->hears_nothing());
  EXPECT_EQ(farm().ask({"status"}, "anna").code, 0);
  expect_counted("unknown_key", 40);
}

TEST_F(Connections, sockets_of_other_kinds_do_nothing) {
  const int jobs = farm().status().jobs_size();
  const std::string submission = encode(test::submission(farm(), "of another kind"));
  for (const auto type : {zmq::socket_type::push, zmq::socket_type::pub, zmq::socket_type::pair}) {
    RawPeer other = with(farm().keys_of("anna"), type);
    other.send_bytes(submission);
    EXPECT_TRUE(other.hears_nothing());
  }
  RawPeer asker = with(farm().keys_of("anna"), zmq::socket_type::req);
  asker.send_bytes(submission);
  EXPECT_TRUE(asker.hears_nothing()) << "it puts an empty frame before each message";
  expect_counted("garbage", 1);
  EXPECT_EQ(farm().status().jobs_size(), jobs);
}

TEST_F(Connections, a_name_in_use_is_not_given_away) {
  RawPeer::Manner manner;
  manner.routing_id = "the name of a worker";
  RawPeer worker(farm().endpoint(), farm().keys_of("node"), manner);
  EXPECT_TRUE(worker.ask(test::hello_of("one")).has_welcome());
  RawPeer thief(farm().endpoint(), farm().keys_of("spare"), manner);
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  thief.send(goodbye);
  EXPECT_TRUE(thief.hears_nothing());
  EXPECT_GE(farm().status().workers(), 1U) << "the goodbye was not its own";
  EXPECT_TRUE(worker.ask(test::hello_of("one")).has_welcome());
  worker.send(goodbye);
}

TEST_F(Connections, who_does_not_read_answers_costs_a_bounded_amount_of_memory) {
  RawPeer deaf(farm().endpoint(), farm().keys_of("vera"));
  deaf.socket().set(zmq::sockopt::rcvhwm, 1);
  EXPECT_TRUE(deaf.ask(status_request()).has_status_reply());
  for (int i = 0; i < 3000 && deaf.send(status_request()); ++i) continue;
  EXPECT_EQ(farm().ask({"status"}, "anna").code, 0);
}

/// A farm of its own, with a small limit.
TEST(ConnectionLimit, those_above_it_are_turned_away_until_others_leave) {
  test::Farm farm({"--max-connections", "3"});
  {
    RawPeer first(farm.endpoint(), farm.keys_of("anna"));
    RawPeer second(farm.endpoint(), farm.keys_of("vera"));
    RawPeer third(farm.endpoint(), farm.keys_of("bert"));
    EXPECT_TRUE(first.ask(status_request()).has_status_reply());
    EXPECT_TRUE(second.ask(status_request()).has_status_reply());
    EXPECT_TRUE(third.ask(status_request()).has_status_reply());
    RawPeer fourth(farm.endpoint(), farm.keys_of("anna"));
    fourth.send(status_request());
    EXPECT_TRUE(fourth.hears_nothing());
    const auto refused = first.ask(status_request()).status_reply().refused();
    EXPECT_GE(refused.at("too_many_connections"), 1U);
  }
  EXPECT_EQ(farm.ask({"status"}, "anna").code, 0);
  EXPECT_TRUE(farm.coordinator().is_running());
}

}  // namespace
}  // namespace tetfarm
