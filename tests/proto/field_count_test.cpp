#include "proto/field_count.h"

#include <gtest/gtest.h>

#include <random>

#include "proto/wire.h"

namespace tetfarm {
namespace {

wire::Envelope submission_with(std::size_t inputs) {
  wire::Envelope envelope;
  for (std::size_t i = 0; i < inputs; ++i) envelope.mutable_submit()->add_inputs();
  return envelope;
}

TEST(FieldCount, counts_the_fields_of_parts) {
  EXPECT_FALSE(has_too_many_fields(encode(submission_with(max_fields - 2))))
      << "with the version and the submission itself";
  EXPECT_TRUE(has_too_many_fields(encode(submission_with(max_fields - 1))));
  EXPECT_TRUE(has_too_many_fields(encode(submission_with(2 * max_fields))));
}

TEST(FieldCount, counts_entries_of_maps_with_their_keys_and_values) {
  wire::Envelope envelope;
  auto& numbers = *envelope.mutable_done()->mutable_numbers();
  for (std::size_t i = 0; i < max_fields / 3 - 1; ++i) numbers[std::to_string(i)] = 1;
  EXPECT_FALSE(has_too_many_fields(encode(envelope)));
  for (std::size_t i = 0; i < max_fields / 3 + 1; ++i) numbers[std::to_string(i)] = 1;
  EXPECT_TRUE(has_too_many_fields(encode(envelope)));
}

TEST(FieldCount, counts_fields_that_nobody_knows) {
  std::string bytes;
  for (std::size_t i = 0; i <= max_fields; ++i) bytes += std::string("\x98\x06\x01", 3);
  EXPECT_TRUE(has_too_many_fields(bytes));
}

TEST(FieldCount, does_not_look_into_text) {
  wire::Envelope envelope;
  envelope.mutable_submit()->set_job_toml(std::string(4'000'000, '\x08'));
  EXPECT_FALSE(has_too_many_fields(encode(envelope)));
}

TEST(FieldCount, survives_any_bytes) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(random() % 300, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    EXPECT_FALSE(has_too_many_fields(bytes));
  }
  EXPECT_FALSE(has_too_many_fields(""));
  EXPECT_FALSE(has_too_many_fields(std::string("\xf2\x01\xff\xff\xff\xff\xff\xff\xff\xff", 10)));
}

TEST(FieldCount, counts_fields_of_every_kind_alike) {
  const std::string varint = std::string("\x98\x06\x01", 3);
  const std::string fixed64 = std::string("\x99\x06", 2) + std::string(8, '\x01');
  const std::string text = std::string("\x9a\x06\x02", 3) + "\x08\x08";
  const std::string fixed32 = std::string("\x9d\x06", 2) + std::string(4, '\x01');
  for (const std::string& field : {varint, fixed64, text, fixed32}) {
    std::string bytes;
    for (std::size_t i = 0; i < max_fields; ++i) bytes += field;
    EXPECT_FALSE(has_too_many_fields(bytes)) << field.size();
    EXPECT_TRUE(has_too_many_fields(bytes + field)) << field.size();
    EXPECT_TRUE(has_too_many_fields(bytes + varint)) << field.size();
  }
}

}  // namespace
}  // namespace tetfarm
