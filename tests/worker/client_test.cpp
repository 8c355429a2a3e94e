#include "worker/client.h"

#include <gmock/gmock.h>
#include <pthread.h>
#include <stdlib.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>
#include <zmq.hpp>

#include "proto/wire.h"
#include "store/artifact_store.h"
#include "tasks/failure_cause.h"
#include "worker/child_task.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using Body = wire::Envelope::BodyCase;

std::string new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "client-XXXXXX").string();
  return ::mkdtemp(name.data());
}

/// A coordinator played by the test, and one worker in a thread. Its tasks are shell scripts.
class WorkerClient : public ::testing::Test {
 protected:
  ~WorkerClient() override {
    drain_ = true;
    if (worker_.joinable()) {
      hear_goodbye();
      worker_.join();
    }
    std::filesystem::remove_all(folder_);
  }

  void bind() {
    router_ = zmq::socket_t(context_, zmq::socket_type::router);
    router_.set(zmq::sockopt::rcvtimeo, 20'000);
    router_.set(zmq::sockopt::linger, 0);
    router_.bind("ipc://" + folder_ + "/s");
  }

  void start(const std::string& script, std::int64_t grace_ms = 20'000) {
    bind();
    start_worker(script, grace_ms);
  }

  void start_worker(const std::string& script, std::int64_t grace_ms = 20'000) {
    const ArtifactStore store(folder_ + "/store");
    worker_ = std::thread([this, script, grace_ms] {
      WorkerOptions options;
      options.endpoint = "ipc://" + folder_ + "/s";
      options.store = folder_ + "/store";
      options.cache = folder_ + "/cache";
      options.cache_bytes = 1 << 20;
      options.task_command = {"/bin/sh", "-c", script};
      options.grace_ms = grace_ms;
      options.handle_signals = handle_signals_;
      options.drain = &drain_;
      run_worker(options);
    });
  }

  wire::Envelope hear_any() {
    zmq::message_t peer;
    zmq::message_t bytes;
    if (!router_.recv(peer) || !router_.recv(bytes)) return {};
    peer_ = peer.to_string();
    return std::move(decode(bytes.to_string_view()).envelope);
  }

  /// The next message of that kind; others are passed over.
  wire::Envelope hear(Body wanted) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < until) {
      wire::Envelope envelope = hear_any();
      if (envelope.body_case() == wanted) return envelope;
      if (envelope.body_case() == Body::BODY_NOT_SET) break;
    }
    ADD_FAILURE() << "the worker does not say " << static_cast<int>(wanted);
    return {};
  }

  void say(const wire::Envelope& envelope) {
    router_.send(zmq::buffer(peer_), zmq::send_flags::sndmore);
    router_.send(zmq::buffer(encode(envelope)), zmq::send_flags::none);
  }

  void welcome(bool keep_running = false, std::uint32_t lease_ms = 60'000, bool sees_store = true) {
    wire::Envelope envelope;
    envelope.mutable_welcome()->set_worker(1);
    envelope.mutable_welcome()->set_heartbeat_ms(20);
    envelope.mutable_welcome()->set_lease_ms(lease_ms);
    envelope.mutable_welcome()->set_keep_running(keep_running);
    envelope.mutable_welcome()->set_sees_store(sees_store);
    say(envelope);
  }

  void assign(std::uint64_t task, std::uint64_t attempt, std::uint64_t limit_ms = 0) {
    wire::Envelope envelope;
    envelope.mutable_assign()->set_limit_ms(limit_ms);
    envelope.mutable_assign()->set_task(task);
    envelope.mutable_assign()->set_attempt(attempt);
    say(envelope);
  }

  /// The worker comes, is welcome, asks, and gets attempt 9 of task 5.
  void get_task_5(bool sees_store = true, std::uint64_t limit_ms = 0) {
    hear(Body::kHello);
    welcome(false, 60'000, sees_store);
    hear(Body::kReady);
    assign(5, 9, limit_ms);
  }
  void hear_that_task_5_runs() {
    while (hear(Body::kHeartbeat).heartbeat().task() != 5) {
      if (HasFailure()) return;
    }
  }

  void accept(std::uint64_t task, std::uint64_t attempt, bool taken) {
    wire::Envelope envelope;
    envelope.mutable_accepted()->set_task(task);
    envelope.mutable_accepted()->set_attempt(attempt);
    envelope.mutable_accepted()->set_taken(taken);
    say(envelope);
  }

  void hear_goodbye() { hear(Body::kGoodbye); }

  std::string folder_ = new_folder();
  bool handle_signals_ = false;
  std::atomic<bool> drain_ = false;
  zmq::context_t context_{1};
  zmq::socket_t router_;
  std::string peer_;
  std::thread worker_;
};

/// A shell command that says it to the worker.
std::string printed(const wire::Envelope& envelope) {
  std::string octal;
  for (const char c : frame_of(envelope)) {
    char text[8];
    std::snprintf(text, sizeof text, "\\%03o",
                  static_cast<unsigned>(static_cast<unsigned char>(c)));
    octal += text;
  }
  return "printf '" + octal + "' >&3";
}

std::string say_done() {
  wire::Envelope envelope;
  (*envelope.mutable_done()->mutable_numbers())["tets"] = 1;
  return printed(envelope);
}

TEST_F(WorkerClient, clears_up_behind_a_task_that_was_killed) {
  const std::string scratch = folder_ + "/store/scratch";
  start("mkdir " + scratch + "/attempt-9; echo half > " + scratch +
        "/attempt-9/mesh.vtkhdf; kill -9 $$");
  get_task_5();
  EXPECT_EQ(hear(Body::kFailed).failed().attempt(), 9U);
  EXPECT_FALSE(std::filesystem::exists(scratch + "/attempt-9"));
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, whose_probe_was_swept_away_leaves_another_before_it_does_without_the_store) {
  start("true");
  const std::string first = hear(Body::kHello).hello().probe_file();
  std::filesystem::remove(folder_ + "/store/scratch/probe-" + first);
  welcome(false, 60'000, false);
  const std::string second = hear(Body::kHello).hello().probe_file();
  EXPECT_NE(second, first);
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/store/scratch/probe-" + second));
  welcome();
  hear(Body::kReady);
}

TEST_F(WorkerClient, says_hello_as_soon_as_there_is_a_coordinator) {
  start_worker("true");
  // Long enough for the pauses between hellos that nobody hears to have grown to a second.
  std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
  bind();
  router_.set(zmq::sockopt::rcvtimeo, 500);
  ASSERT_EQ(hear_any().body_case(), Body::kHello);
  router_.set(zmq::sockopt::rcvtimeo, 20'000);
  welcome();
  hear(Body::kReady);
}

TEST_F(WorkerClient, shows_the_stores_mark_and_asks_for_work) {
  start("exit 1");
  const wire::Envelope hello = hear(Body::kHello);
  const ArtifactStore store(folder_ + "/store");
  EXPECT_EQ(hello.hello().store_probe(), store.probe());
  std::ifstream probe(probe_path(store, hello.hello().probe_file()));
  std::string text;
  EXPECT_TRUE(probe >> text);
  EXPECT_EQ(text, hello.hello().probe_text());
  EXPECT_GT(hello.hello().cores(), 0U);
  welcome();
  hear(Body::kReady);
}

TEST_F(WorkerClient, runs_a_task_and_asks_again_once_its_result_is_accepted) {
  start(say_done());
  get_task_5();
  const wire::Envelope done = hear(Body::kDone);
  EXPECT_EQ(done.done().task(), 5U);
  EXPECT_EQ(done.done().attempt(), 9U);
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, asks_for_the_next_task_with_a_result_and_begins_it_with_the_answer) {
  start(say_done());
  get_task_5();
  hear(Body::kDone);
  hear(Body::kReady);
  accept(5, 9, true);
  assign(6, 10);
  EXPECT_EQ(hear(Body::kDone).done().attempt(), 10U);
  accept(6, 10, true);
}

TEST_F(WorkerClient, asks_again_when_no_task_came_with_the_answer) {
  start(say_done());
  get_task_5();
  hear(Body::kDone);
  hear(Body::kReady);
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, repeats_a_result_until_it_is_accepted) {
  start(say_done());
  get_task_5();
  hear(Body::kDone);
  accept(5, 8, true);
  hear(Body::kDone);
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, a_result_follows_its_last_file_at_once) {
  wire::Envelope done;
  wire::Artifact& output = *done.mutable_done()->add_outputs();
  output.set_name("mesh");
  output.set_hash(std::string(32, 'a'));
  output.set_size(1);
  start(printed(done));
  hear(Body::kHello);
  welcome(false, 60'000, false);
  hear(Body::kReady);
  for (std::uint64_t task = 1; task <= 3; ++task) {
    assign(task, 10 + task);
    wire::Envelope stored;
    wire::FileStored& file = *stored.mutable_file_stored();
    file.set_task(task);
    file.set_attempt(10 + task);
    file.set_hash(hear(Body::kOfferFile).offer_file().hash());
    file.set_whole(true);
    say(stored);
    // A result that is lost is said again after a second, which is fifty heartbeats.
    int heartbeats = 0;
    wire::Envelope next = hear_any();
    for (; next.has_heartbeat(); next = hear_any()) ++heartbeats;
    EXPECT_TRUE(next.has_done());
    EXPECT_LT(heartbeats, 25);
    accept(task, 10 + task, true);
    hear(Body::kReady);
  }
}

TEST_F(WorkerClient, a_child_that_crashes_is_reported_and_the_worker_lives_on) {
  start("kill -SEGV $$");
  get_task_5();
  EXPECT_THAT(hear(Body::kFailed).failed().message(), HasSubstr("signal 11"));
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, heartbeats_name_the_running_task) {
  start("sleep 1000");
  get_task_5();
  wire::Envelope heartbeat;
  while (heartbeat.heartbeat().task() == 0) heartbeat = hear(Body::kHeartbeat);
  EXPECT_EQ(heartbeat.heartbeat().attempt(), 9U);
  accept(5, 9, false);
  hear(Body::kReady);
}

TEST_F(WorkerClient, ends_a_stale_task_and_asks_for_another) {
  start("sleep 1000");
  get_task_5();
  assign(6, 10);
  accept(5, 9, false);
  hear(Body::kReady);
  assign(6, 11);
  wire::Envelope heartbeat;
  while (heartbeat.heartbeat().attempt() != 11) heartbeat = hear(Body::kHeartbeat);
  accept(6, 11, false);
  hear(Body::kReady);
}

TEST_F(WorkerClient, presents_its_running_attempt_to_a_coordinator_that_does_not_know_it) {
  start("sleep 1000");
  get_task_5();
  wire::Envelope heartbeat;
  while (heartbeat.heartbeat().task() == 0) heartbeat = hear(Body::kHeartbeat);
  wire::Envelope refused;
  refused.mutable_refused()->set_hello_again(true);
  say(refused);
  const wire::Envelope hello = hear(Body::kHello);
  EXPECT_EQ(hello.hello().running_task(), 5U);
  EXPECT_EQ(hello.hello().running_attempt(), 9U);
  welcome(false);
  hear(Body::kReady);
}

TEST_F(WorkerClient, keeps_a_result_over_a_restart_of_the_coordinator) {
  start(say_done());
  hear(Body::kHello);
  welcome(false, 200);
  hear(Body::kReady);
  assign(5, 9);
  hear(Body::kDone);
  router_.close();
  bind();
  const wire::Envelope hello = hear(Body::kHello);
  EXPECT_EQ(hello.hello().running_attempt(), 9U);
  welcome(true);
  EXPECT_EQ(hear(Body::kDone).done().attempt(), 9U);
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, a_drained_worker_finishes_its_task_and_leaves) {
  start("sleep 0.3; " + say_done());
  get_task_5();
  wire::Envelope heartbeat;
  while (heartbeat.heartbeat().task() == 0) heartbeat = hear(Body::kHeartbeat);
  wire::Envelope drain;
  drain.mutable_drain();
  say(drain);
  hear(Body::kDone);
  accept(5, 9, true);
  hear(Body::kGoodbye);
  worker_.join();
}

TEST_F(WorkerClient, a_drained_worker_hands_its_task_back_after_the_grace_time) {
  start("sleep 1000", 50);
  get_task_5();
  wire::Envelope heartbeat;
  while (heartbeat.heartbeat().task() == 0) heartbeat = hear(Body::kHeartbeat);
  drain_ = true;
  hear(Body::kGoodbye);
  worker_.join();
}

TEST_F(WorkerClient, a_second_signal_hands_the_task_back_at_once) {
  handle_signals_ = true;
  start("sleep 1000", 60'000);
  get_task_5();
  hear_that_task_5_runs();
  // Of one sort they would be one; to the thread, since the others do not wait for them.
  ::pthread_kill(worker_.native_handle(), SIGTERM);
  ::pthread_kill(worker_.native_handle(), SIGINT);
  hear(Body::kGoodbye);
  worker_.join();
}

TEST_F(WorkerClient, a_first_signal_lets_the_task_go_on) {
  handle_signals_ = true;
  const std::string go = folder_ + "/go";
  start("while [ ! -e " + go + " ]; do sleep 0.01; done; " + say_done());
  get_task_5();
  hear_that_task_5_runs();
  ::pthread_kill(worker_.native_handle(), SIGTERM);
  for (int heartbeats = 0; heartbeats < 5; ++heartbeats) hear_that_task_5_runs();
  std::ofstream{go};
  EXPECT_EQ(hear(Body::kDone).done().attempt(), 9U);
  accept(5, 9, true);
  hear(Body::kGoodbye);
  worker_.join();
}

TEST_F(WorkerClient, a_drained_worker_leaves_when_a_task_comes_with_the_answer) {
  const std::string ran = folder_ + "/ran";
  start("echo run >> " + ran + "; " + say_done());
  get_task_5();
  hear(Body::kDone);
  hear(Body::kReady);
  wire::Envelope drain;
  drain.mutable_drain();
  say(drain);
  accept(5, 9, true);
  assign(6, 10);
  hear(Body::kGoodbye);
  worker_.join();
  EXPECT_EQ(std::filesystem::file_size(ran), 4U) << "one run";
}

TEST_F(WorkerClient, a_task_that_runs_beyond_its_limit_is_ended_and_that_is_no_end_from_outside) {
  start("sleep 1000");
  get_task_5(true, 100);
  const wire::Failed failed = hear(Body::kFailed).failed();
  EXPECT_THAT(failed.message(), HasSubstr("took longer than its limit"));
  EXPECT_NE(failed.cause(), on_wire(FailureCause::killed));
  accept(5, 9, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient,
       a_full_disk_of_a_worker_without_a_shared_store_is_its_own_and_that_of_the_store_everybodys) {
  wire::Envelope full;
  full.mutable_failed()->set_message("no space");
  full.mutable_failed()->set_cause(on_wire(FailureCause::disk_full));
  start(printed(full));
  get_task_5(false);
  const wire::Failed own = hear(Body::kFailed).failed();
  EXPECT_EQ(own.message(), "no space");
  EXPECT_EQ(own.cause(), on_wire(FailureCause::killed));
  welcome(true);
  accept(5, 9, true);
  hear(Body::kReady);
  assign(6, 10);
  wire::Failed shared = hear(Body::kFailed).failed();
  while (shared.attempt() == 9 && !HasFailure()) shared = hear(Body::kFailed).failed();
  EXPECT_EQ(shared.cause(), on_wire(FailureCause::disk_full));
  accept(6, 10, true);
  hear(Body::kReady);
}

TEST_F(WorkerClient, garbage_from_the_coordinator_is_passed_over) {
  start(say_done());
  hear(Body::kHello);
  router_.send(zmq::buffer(peer_), zmq::send_flags::sndmore);
  router_.send(zmq::str_buffer("\xff\xff garbage"), zmq::send_flags::none);
  welcome();
  hear(Body::kReady);
}

}  // namespace
}  // namespace tetfarm
