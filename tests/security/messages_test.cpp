// Bytes that are no message of the protocol, or one that no program of ours would send, over a
// connection whose key is right.
#include <chrono>
#include <random>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

using test::RawPeer;
using test::status_request;
using ::testing::HasSubstr;

class Messages : public test::FarmUnderAttack {
 protected:
  /// The peer is still served. It asks until it is answered: of the answers to all that it said
  /// without reading, the coordinator keeps 256, and drops what comes after them.
  static wire::StatusReply expect_served(RawPeer& peer) {
    constexpr int silence_ms = 500;
    for (int waited = 0; waited < test::patience_ms; waited += silence_ms) {
      EXPECT_TRUE(peer.send(status_request()));
      while (const auto answer = peer.hear(silence_ms)) {
        if (answer->has_status_reply()) return answer->status_reply();
      }
    }
    ADD_FAILURE() << "the peer is not served any more";
    return {};
  }
  static std::uint64_t unreadable(const wire::StatusReply& reply) {
    std::uint64_t count = 0;
    for (const char* kind : {"garbage", "wrong_version", "senseless"}) {
      const auto found = reply.refused().find(kind);
      if (found != reply.refused().end()) count += found->second;
    }
    return count;
  }
};

TEST_F(Messages, random_bytes_are_counted_and_do_nothing) {
  RawPeer anna = peer("anna");
  const std::uint64_t before = unreadable(farm().status());
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    std::string bytes(1 + random() % 400, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    anna.send_bytes(bytes);
  }
  const wire::StatusReply reply = expect_served(anna);
  EXPECT_GE(unreadable(reply) - before, 300U);
  EXPECT_EQ(reply.jobs_size(), 0);
}

TEST_F(Messages, a_submission_cut_after_each_byte_makes_no_job) {
  RawPeer anna = peer("anna");
  wire::Envelope whole = test::submission(farm(), "cut");
  whole.mutable_submit()->set_surface_path("/nowhere");
  const std::string bytes = encode(whole);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    anna.send_bytes(bytes.substr(0, length));
  }
  EXPECT_EQ(expect_served(anna).jobs_size(), 0);
  EXPECT_GE(counted("garbage"), bytes.size() / 2);
}

TEST_F(Messages, a_message_with_each_bit_turned_over_ends_nothing) {
  RawPeer anna = peer("anna");
  wire::Envelope whole = test::submission(farm(), "turned");
  whole.mutable_submit()->set_surface_path("/nowhere");
  const std::string bytes = encode(whole);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string turned = bytes;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << (bit % 8)));
    anna.send_bytes(turned);
  }
  expect_served(anna);
}

TEST_F(Messages, an_empty_message_is_senseless) {
  RawPeer anna = peer("anna");
  anna.send_bytes("");
  wire::Envelope nothing;
  anna.send(nothing);
  expect_served(anna);
  EXPECT_EQ(counted("senseless") + counted("wrong_version"), 2U);
}

TEST_F(Messages, other_versions_are_refused_by_number) {
  const int jobs = farm().status().jobs_size();
  RawPeer anna = peer("anna");
  for (const std::uint32_t version : {0U, protocol_version + 1, 4'000'000'000U}) {
    wire::Envelope other = test::submission(farm(), "future");
    other.set_version(version);
    anna.send_bytes(other.SerializeAsString());
    const auto answer = anna.hear();
    ASSERT_TRUE(answer);
    EXPECT_THAT(answer->refused().reason(), HasSubstr(std::to_string(version)));
  }
  EXPECT_EQ(counted("wrong_version"), 3U);
  EXPECT_EQ(farm().status().jobs_size(), jobs);
}

TEST_F(Messages, more_frames_than_one_are_garbage) {
  RawPeer anna = peer("anna");
  const std::string good = encode(status_request());
  anna.send_frames({good, good});
  anna.send_frames({"", good});
  anna.send_frames(std::vector<std::string>(1000, "x"));
  expect_served(anna);
  EXPECT_EQ(counted("garbage"), 3U);
}

TEST_F(Messages, one_byte_more_than_allowed_is_refused) {
  RawPeer anna = peer("anna");
  anna.send_bytes(std::string(max_message_size + 1, 'x'));
  const auto answer = anna.hear();
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->refused().reason(), HasSubstr("bytes"));
  expect_counted("too_large", 1);
}

TEST_F(Messages, eighteen_mebibytes_never_arrive) {
  RawPeer anna = peer("anna");
  anna.send_bytes(std::string(std::size_t{18} << 20U, 'x'));
  EXPECT_TRUE(anna.hears_nothing());
  EXPECT_EQ(counted("too_large"), 0U);
}

TEST_F(Messages, fields_and_bodies_of_the_future_are_no_message) {
  static_assert(protocol_version == 2, "the bytes of this file say version 2");
  RawPeer anna = peer("anna");
  // Version 2, then field 99 with 5 bytes, then field 1000 with a number.
  anna.send_bytes(std::string("\x08\x02\x9a\x06\x05hello\xc0\x3e\x01", 13));
  expect_served(anna);
  EXPECT_EQ(counted("senseless"), 1U);
}

TEST_F(Messages, groups_ninety_thousand_deep_are_garbage) {
  RawPeer anna = peer("anna");
  std::string bytes("\x08\x02", 2);
  for (int i = 0; i < 90'000; ++i) bytes += std::string("\x9b\x06", 2);  // field 99, group begins
  anna.send_bytes(bytes);
  expect_served(anna);
  EXPECT_EQ(counted("garbage"), 1U);
}

TEST_F(Messages, two_bodies_in_one_count_as_the_last_and_only_by_its_role) {
  RawPeer vera = peer("vera");
  wire::Envelope cancel;
  cancel.mutable_cancel()->set_job("job-1");
  vera.send_bytes(encode(status_request()) + cancel.SerializeAsString());
  const auto answer = vera.hear();
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->refused().reason(), HasSubstr("may not send cancel"));
  EXPECT_EQ(counted("wrong_role"), 1U);
}

TEST_F(Messages, millions_of_empty_inputs_are_refused_in_bounded_memory) {
  RawPeer anna = peer("anna");
  // Envelope: version, then submit with 15 MiB of inputs of no bytes each.
  std::string inputs;
  for (std::size_t i = 0; i < (std::size_t{15} << 20U) / 2; ++i) inputs += std::string("\x12\0", 2);
  std::string bytes("\x08\x02\xf2\x01", 4);
  for (std::size_t rest = inputs.size(); rest > 0; rest >>= 7U) {
    bytes += static_cast<char>((rest & 0x7fU) | (rest > 0x7fU ? 0x80U : 0U));
  }
  anna.send_bytes(bytes + inputs);
  const auto answer = anna.hear();
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->has_refused());
}

TEST_F(Messages, a_flood_delays_nobody_for_long) {
  RawPeer flooder = peer("anna");
  const std::string garbage(100, '\xff');
  for (int i = 0; i < 20'000; ++i) ASSERT_TRUE(flooder.send_bytes(garbage));
  EXPECT_EQ(farm().ask({"status", "--timeout", "10"}, "bert").code, 0);
  expect_counted("garbage", 10'000);
}

TEST_F(Messages, names_of_jobs_that_cannot_be_are_not_found) {
  RawPeer anna = peer("anna");
  for (const std::string& name :
       {std::string(), std::string("job-0"), std::string("job--1"),
        std::string("job-99999999999999999999999"), std::string("job-18446744073709551615"),
        std::string("../../job-1"), std::string("job-1\n"), std::string(1'000'000, '9')}) {
    wire::Envelope cancel;
    cancel.mutable_cancel()->set_job(name);
    const wire::Envelope answer = anna.ask(cancel);
    EXPECT_FALSE(answer.cancelled().found()) << name.substr(0, 40);
    wire::Envelope retry;
    retry.mutable_retry()->set_job(name);
    retry.mutable_retry()->set_task(~std::uint64_t{0});
    EXPECT_EQ(anna.ask(retry).retried().count(), 0U) << name.substr(0, 40);
  }
}

TEST_F(Messages, questions_with_any_numbers_are_answered_page_by_page) {
  RawPeer vera = peer("vera");
  for (int subject = -1; subject <= 20; ++subject) {
    for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
      wire::Envelope query;
      query.mutable_query()->set_subject(static_cast<wire::Query::Subject>(subject));
      query.mutable_query()->set_task(number);
      query.mutable_query()->set_after(number);
      query.mutable_query()->set_limit(static_cast<std::uint32_t>(number));
      query.mutable_query()->set_newest(number == 1);
      query.mutable_query()->set_job(number == 0 ? "" : "job-1 or 1=1; drop table jobs");
      const wire::Envelope answer = vera.ask(query);
      EXPECT_TRUE(answer.has_query_reply() || answer.has_refused());
    }
  }
}

}  // namespace
}  // namespace tetfarm
