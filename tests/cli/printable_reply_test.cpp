#include "cli/printable_reply.h"

#include <gtest/gtest.h>

#include "proto/messages.pb.h"

namespace tetfarm {
namespace {

TEST(PrintableReply, has_no_control_characters_in_fields_lists_maps_and_messages_below) {
  wire::QueryReply said;
  said.set_trouble("full\n");
  wire::JobStatus& job = *said.add_jobs();
  job.set_name("a\x1b");
  (*job.mutable_texts())["key\n"] = "text\t";
  said.add_tasks()->set_message("one\r");
  said.add_tasks()->set_message("two\n");
  wire::Explanation& explanation = *said.mutable_explanation();
  explanation.add_reasons("first\n");
  explanation.add_reasons("second\n");
  explanation.mutable_task()->set_host("host\xff");
  const wire::QueryReply shown = printable_reply(said);
  EXPECT_EQ(shown.trouble(), "full\\n");
  EXPECT_EQ(shown.jobs(0).name(), "a\\u001b");
  ASSERT_TRUE(shown.jobs(0).texts().contains("key\\n"));
  EXPECT_EQ(shown.jobs(0).texts().at("key\\n"), "text\\t");
  EXPECT_EQ(shown.tasks(0).message(), "one\\r");
  EXPECT_EQ(shown.tasks(1).message(), "two\\n");
  EXPECT_EQ(shown.explanation().reasons(0), "first\\n");
  EXPECT_EQ(shown.explanation().reasons(1), "second\\n");
  EXPECT_EQ(shown.explanation().task().host(), "host\\xff");
}

TEST(PrintableReply, keeps_the_lines_of_logs_alone) {
  wire::AttemptLine attempt;
  attempt.set_log("one\n\ttwo\x1b\n");
  attempt.set_message("one\ntwo");
  make_printable(attempt);
  EXPECT_EQ(attempt.log(), "one\n\ttwo\\u001b\n");
  EXPECT_EQ(attempt.message(), "one\\ntwo");
}

TEST(PrintableReply, leaves_numbers_as_they_are) {
  wire::TaskLine task;
  task.set_task(7);
  task.set_seconds(2.5);
  make_printable(task);
  EXPECT_EQ(task.task(), 7U);
  EXPECT_EQ(task.seconds(), 2.5);
}

}  // namespace
}  // namespace tetfarm
