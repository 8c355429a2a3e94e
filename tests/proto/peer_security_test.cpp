#include "proto/peer_security.h"

#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

class PeerSecurity : public testing::Test {
 protected:
  std::string refusal_of(const KeyFiles& files, const std::filesystem::path& store) const {
    try {
      read_peer_keys(files, store);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  }
  std::string own() const { return secret_key_path(folder_.path(), "anna").string(); }

  TempFolder folder_;
  KeyPair anna_ = write_new_key(folder_.path(), "anna");
  KeyPair first_ = write_new_key(folder_.path(), "first");
  KeyPair second_ = write_new_key(folder_.path(), "second");
};

TEST_F(PeerSecurity, is_none_without_keys_and_refuses_half_of_them) {
  EXPECT_FALSE(read_peer_keys({}, ""));
  EXPECT_FALSE(read_peer_keys({}, folder_.path()));
  EXPECT_EQ(refusal_of({"", "a.pub"}, ""),
            "--coordinator-key: is of use only together with a key of your own: add --key");
  const std::string lacks =
      "--coordinator-key: is missing; --key needs the coordinator's public key too";
  EXPECT_EQ(refusal_of({own(), ""}, ""), lacks);
  EXPECT_EQ(refusal_of({own(), ""}, folder_.path()), lacks) << "the store has none";
}

TEST_F(PeerSecurity, takes_the_coordinators_key_that_is_named_or_else_that_of_the_store) {
  EXPECT_EQ(published_key_path("/store"), "/store/coordinator.pub");
  write_public_key(published_key_path(folder_.path()), first_.public_key);
  const auto found = read_peer_keys({own(), ""}, folder_.path());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->own.secret_bytes, anna_.secret_bytes);
  EXPECT_EQ(found->own.public_key, anna_.public_key);
  EXPECT_EQ(found->coordinator, first_.public_key);
  const std::string named = public_key_path(folder_.path(), "second").string();
  EXPECT_EQ(read_peer_keys({own(), named}, folder_.path())->coordinator, second_.public_key);
  EXPECT_EQ(read_peer_keys({own(), named}, "")->coordinator, second_.public_key);
}

TEST_F(PeerSecurity, makes_a_socket_speak_with_keys_when_there_are_some) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  secure(socket, std::nullopt);
  EXPECT_EQ(socket.get(zmq::sockopt::mechanism), ZMQ_NULL);
  secure(socket, PeerKeys{anna_, first_.public_key});
  EXPECT_EQ(socket.get(zmq::sockopt::mechanism), ZMQ_CURVE);
  std::array<unsigned char, 32> key{};
  std::size_t size = key.size();
  const auto read = [&](int option) {
    size = key.size();
    EXPECT_EQ(zmq_getsockopt(socket.handle(), option, key.data(), &size), 0);
    return std::string(key.begin(), key.end());
  };
  EXPECT_EQ(read(ZMQ_CURVE_SERVERKEY), first_.public_key.bytes);
  EXPECT_EQ(read(ZMQ_CURVE_PUBLICKEY), anna_.public_key.bytes);
  EXPECT_EQ(read(ZMQ_CURVE_SECRETKEY), anna_.secret_bytes);
}

TEST_F(PeerSecurity, explains_what_became_of_a_handshake_by_whether_there_is_a_key) {
  using Outcome = HandshakeWatch::Outcome;
  zmq::context_t context;
  zmq::socket_t plain(context, zmq::socket_type::dealer);
  zmq::socket_t encrypted(context, zmq::socket_type::dealer);
  secure(encrypted, PeerKeys{anna_, first_.public_key});
  HandshakeWatch of_plain(context, plain);
  const HandshakeWatch of_encrypted(context, encrypted);
  EXPECT_EQ(of_plain.take(), Outcome::none);
  EXPECT_EQ(of_plain.explanation_of(Outcome::none), "");
  EXPECT_EQ(of_plain.explanation_of(Outcome::broken),
            "the connection was cut off; perhaps this coordinator requires a key: --key");
  EXPECT_EQ(of_encrypted.explanation_of(Outcome::broken),
            "the connection was cut off: is --coordinator-key the key of this coordinator?");
  EXPECT_EQ(of_encrypted.explanation_of(Outcome::turned_away),
            "this coordinator has not authorised the key: `tetfarm keys authorize`");
  EXPECT_EQ(of_plain.explanation_of(Outcome::other_kind), "this coordinator requires a key: --key");
  EXPECT_EQ(of_encrypted.explanation_of(Outcome::other_kind),
            "this coordinator uses no keys: leave out --key");
}

}  // namespace
}  // namespace tetfarm
