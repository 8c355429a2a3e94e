#include "coordinator/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "proto/wire.h"
#include "tests/coordinator/store_messages.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class RequestHandlerTest : public testing::Test, protected test::WithStore {
 protected:
  /// One of that key speaks on the connection "line".
  void hear(const std::string& key, const wire::Envelope& envelope) {
    handler_.handle({"line", key, Role::worker, "worker of " + key}, encode(envelope), state_,
                    now_);
    handler_.take_replies();
  }
  static wire::Envelope goodbye() {
    wire::Envelope envelope;
    envelope.mutable_goodbye();
    return envelope;
  }

  SurfaceRoots roots_{{}, {folder_.path(), {}, {}, {}}};
  Refusals refusals_;
  RequestHandler handler_{store_, roots_, {}, refusals_};
  Moment now_{1000, 1000};
  JobState state_{{}, {}, [](const ArtifactRef&) { return true; }, now_};
};

TEST_F(RequestHandlerTest, a_workers_connection_is_for_its_key_alone) {
  hear("its-key", hello());
  const WorkerId worker = handler_.worker_of("line");
  EXPECT_TRUE(state_.knows_worker(worker));
  for (const wire::Envelope& envelope : {goodbye(), hello()}) {
    hear("another-key", envelope);
    EXPECT_EQ(handler_.worker_of("line"), worker);
    EXPECT_TRUE(state_.knows_worker(worker));
  }
  EXPECT_EQ(refusals_.of(Refusal::foreign_connection), 2U);
  hear("its-key", goodbye());
  EXPECT_FALSE(state_.knows_worker(worker));
}

TEST_F(RequestHandlerTest, a_submission_brings_one_surface_and_nothing_else) {
  const auto refusal_of = [this](const wire::Envelope& envelope) {
    handler_.handle({"line", "anna's key", Role::submitter, "anna"}, encode(envelope), state_,
                    now_);
    const std::vector<Reply> replies = handler_.take_replies();
    EXPECT_THAT(replies, testing::SizeIs(1));
    return replies.at(0).envelope.refused().reason();
  };
  wire::Envelope two = submission("two");
  *two.mutable_submit()->add_inputs() = two.submit().inputs(0);
  EXPECT_THAT(refusal_of(two), HasSubstr("has the input 'input_surface'"));
  wire::Envelope besides = submission("besides");
  *besides.mutable_submit()->add_inputs() = besides.submit().inputs(0);
  besides.mutable_submit()->mutable_inputs(1)->set_name("spacing");
  EXPECT_THAT(refusal_of(besides), HasSubstr("has the input 'spacing'"));
  wire::Envelope both = submission("both");
  both.mutable_submit()->set_surface_path((folder_.path() / "wing.stl").string());
  EXPECT_THAT(refusal_of(both), HasSubstr("names two surfaces"));
  wire::Envelope none = submission("none");
  none.mutable_submit()->clear_inputs();
  EXPECT_THAT(refusal_of(none), HasSubstr("names no surface"));
  EXPECT_TRUE(state_.durable().jobs.empty());
}

/// Everything that one message brings, as text.
class Conversation : public testing::Test, protected test::WithStore {
 protected:
  static Sender sender(const std::string& connection, std::optional<Role> role,
                       const std::string& key = "key") {
    return {connection, key, role, "anna"};
  }
  std::vector<std::string> texts(const std::vector<Reply>& replies) const {
    std::vector<std::string> all;
    for (const Reply& reply : replies) {
      all.push_back(reply.connection + (reply.needs_commit ? " later: " : " now: ") +
                    reply.envelope.ShortDebugString());
    }
    return all;
  }
  std::vector<std::string> say_bytes(const Sender& sender, const std::string& bytes) {
    handler_.handle(sender, bytes, state_, now_);
    handler_.carry_out(state_, now_);
    return texts(handler_.take_replies());
  }
  std::vector<std::string> say(const Sender& sender, const wire::Envelope& envelope) {
    return say_bytes(sender, encode(envelope));
  }
  std::vector<std::string> say(const wire::Envelope& envelope) {
    return say(sender("line", Role::submitter), envelope);
  }
  static wire::Envelope cancel(const std::string& job) {
    wire::Envelope envelope;
    envelope.mutable_cancel()->set_job(job);
    return envelope;
  }
  static wire::Envelope ready() {
    wire::Envelope envelope;
    envelope.mutable_ready();
    return envelope;
  }
  static wire::Envelope beat(std::uint64_t task, std::uint64_t attempt) {
    wire::Envelope envelope;
    envelope.mutable_heartbeat()->set_task(task);
    envelope.mutable_heartbeat()->set_attempt(attempt);
    return envelope;
  }
  HandlerOptions options(bool may_replace_jobs = false) const {
    HandlerOptions options;
    options.heartbeat_ms = 700;
    options.lease_ms = 8000;
    options.max_workers = 1;
    options.may_replace_jobs = may_replace_jobs;
    return options;
  }

  SurfaceRoots roots_{{}, {folder_.path(), {}, {}, {}}};
  Refusals refusals_;
  RequestHandler handler_{store_, roots_, options(), refusals_};
  Moment now_{10'000, 10'000};
  JobState state_{{}, {}, [](const ArtifactRef&) { return true; }, now_};
};

using testing::ElementsAre;
using testing::IsEmpty;

TEST_F(Conversation, what_cannot_be_taken_is_refused_with_what_is_wrong_and_counted) {
  wire::Envelope version = cancel("job-1");
  version.set_version(1);
  EXPECT_THAT(say_bytes(sender("line", Role::submitter), version.SerializeAsString()),
              ElementsAre("line now: refused { reason: \"this coordinator speaks protocol version "
                          "2, not 1\" exit_code: 2 }"));
  EXPECT_EQ(refusals_.of(Refusal::wrong_version), 1U);
  EXPECT_THAT(say_bytes(sender("line", Role::submitter), std::string(max_message_size + 1, 'x')),
              ElementsAre("line now: refused { reason: \"a message may have at most 16777216 bytes "
                          "and 100000 fields\" exit_code: 2 }"));
  EXPECT_EQ(refusals_.of(Refusal::too_large), 1U);
  EXPECT_THAT(say_bytes(sender("line", Role::submitter), "\xff\xff"), IsEmpty());
  EXPECT_EQ(refusals_.of(Refusal::garbage), 1U);
  EXPECT_THAT(say_bytes(sender("line", Role::submitter), encode({})), IsEmpty());
  EXPECT_EQ(refusals_.of(Refusal::senseless), 1U);
  wire::Envelope welcome;
  welcome.mutable_welcome();
  EXPECT_THAT(say(welcome), IsEmpty());
  EXPECT_EQ(refusals_.of(Refusal::senseless), 2U);
  EXPECT_THAT(say(sender("line", Role::viewer), cancel("job-1")),
              ElementsAre("line now: refused { reason: \"viewer anna may not send cancel\" "
                          "exit_code: 1 }"));
  EXPECT_EQ(refusals_.of(Refusal::wrong_role), 1U);
  EXPECT_THAT(say(cancel(std::string(256, 'j'))),
              ElementsAre("line now: refused { reason: \"Cancel.job has 256 bytes, more than the "
                          "255 allowed\" exit_code: 2 }"));
  EXPECT_EQ(refusals_.of(Refusal::too_large), 2U);
  EXPECT_THAT(say(sender("line", std::nullopt), cancel("job-1")),
              ElementsAre("line now: refused { reason: \"this key is no longer authorised\" "
                          "exit_code: 1 }"));
  EXPECT_EQ(refusals_.of(Refusal::revoked_key), 1U);
  handler_.drop(sender("line", Role::worker), "3 frames", now_);
  EXPECT_EQ(refusals_.of(Refusal::garbage), 2U);
  EXPECT_EQ(refusals_.total(), 9U);
  EXPECT_THAT(refusals_.take_complaints(),
              testing::Contains("refused: garbage (2 so far): worker anna: 3 frames"));
}

TEST_F(Conversation, senders_are_called_by_role_and_name_or_by_their_key) {
  EXPECT_EQ(who(sender("line", Role::worker)), "worker anna");
  EXPECT_EQ(who(sender("line", std::nullopt, "0123")), "key 0123");
  EXPECT_EQ(who(sender("line", Role::worker, "")), "someone without a key");
}

TEST_F(Conversation, clients_are_answered_after_the_commit) {
  EXPECT_THAT(say(submission("key")), ElementsAre("line later: submitted { job: \"job-1\" }"));
  EXPECT_THAT(say(submission("key")),
              ElementsAre("line later: submitted { job: \"job-1\" existed: true }"));
  EXPECT_THAT(say(cancel("job-1")), ElementsAre("line later: cancelled { found: true }"));
  EXPECT_THAT(say(cancel("job-2")), ElementsAre("line later: cancelled { }"));
  wire::Envelope retry;
  retry.mutable_retry()->set_job("job-1");
  EXPECT_THAT(say(retry), ElementsAre("line later: retried { count: 1 }"));
  retry.mutable_retry()->set_job("");
  retry.mutable_retry()->set_host("node-1");
  EXPECT_THAT(say(retry), ElementsAre("line later: retried { }")) << "it is in no quarantine";
  wire::Envelope drain;
  drain.mutable_drain_workers();
  EXPECT_THAT(say(drain), ElementsAre("line later: draining { }"));
}

TEST_F(Conversation, submissions_are_refused_with_what_is_wrong) {
  wire::Envelope other = submission("key");
  say(other);
  other.mutable_submit()->set_job_toml("[geometry]\nsurface = \"b.stl\"\n");
  EXPECT_THAT(say(other),
              ElementsAre("line now: refused { reason: \"this submission has the key of job-1, "
                          "which has a different job file or surface: give it a key of its own\" "
                          "exit_code: 2 }"));
  wire::Envelope missing = submission("missing");
  missing.mutable_submit()->mutable_inputs(0)->set_hash(std::string(32, 'f'));
  EXPECT_THAT(say(missing),
              ElementsAre("line now: refused { reason: \"the input "
                          "\\\'input_surface\\\' is not in the store\" exit_code: 5 }"));
  wire::Envelope replaces = submission("replaces");
  replaces.mutable_submit()->set_replaces_others(true);
  EXPECT_THAT(say(replaces),
              ElementsAre("line now: refused { reason: \"submitter anna may not replace the jobs "
                          "of this coordinator, which may serve others too\" exit_code: 1 }"));
  EXPECT_EQ(refusals_.of(Refusal::wrong_role), 1U);
  wire::Envelope outside = submission("outside");
  outside.mutable_submit()->clear_inputs();
  outside.mutable_submit()->set_surface_path("/etc/passwd");
  EXPECT_THAT(say(outside), ElementsAre(HasSubstr("is not in a folder where jobs may name")));
  EXPECT_EQ(refusals_.of(Refusal::outside_roots), 1U);
  EXPECT_EQ(state_.durable().jobs.size(), 1U);
}

TEST_F(Conversation, a_job_waits_only_for_those_that_may_end_well) {
  say(submission("first"));
  int keys = 0;
  const auto after = [this, &keys](const std::string& job) {
    wire::Envelope envelope = submission("after " + std::to_string(++keys));
    envelope.mutable_submit()->add_after(job);
    return say(envelope);
  };
  EXPECT_THAT(after("job-1"), ElementsAre("line later: submitted { job: \"job-2\" }"));
  EXPECT_EQ(state_.durable().jobs.at(JobId{2}).phase, JobPhase::waiting);
  EXPECT_THAT(after("wing"),
              ElementsAre("line now: refused { reason: \"`wing` is no job to wait for: jobs are "
                          "called job-7\" exit_code: 2 }"));
  EXPECT_THAT(after("job-9"), ElementsAre("line now: refused { reason: \"there is no job-9 to wait "
                                          "for\" exit_code: 5 }"));
  say(cancel("job-1"));
  state_.tick(now_);
  EXPECT_EQ(state_.durable().jobs.at(JobId{2}).phase, JobPhase::cancelled);
  EXPECT_THAT(after("job-1"), ElementsAre(HasSubstr("which was cancelled: `tetfarm retry job-1`")));
  wire::Envelope retry;
  retry.mutable_retry()->set_job("job-2");
  EXPECT_THAT(say(retry), ElementsAre(HasSubstr("which was cancelled: `tetfarm retry job-1`")));
  EXPECT_EQ(state_.durable().jobs.size(), 2U);
}

TEST_F(Conversation, who_has_as_many_jobs_as_one_may_have_is_told_what_to_do) {
  FarmRules rules;
  rules.jobs_per_user = 1;
  JobState state(
      {}, rules, [](const ArtifactRef&) { return true; }, now_);
  HandlerOptions with_bound = options(false);
  with_bound.jobs_per_user = 1;
  RequestHandler handler{store_, roots_, with_bound, refusals_};
  const auto said = [&](const wire::Envelope& envelope, const std::string& key) {
    handler.handle(sender("line", Role::submitter, key), encode(envelope), state, now_);
    return texts(handler.take_replies());
  };
  EXPECT_THAT(said(submission("1"), "anna"), ElementsAre(HasSubstr("job-1")));
  EXPECT_THAT(said(submission("2"), "anna"),
              ElementsAre("line now: refused { reason: \"this user has as many jobs that run or "
                          "wait as one may have here, which is 1: wait until one of them is done "
                          "(tetfarm wait), or cancel one\" exit_code: 6 }"));
  EXPECT_THAT(said(submission("1"), "anna"), ElementsAre(HasSubstr("existed: true")));
  EXPECT_THAT(said(submission("2"), "berta"), ElementsAre(HasSubstr("job-2")));
  said(cancel("job-1"), "anna");
  EXPECT_THAT(said(submission("3"), "anna"), ElementsAre(HasSubstr("job-3")));
  wire::Envelope retry;
  retry.mutable_retry()->set_job("job-1");
  EXPECT_THAT(said(retry, "anna"), ElementsAre(HasSubstr("exit_code: 6")));
}

TEST_F(Conversation, a_run_may_replace_its_jobs) {
  RequestHandler handler{store_, roots_, options(true), refusals_};
  say(submission("first"));
  wire::Envelope replaces = submission("second");
  replaces.mutable_submit()->set_replaces_others(true);
  handler.handle(sender("line", Role::submitter), encode(replaces), state_, now_);
  EXPECT_EQ(state_.durable().jobs.at(JobId{1}).phase, JobPhase::cancelled);
  EXPECT_EQ(state_.durable().jobs.at(JobId{2}).phase, JobPhase::running);
}

TEST_F(Conversation, a_worker_is_welcomed_given_tasks_and_told_what_became_of_them) {
  const Sender worker = sender("line", Role::worker);
  EXPECT_THAT(say(worker, hello()),
              ElementsAre("line later: welcome { worker: 1 heartbeat_ms: 700 lease_ms: 8000 }"))
      << "it left no probe in the store";
  say(sender("client", Role::submitter), submission("key"));
  handler_.handle(worker, encode(ready()), state_, now_);
  state_.tick(now_);
  handler_.carry_out(state_, now_);
  std::vector<Reply> replies = handler_.take_replies();
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_TRUE(replies[0].needs_commit);
  const wire::Assign& assign = replies[0].envelope.assign();
  EXPECT_EQ(assign.task(), 1U);
  EXPECT_EQ(assign.attempt(), 1U);
  EXPECT_EQ(assign.limit_ms(), 86'400'000U);
  EXPECT_EQ(assign.kind(), 1U);
  EXPECT_GT(std::stoull(assign.parameters().at("free_bytes")), 0U) << "of the store's disk";
  wire::Envelope failed;
  failed.mutable_failed()->set_task(1);
  failed.mutable_failed()->set_attempt(9);
  EXPECT_THAT(say(worker, failed), ElementsAre("line later: accepted { task: 1 attempt: 9 }"));
  EXPECT_EQ(refusals_.of(Refusal::stale), 1U);
  EXPECT_THAT(refusals_.take_complaints(),
              ElementsAre("refused: stale (1 so far): worker 1 with attempt 9 of task 1"));
  failed.mutable_failed()->set_attempt(1);
  failed.mutable_failed()->set_cause(2);
  EXPECT_THAT(say(worker, failed),
              ElementsAre("line later: accepted { task: 1 attempt: 1 taken: true }"));
  EXPECT_EQ(state_.durable().tasks.at(TaskId{1}).crashes, 1U);
  EXPECT_EQ(refusals_.of(Refusal::stale), 1U);
}

TEST_F(Conversation, a_worker_that_names_what_is_no_input_of_its_task_is_not_believed) {
  const Sender worker = sender("line", Role::worker);
  say(worker, hello());
  say(sender("client", Role::submitter), submission("key"));
  handler_.handle(worker, encode(ready()), state_, now_);
  state_.tick(now_);
  wire::Envelope failed;
  failed.mutable_failed()->set_task(1);
  failed.mutable_failed()->set_attempt(1);
  failed.mutable_failed()->set_cause(6);
  failed.mutable_failed()->add_damaged_inputs(std::string(32, 'f'));
  say(worker, failed);
  const TaskRow& task = state_.durable().tasks.at(TaskId{1});
  EXPECT_EQ(task.losses, 1U);
  const ChangeSet changes = state_.take_changes();
  ASSERT_EQ(changes.attempts.size(), 1U);
  EXPECT_EQ(changes.attempts[0].state, AttemptState::killed) << "there is nothing to make again";
  EXPECT_EQ(task.state, TaskState::ready);
  EXPECT_TRUE(handler_.take_file_orders(state_, now_).empty());
}

TEST_F(Conversation, a_damaged_input_is_looked_at_before_anything_is_decided) {
  const Sender worker = sender("line", Role::worker);
  say(worker, hello());
  say(sender("client", Role::submitter), submission("key"));
  handler_.handle(worker, encode(ready()), state_, now_);
  state_.tick(now_);
  const ArtifactRef surface = state_.durable().tasks.at(TaskId{1}).inputs.at(1);
  wire::Envelope failed;
  failed.mutable_failed()->set_task(1);
  failed.mutable_failed()->set_attempt(1);
  failed.mutable_failed()->set_cause(6);
  failed.mutable_failed()->add_damaged_inputs(surface.hash);
  state_.take_commands();
  EXPECT_THAT(say(worker, failed), IsEmpty());
  const std::vector<FileOrder> orders = handler_.take_file_orders(state_, now_);
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].kind, FileOrder::Kind::check);
  EXPECT_EQ(orders[0].file, (StoredArtifact{surface.hash, surface.size}));
  FileAnswer answer;
  answer.checked = CheckedFile{AttemptId{1}, surface.hash, CheckedFile::Verdict::sound};
  handler_.note_file(answer, state_, now_);
  EXPECT_EQ(state_.durable().tasks.at(TaskId{1}).losses, 1U) << "it is whole here";
}

TEST_F(Conversation, a_workers_hello_needs_a_nonce_and_a_place) {
  wire::Envelope nobody = hello();
  nobody.mutable_hello()->clear_nonce();
  EXPECT_THAT(say(sender("line", Role::worker), nobody),
              ElementsAre("line now: refused { reason: \"a worker\\\'s hello must have a nonce\" "
                          "exit_code: 2 }"));
  EXPECT_EQ(refusals_.of(Refusal::senseless), 1U);
  say(sender("line", Role::worker), hello());
  EXPECT_EQ(say(sender("line", Role::worker), hello()).size(), 1U) << "hello again";
  EXPECT_THAT(say(sender("other", Role::worker), hello()),
              ElementsAre("other now: refused { reason: \"there are already 1 workers\" "
                          "exit_code: 6 }"));
  EXPECT_EQ(refusals_.of(Refusal::too_many_workers), 1U);
  EXPECT_EQ(state_.worker_count(), 1U);
}

TEST_F(Conversation, a_worker_sees_the_store_when_what_it_left_there_is_found) {
  wire::Envelope envelope = hello();
  wire::Hello& hello = *envelope.mutable_hello();
  const std::string name(32, 'a');
  hello.set_probe_file(name);
  hello.set_probe_text("a text");
  const auto sees = [&] {
    const auto said = say(sender("line", Role::worker), envelope);
    return said.size() == 1 && said[0].find("sees_store: true") != std::string::npos;
  };
  EXPECT_FALSE(sees()) << "there is no such file";
  std::ofstream(probe_path(store_, name)) << "a text";
  EXPECT_TRUE(sees());
  hello.set_probe_text("another");
  EXPECT_FALSE(sees());
  hello.set_probe_text("a tex");
  EXPECT_FALSE(sees());
  hello.set_probe_text("a text");
  hello.set_store_probe("of another store");
  EXPECT_FALSE(sees()) << "a copy of the store";
  hello.set_store_probe(store_.probe());
  hello.set_probe_file("../../etc/passwd");
  EXPECT_FALSE(sees());
  std::ofstream(probe_path(store_, name)) << "";
  hello.set_probe_file(name);
  hello.set_probe_text("");
  EXPECT_FALSE(sees()) << "an empty text proves nothing";
}

TEST_F(Conversation, who_is_not_known_is_asked_to_say_hello_but_for_a_goodbye) {
  const Sender worker = sender("line", Role::worker);
  EXPECT_THAT(say(worker, ready()),
              ElementsAre("line now: refused { reason: \"unknown worker\" hello_again: true }"));
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  EXPECT_THAT(say(worker, goodbye), IsEmpty());
  say(worker, hello());
  handler_.forget_workers();
  EXPECT_THAT(say(worker, ready()),
              ElementsAre("line now: refused { reason: \"unknown worker\" hello_again: true }"));
}

TEST_F(Conversation, heartbeats_are_answered_four_times_in_a_lease) {
  const Sender worker = sender("line", Role::worker);
  say(worker, hello());
  EXPECT_THAT(say(worker, beat(0, 0)), ElementsAre("line now: heartbeat { }"));
  now_.steady_ms += 1999;
  EXPECT_THAT(say(worker, beat(0, 0)), IsEmpty());
  now_.steady_ms += 1;
  EXPECT_THAT(say(worker, beat(0, 0)), ElementsAre("line now: heartbeat { }"));
  now_.steady_ms += 2000;
  EXPECT_THAT(say(worker, beat(7, 8)), ElementsAre("line now: heartbeat { task: 7 attempt: 8 }",
                                                   "line later: accepted { task: 7 attempt: 8 }"));
}

TEST_F(Conversation, only_heartbeats_are_told_apart_from_all_else) {
  EXPECT_FALSE(handler_.take_only_heartbeats()) << "nothing was heard";
  say(sender("line", Role::worker), beat(0, 0));
  EXPECT_TRUE(handler_.take_only_heartbeats());
  EXPECT_FALSE(handler_.take_only_heartbeats()) << "since the last call";
  say(sender("line", Role::worker), beat(0, 0));
  say(cancel("job-1"));
  EXPECT_FALSE(handler_.take_only_heartbeats());
}

TEST_F(Conversation, while_it_is_closed_clients_are_refused_and_workers_are_not_heard) {
  const Sender worker = sender("line", Role::worker);
  say(worker, hello());
  handler_.close("the disk is full", ExitCode::out_of_resources);
  EXPECT_TRUE(handler_.is_closed());
  const std::string refusal = "line now: refused { reason: \"the disk is full\" exit_code: 6 }";
  EXPECT_THAT(say(submission("key")), ElementsAre(refusal));
  EXPECT_THAT(say(cancel("job-1")), ElementsAre(refusal));
  wire::Envelope other;
  other.mutable_retry();
  EXPECT_THAT(say(other), ElementsAre(refusal));
  other.mutable_drain_workers();
  EXPECT_THAT(say(other), ElementsAre(refusal));
  other.mutable_offer_file();
  EXPECT_THAT(say(other), ElementsAre(refusal));
  EXPECT_THAT(say(worker, ready()), IsEmpty());
  EXPECT_THAT(say(worker, beat(0, 0)), IsEmpty());
  EXPECT_TRUE(state_.durable().jobs.empty());
  handler_.open();
  EXPECT_FALSE(handler_.is_closed());
  EXPECT_THAT(say(cancel("job-1")), ElementsAre("line later: cancelled { }"));
}

TEST_F(Conversation, what_was_not_committed_is_not_told) {
  handler_.handle(sender("line", Role::submitter), encode(cancel("job-1")), state_, now_);
  handler_.handle(sender("line", Role::worker), encode(ready()), state_, now_);
  EXPECT_THAT(texts(handler_.take_replies_uncommitted()),
              ElementsAre("line now: refused { reason: \"unknown worker\" hello_again: true }"))
      << "the client asks again";
  handler_.handle(sender("line", Role::submitter), encode(cancel("job-1")), state_, now_);
  handler_.handle(sender("line", Role::submitter), encode(submission("key")), state_, now_);
  wire::Envelope other;
  other.mutable_retry();
  handler_.handle(sender("line", Role::submitter), encode(other), state_, now_);
  other.mutable_drain_workers();
  handler_.handle(sender("line", Role::submitter), encode(other), state_, now_);
  handler_.handle(sender("worker", Role::worker, "its key"), encode(hello()), state_, now_);
  handler_.carry_out(state_, now_);
  handler_.close("why", ExitCode::failed);
  const std::string refusal = "line now: refused { reason: \"why\" exit_code: 1 }";
  EXPECT_THAT(texts(handler_.take_replies_uncommitted()),
              ElementsAre(refusal, refusal, refusal, refusal))
      << "the worker says hello again by itself";
  EXPECT_THAT(handler_.take_replies(), IsEmpty());
}

TEST_F(Conversation, a_goodbye_frees_the_place_of_a_worker) {
  const Sender worker = sender("line", Role::worker);
  say(worker, hello());
  EXPECT_EQ(handler_.worker_of("line"), WorkerId{1});
  EXPECT_FALSE(handler_.worker_of("other"));
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  EXPECT_THAT(say(worker, goodbye), IsEmpty());
  EXPECT_FALSE(handler_.worker_of("line"));
  EXPECT_EQ(state_.worker_count(), 0U);
}

TEST_F(Conversation, drained_workers_are_told) {
  say(sender("worker", Role::worker, "its key"), hello());
  wire::Envelope drain;
  drain.mutable_drain_workers();
  EXPECT_THAT(say(drain), testing::UnorderedElementsAre("line later: draining { count: 1 }",
                                                        "worker later: drain { }"));
  drain.mutable_drain_workers()->set_worker(7);
  EXPECT_THAT(say(drain), ElementsAre("line later: draining { }"));
}

}  // namespace
}  // namespace tetfarm
