#include "proto/text_limits.h"

#include <gtest/gtest.h>

#include <set>

namespace tetfarm {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

/// The field that a line of the table names; nothing when there is none.
const FieldDescriptor* field_named(std::string_view name) {
  const std::size_t dot = name.find('.');
  const Descriptor* message =
      wire::Envelope::descriptor()->file()->FindMessageTypeByName(std::string(name.substr(0, dot)));
  if (message == nullptr) return nullptr;
  std::string field(name.substr(dot + 1));
  if (field.ends_with(".key")) field.resize(field.size() - 4);
  return message->FindFieldByName(field);
}

TEST(TextLimits, name_fields_that_there_are_once_each) {
  std::set<std::string_view> named;
  for (const TextLimit& limit : text_limits()) {
    const FieldDescriptor* field = field_named(limit.field);
    ASSERT_NE(field, nullptr) << limit.field;
    EXPECT_TRUE(field->is_map() || field->cpp_type() == FieldDescriptor::CPPTYPE_STRING)
        << limit.field;
    EXPECT_TRUE(named.insert(limit.field).second) << limit.field;
  }
  for (const CountLimit& limit : count_limits()) {
    const FieldDescriptor* field = field_named(limit.field);
    ASSERT_NE(field, nullptr) << limit.field;
    EXPECT_TRUE(field->is_repeated()) << limit.field;
  }
}

TEST(TextLimits, refuse_names_that_are_too_long) {
  wire::Envelope envelope;
  envelope.mutable_hello()->set_host(std::string(255, 'h'));
  EXPECT_EQ(apply_text_limits(envelope), "");
  envelope.mutable_hello()->set_host(std::string(256, 'h'));
  EXPECT_EQ(apply_text_limits(envelope), "Hello.host has 256 bytes, more than the 255 allowed");
  envelope.mutable_submit()->set_name(std::string(15'000'000, 'n'));
  EXPECT_EQ(apply_text_limits(envelope),
            "Submit.name has 15000000 bytes, more than the 255 allowed");
  envelope.mutable_submit()->set_name("wing");
  envelope.mutable_submit()->add_inputs()->set_name(std::string(301, 'n'));
  EXPECT_EQ(apply_text_limits(envelope), "Artifact.name has 301 bytes, more than the 300 allowed");
}

TEST(TextLimits, bound_what_the_table_does_not_name) {
  wire::Envelope envelope;
  envelope.mutable_cancel()->set_job(std::string(most_bytes_of_text + 1, 'j'));
  EXPECT_EQ(apply_text_limits(envelope), "Cancel.job has 256 bytes, more than the 255 allowed");
}

TEST(TextLimits, cut_what_only_tells_something) {
  wire::Envelope envelope;
  wire::Failed& failed = *envelope.mutable_failed();
  failed.set_message(std::string(4095, 'm') + "é and more");
  failed.set_log("the beginning" + std::string(8000, '.') + std::string(192, 'e'));
  EXPECT_EQ(apply_text_limits(envelope), "");
  EXPECT_EQ(failed.message(), std::string(4095, 'm')) << "not half a character";
  EXPECT_EQ(failed.log(), std::string(8000, '.') + std::string(192, 'e')) << "its end";
}

TEST(TextLimits, bound_maps_and_lists) {
  wire::Envelope envelope;
  wire::Done& done = *envelope.mutable_done();
  (*done.mutable_numbers())[std::string(256, 'k')] = 1;
  EXPECT_EQ(apply_text_limits(envelope),
            "Done.numbers.key has 256 bytes, more than the 255 allowed");
  done.mutable_numbers()->clear();
  (*done.mutable_texts())["order"] = std::string((8U << 20U) + 1, 'o');
  EXPECT_EQ(apply_text_limits(envelope),
            "Done.texts has 8388609 bytes, more than the 8388608 allowed");
  done.mutable_texts()->clear();
  for (int i = 0; i <= 1 << 16; ++i) (*done.mutable_numbers())[std::to_string(i)] = i;
  EXPECT_EQ(apply_text_limits(envelope),
            "Done.numbers has 65537 entries, more than the 65536 allowed");
  for (int i = 0; i <= 100; ++i) envelope.mutable_failed()->add_evidence();
  EXPECT_EQ(apply_text_limits(envelope),
            "Failed.evidence has 101 entries, more than the 100 allowed");
}

TEST(TextLimits, leave_alone_what_keeps_them) {
  wire::Envelope envelope;
  wire::Done& done = *envelope.mutable_done();
  done.add_outputs()->set_name("mesh");
  done.mutable_outputs(0)->set_hash(std::string(32, 'a'));
  (*done.mutable_numbers())["tets"] = 5;
  (*done.mutable_texts())["reason"] = "why";
  done.set_log("a\nb");
  const std::string before = envelope.SerializeAsString();
  EXPECT_EQ(apply_text_limits(envelope), "");
  EXPECT_EQ(envelope.SerializeAsString(), before);
}

/// What one side writes the other has to take: a limit that shrinks breaks farms.
TEST(TextLimits, are_those_that_both_sides_reckon_with) {
  std::string table;
  for (const TextLimit& limit : text_limits()) {
    table += std::string(limit.field) + " " + std::to_string(limit.most_bytes) +
             (limit.then == TooLong::refused        ? ""
              : limit.then == TooLong::cut_at_front ? " end"
                                                    : " cut") +
             "\n";
  }
  EXPECT_EQ(table,
            "Artifact.name 300\n"
            "Hello.program_version 64 cut\n"
            "Hello.host 255\n"
            "Hello.store_probe 64\n"
            "Hello.probe_text 256\n"
            "Hello.nonce 128\n"
            "Hello.tag 200\n"
            "Doing.stage 64 cut\n"
            "Done.numbers.key 255\n"
            "Done.texts.key 255\n"
            "Done.texts 8388608\n"
            "Done.log 8192 end\n"
            "Failed.message 4096 cut\n"
            "Failed.log 8192 end\n"
            "FileChunk.bytes 1048576\n"
            "Submit.job_toml 1048576\n"
            "Submit.name 255\n"
            "Submit.key 255\n"
            "Submit.surface_path 4096\n");
  std::string counts;
  for (const CountLimit& limit : count_limits()) {
    counts += std::string(limit.field) + " " + std::to_string(limit.most) + "\n";
  }
  EXPECT_EQ(counts,
            "Done.outputs 65536\n"
            "Done.numbers 65536\n"
            "Done.texts 65536\n"
            "Failed.evidence 100\n"
            "Failed.damaged_inputs 65536\n"
            "Submit.inputs 100\n"
            "Submit.after 100\n");
}

TEST(TextLimits, let_everything_be_as_large_as_it_may) {
  wire::Envelope envelope;
  wire::Failed& failed = *envelope.mutable_failed();
  failed.set_message(std::string(4096, 'm'));
  failed.set_log(std::string(8192, 'l'));
  for (int i = 0; i < 100; ++i) failed.add_evidence()->set_name(std::string(300, 'n'));
  for (int i = 0; i < 1001; ++i) failed.add_damaged_inputs(std::string(255, 'h'));
  const std::string before = envelope.SerializeAsString();
  EXPECT_EQ(apply_text_limits(envelope), "");
  EXPECT_EQ(envelope.SerializeAsString(), before);
  failed.add_damaged_inputs(std::string(256, 'h'));
  EXPECT_EQ(apply_text_limits(envelope),
            "Failed.damaged_inputs has 256 bytes, more than the 255 allowed");
}

TEST(TextLimits, reach_into_parts_and_bound_lists_that_the_table_does_not_name) {
  wire::Envelope envelope;
  envelope.mutable_heartbeat()->mutable_doing()->set_stage(std::string(100, 's'));
  EXPECT_EQ(apply_text_limits(envelope), "");
  EXPECT_EQ(envelope.heartbeat().doing().stage(), std::string(64, 's'));
  envelope.mutable_hello()->set_program_version(std::string(65, 'v'));
  EXPECT_EQ(apply_text_limits(envelope), "");
  EXPECT_EQ(envelope.hello().program_version(), std::string(64, 'v'));
  for (int i = 0; i < 1000; ++i) envelope.mutable_status_reply()->add_jobs();
  EXPECT_EQ(apply_text_limits(envelope), "");
  envelope.mutable_status_reply()->add_jobs();
  EXPECT_EQ(apply_text_limits(envelope),
            "StatusReply.jobs has 1001 entries, more than the 1000 allowed");
}

}  // namespace
}  // namespace tetfarm
