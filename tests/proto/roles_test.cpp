#include "proto/roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace tetfarm {
namespace {

using testing::UnorderedElementsAre;

std::set<std::string> sendable(Role role) {
  std::set<std::string> names;
  const auto* body = wire::Envelope::descriptor()->FindOneofByName("body");
  for (int i = 0; i < body->field_count(); ++i) {
    const auto kind = static_cast<wire::Envelope::BodyCase>(body->field(i)->number());
    if (may_send(role, kind)) names.insert(name_of(kind));
  }
  return names;
}

TEST(Roles, each_may_send_what_is_its_business_and_nothing_else) {
  EXPECT_THAT(sendable(Role::worker),
              UnorderedElementsAre("hello", "ready", "done", "failed", "heartbeat", "goodbye",
                                   "fetch_file", "offer_file", "file_chunk"));
  EXPECT_THAT(
      sendable(Role::submitter),
      UnorderedElementsAre("submit", "cancel", "set_priority", "retry", "drain_workers",
                           "status_request", "query", "fetch_file", "offer_file", "file_chunk"));
  EXPECT_THAT(sendable(Role::viewer), UnorderedElementsAre("status_request", "query"));
}

TEST(Roles, files_of_an_attempt_are_for_workers_and_those_of_none_for_submitters) {
  wire::Envelope fetch;
  wire::Envelope offer;
  wire::Envelope chunk;
  fetch.mutable_fetch_file()->set_task(1);
  offer.mutable_offer_file();
  chunk.mutable_file_chunk();
  for (const wire::Envelope* message : {&fetch, &offer, &chunk}) {
    EXPECT_TRUE(is_of_client(*message));
    EXPECT_FALSE(may_send(Role::worker, *message));
    EXPECT_TRUE(may_send(Role::submitter, *message));
    EXPECT_FALSE(may_send(Role::viewer, *message));
  }
  fetch.mutable_fetch_file()->set_attempt(7);
  offer.mutable_offer_file()->set_attempt(7);
  chunk.mutable_file_chunk()->set_attempt(7);
  for (const wire::Envelope* message : {&fetch, &offer, &chunk}) {
    EXPECT_FALSE(is_of_client(*message));
    EXPECT_TRUE(may_send(Role::worker, *message));
    EXPECT_FALSE(may_send(Role::submitter, *message));
    EXPECT_FALSE(may_send(Role::viewer, *message));
  }
}

// A new kind of message has to be put into the table, or here.
TEST(Roles, every_message_of_the_protocol_is_somebodys) {
  const std::set<std::string> from_the_coordinator = {
      "welcome",      "refused",   "assign",  "accepted", "drain",       "file_stored", "submitted",
      "status_reply", "cancelled", "retried", "draining", "query_reply", "priority_set"};
  const auto* body = wire::Envelope::descriptor()->FindOneofByName("body");
  for (int i = 0; i < body->field_count(); ++i) {
    const auto kind = static_cast<wire::Envelope::BodyCase>(body->field(i)->number());
    EXPECT_NE(is_for_the_coordinator(kind), from_the_coordinator.contains(name_of(kind)))
        << name_of(kind);
  }
  EXPECT_FALSE(is_for_the_coordinator(wire::Envelope::BODY_NOT_SET));
}

TEST(Roles, have_names) {
  for (const Role role : all_roles) EXPECT_EQ(role_of_name(name_of(role)), role);
  EXPECT_FALSE(role_of_name("root"));
}

TEST(Roles, have_the_names_that_lists_of_keys_use) {
  EXPECT_STREQ(name_of(Role::worker), "worker");
  EXPECT_STREQ(name_of(Role::submitter), "submitter");
  EXPECT_STREQ(name_of(Role::viewer), "viewer");
  EXPECT_FALSE(role_of_name(""));
  EXPECT_FALSE(role_of_name("Worker"));
  EXPECT_EQ(name_of(wire::Envelope::BODY_NOT_SET), "nothing");
  EXPECT_EQ(name_of(wire::Envelope::kDrainWorkers), "drain_workers");
}

TEST(Roles, other_messages_are_of_no_client_whatever_they_hold) {
  wire::Envelope envelope;
  EXPECT_FALSE(is_of_client(envelope));
  envelope.mutable_submit();
  EXPECT_FALSE(is_of_client(envelope));
  EXPECT_TRUE(may_send(Role::submitter, envelope));
  EXPECT_FALSE(may_send(Role::worker, envelope));
}

}  // namespace
}  // namespace tetfarm
