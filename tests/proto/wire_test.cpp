#include "proto/wire.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"

namespace tetfarm {
namespace {

wire::Envelope done_message() {
  wire::Envelope envelope;
  envelope.mutable_done()->set_task(7);
  (*envelope.mutable_done()->mutable_numbers())["tets"] = 12.5;
  wire::Artifact& output = *envelope.mutable_done()->add_outputs();
  output.set_name("mesh");
  output.set_hash(std::string(32, 'a'));
  return envelope;
}

TEST(Wire, what_is_encoded_is_read_back) {
  const Decoded decoded = decode(encode(done_message()));
  ASSERT_EQ(decoded.state, WireState::good);
  EXPECT_EQ(decoded.envelope.version(), protocol_version);
  EXPECT_EQ(decoded.envelope.done().task(), 7U);
  EXPECT_EQ(decoded.envelope.done().numbers().at("tets"), 12.5);
}

TEST(Wire, another_version_is_told_from_garbage) {
  wire::Envelope envelope = done_message();
  envelope.set_version(protocol_version + 1);
  const Decoded decoded = decode(envelope.SerializeAsString());
  EXPECT_EQ(decoded.state, WireState::wrong_version);
  EXPECT_EQ(decoded.envelope.version(), protocol_version + 1);
}

TEST(Wire, an_empty_message_and_an_unknown_kind_have_no_body) {
  EXPECT_EQ(decode("").state, WireState::wrong_version);
  EXPECT_EQ(decode(encode({})).state, WireState::no_body);
  EXPECT_EQ(decode(encode({}) + std::string("\xfa\x3e\x00", 3)).state, WireState::no_body);
}

TEST(Wire, text_that_is_not_utf8_arrives) {
  wire::Envelope envelope;
  envelope.mutable_failed()->set_message("cannot read caf\xe9.stl");
  const Decoded decoded = decode(encode(envelope));
  ASSERT_EQ(decoded.state, WireState::good);
  EXPECT_EQ(decoded.envelope.failed().message(), "cannot read caf\xe9.stl");
}

TEST(Wire, the_size_is_limited_both_ways) {
  EXPECT_EQ(decode(std::string(max_message_size + 1, '\0')).state, WireState::too_large);
  wire::Envelope large;
  large.mutable_submit()->set_job_toml(std::string(max_message_size, 'x'));
  EXPECT_THROW(encode(large), Error);
}

TEST(Wire, no_bytes_make_it_throw) {
  std::mt19937 random(20061);
  const std::string good = encode(done_message());
  int readable = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = good;
    if (i % 3 == 0) {
      bytes.resize(random() % 200);
      for (char& byte : bytes) byte = static_cast<char>(random());
    } else {
      for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      if (i % 3 == 2) bytes.resize(random() % bytes.size());
    }
    const Decoded decoded = decode(bytes);
    EXPECT_NE(std::string(name_of(decoded.state)), "unknown");
    if (decoded.state == WireState::good) ++readable;
  }
  EXPECT_GT(readable, 0);
}

TEST(Wire, a_message_may_be_as_large_as_the_limit) {
  wire::Envelope large = done_message();
  const std::size_t size = encode(large).size();
  // A text of so many bytes has a length of four bytes before it and a tag of two.
  large.mutable_done()->set_log(std::string(max_message_size - size - 4 - 2 - 6, 'x'));
  std::size_t grown = encode(large).size();
  ASSERT_LE(grown, max_message_size);
  large.mutable_done()->mutable_log()->append(max_message_size - grown, 'x');
  EXPECT_EQ(encode(large).size(), max_message_size);
  EXPECT_EQ(decode(encode(large)).state, WireState::good);
  large.mutable_done()->mutable_log()->append(1, 'x');
  try {
    encode(large);
    ADD_FAILURE() << "it is too large";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a message of 16777217 bytes exceeds the limit of 16777216");
  }
  EXPECT_EQ(decode(std::string(max_message_size, '\xff')).state, WireState::garbage);
}

TEST(Wire, states_have_names) {
  EXPECT_STREQ(name_of(WireState::good), "good");
  EXPECT_STREQ(name_of(WireState::wrong_version), "wrong version");
  EXPECT_STREQ(name_of(WireState::no_body), "no body");
  EXPECT_STREQ(name_of(WireState::too_large), "too large");
  EXPECT_STREQ(name_of(WireState::garbage), "garbage");
}

TEST(Wire, garbage_leaves_nothing_of_what_could_be_read) {
  const Decoded decoded = decode(encode(done_message()) + "\xff");
  EXPECT_EQ(decoded.state, WireState::garbage);
  EXPECT_EQ(decoded.envelope.ByteSizeLong(), 0U);
}

}  // namespace
}  // namespace tetfarm
