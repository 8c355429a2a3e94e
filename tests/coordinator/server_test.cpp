#include "coordinator/server.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <optional>
#include <random>
#include <thread>
#include <zmq.hpp>

#include "base/file_system.h"
#include "base/hash.h"
#include "proto/wire.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tasks/failure_cause.h"
#include "tasks/task_kind.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/child_coordinator.h"
#include "tests/coordinator/store_messages.h"

namespace tetfarm {
namespace {

using test::ChildCoordinator;
using test::Dealer;
using testing::HasSubstr;

class ServerTest : public testing::Test, protected test::WithStore {
 protected:
  ServerTest() : coordinator_(folder_.path()) {}

  static wire::Envelope ready() {
    wire::Envelope envelope;
    envelope.mutable_ready();
    return envelope;
  }
  /// The result of a make-believe task, its files published.
  /// Inspect, two cuts, a mesh and a portion for each of three leaves, number, assemble.
  static constexpr int tasks_of_the_job = 11;

  wire::Envelope done(const wire::Assign& assign) {
    wire::Envelope envelope;
    wire::Done& done = *envelope.mutable_done();
    done.set_task(assign.task());
    done.set_attempt(assign.attempt());
    const auto add = [&](const std::string& name) {
      test::add_file(
          *done.add_outputs(), name,
          store_.publish(name + std::to_string(assign.kind()) + std::to_string(assign.path())));
    };
    auto& numbers = *done.mutable_numbers();
    switch (task_kind_on_wire(assign.kind()).value()) {
      case TaskKind::inspect:
        for (const char* name : {"surface", "spacing", "root", "settings"}) add(name);
        for (const char* name : {"total_work", "groups", "most_bytes", "needles", "across_cuts"}) {
          numbers[name] = 0;
        }
        numbers["parts"] = 3;
        break;
      case TaskKind::decompose:
        for (const char* name : {"left", "right"}) add(name);
        for (const char* name : {"left_work", "right_work", "left_needles", "right_needles"}) {
          numbers[name] = 0;
        }
        numbers["interdomain_nodes"] = 4;
        break;
      case TaskKind::mesh:
        add("mesh");
        numbers["interior_nodes"] = 10;
        numbers["tets"] = 100;
        break;
      case TaskKind::number:
        add("numbering");
        (*done.mutable_texts())["table"] = assign.parameters().at("table");
        break;
      case TaskKind::write:
        add("portion");
        add("tets");
        break;
      default:
        add("mesh.vtu");
        numbers["tets"] = 300;
    }
    return envelope;
  }
  static wire::Envelope claim_of_damage(const wire::Assign& assign, const std::string& hash) {
    wire::Envelope failed;
    failed.mutable_failed()->set_task(assign.task());
    failed.mutable_failed()->set_attempt(assign.attempt());
    failed.mutable_failed()->set_cause(on_wire(FailureCause::damaged_input));
    failed.mutable_failed()->add_damaged_inputs(hash);
    return failed;
  }
  static wire::Envelope status_request() {
    wire::Envelope envelope;
    envelope.mutable_status_request();
    return envelope;
  }

  ChildCoordinator coordinator_;
};

TEST_F(ServerTest, runs_a_job_to_its_end) {
  Dealer client(coordinator_.endpoint());
  EXPECT_FALSE(client.ask(submission("k")).submitted().existed());
  Dealer worker(coordinator_.endpoint());
  ASSERT_TRUE(worker.ask(hello()).has_welcome());
  for (int tasks = 0; tasks < tasks_of_the_job; ++tasks) {
    const wire::Envelope assign = worker.ask(ready());
    ASSERT_TRUE(assign.has_assign());
    ASSERT_TRUE(worker.ask(done(assign.assign())).accepted().taken());
  }
  const wire::Envelope reply = client.ask(status_request());
  ASSERT_EQ(reply.status_reply().jobs_size(), 1);
  const wire::JobStatus& job = reply.status_reply().jobs(0);
  EXPECT_EQ(job.state(), "done");
  EXPECT_EQ(job.leaves_meshed(), 3U);
  EXPECT_EQ(job.elements(), 300U);
  EXPECT_EQ(job.numbers().at("tets"), 300);
  ASSERT_EQ(job.files_size(), 1);
  EXPECT_TRUE(store_.has(job.files(0).hash(), job.files(0).size()));
  EXPECT_TRUE(client.ask(submission("k")).submitted().existed());
}

TEST_F(ServerTest, a_worker_that_asks_for_more_with_its_result_gets_it_with_the_answer) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer worker(coordinator_.endpoint());
  ASSERT_TRUE(worker.ask(hello()).has_welcome());
  wire::Envelope assign = worker.ask(ready());
  for (int tasks = 1; tasks < tasks_of_the_job; ++tasks) {
    worker.send(done(assign.assign()));
    worker.send(ready());
    ASSERT_TRUE(worker.receive().accepted().taken());
    const std::uint64_t last = assign.assign().attempt();
    assign = worker.receive();
    ASSERT_GT(assign.assign().attempt(), last);
  }
}

TEST_F(ServerTest, answers_heartbeats_several_times_in_a_lease_and_not_each) {
  Dealer worker(coordinator_.endpoint());
  ASSERT_TRUE(worker.ask(hello()).has_welcome());
  wire::Envelope heartbeat;
  heartbeat.mutable_heartbeat();
  worker.send(heartbeat);
  EXPECT_FALSE(worker.hears_nothing(2000));
  ASSERT_TRUE(worker.ask(hello()).has_welcome());
  worker.send(heartbeat);
  EXPECT_TRUE(worker.hears_nothing(100));
}

TEST_F(ServerTest, refuses_another_version_and_goes_on) {
  Dealer stranger(coordinator_.endpoint());
  wire::Envelope future = hello();
  future.set_version(protocol_version + 1);
  stranger.send_bytes(future.SerializeAsString());
  const wire::Envelope reply = stranger.receive();
  EXPECT_THAT(reply.refused().reason(), HasSubstr("version"));
  EXPECT_FALSE(reply.refused().hello_again());
  EXPECT_TRUE(stranger.ask(hello()).has_welcome());
}

TEST_F(ServerTest, believes_that_a_worker_sees_the_store_when_it_finds_what_the_worker_left_there) {
  Dealer worker(coordinator_.endpoint());
  wire::Envelope with_probe = hello();
  EXPECT_FALSE(worker.ask(with_probe).welcome().sees_store()) << "a copy has the same mark";
  const std::string name(32, 'a');
  with_probe.mutable_hello()->set_probe_file(name);
  with_probe.mutable_hello()->set_probe_text("text");
  EXPECT_FALSE(worker.ask(with_probe).welcome().sees_store()) << "no such file here";
  std::ofstream(probe_path(store_, name)) << "other";
  EXPECT_FALSE(worker.ask(with_probe).welcome().sees_store()) << "another's file";
  std::ofstream(probe_path(store_, name)) << "text";
  EXPECT_TRUE(worker.ask(with_probe).welcome().sees_store());
  with_probe.mutable_hello()->set_store_probe("other");
  EXPECT_FALSE(worker.ask(with_probe).welcome().sees_store());
  with_probe.mutable_hello()->set_probe_file("../../etc/passwd");
  EXPECT_FALSE(worker.ask(with_probe).welcome().sees_store());
}

TEST_F(ServerTest, refuses_a_worker_that_does_not_say_which_process_it_is) {
  Dealer worker(coordinator_.endpoint());
  wire::Envelope nameless = hello();
  nameless.mutable_hello()->clear_nonce();
  EXPECT_THAT(worker.ask(nameless).refused().reason(), HasSubstr("nonce"));
  EXPECT_TRUE(worker.ask(hello()).has_welcome());
}

TEST_F(ServerTest, replaces_jobs_only_where_it_serves_one_run) {
  Dealer client(coordinator_.endpoint());
  ASSERT_TRUE(client.ask(submission("first")).has_submitted());
  wire::Envelope replacing = submission("second");
  replacing.mutable_submit()->set_replaces_others(true);
  EXPECT_THAT(client.ask(replacing).refused().reason(), HasSubstr("may not replace"));
  EXPECT_EQ(client.ask(status_request()).status_reply().jobs(0).state(), "running");
  coordinator_.stop(SIGTERM);
  CoordinatorOptions options;
  options.one_job = true;
  const ChildCoordinator own(folder_.path(), options);
  Dealer run(own.endpoint());
  EXPECT_TRUE(run.ask(replacing).has_submitted());
  EXPECT_EQ(run.ask(status_request()).status_reply().jobs(0).state(), "cancelled");
}

TEST_F(ServerTest, answers_a_viewer_and_says_what_is_not_there) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  wire::Envelope question;
  question.mutable_query()->set_subject(wire::Query::EXPLAIN);
  question.mutable_query()->set_task(1);
  const wire::Envelope reply = client.ask(question);
  ASSERT_THAT(reply.query_reply().explanation().reasons(), testing::SizeIs(1));
  EXPECT_EQ(reply.query_reply().explanation().reasons(0), "no worker is connected");
  question.mutable_query()->set_task(9);
  EXPECT_THAT(client.ask(question).refused().reason(), HasSubstr("no task 9"));
}

TEST_F(ServerTest, asks_an_unknown_worker_to_say_hello) {
  Dealer worker(coordinator_.endpoint());
  EXPECT_TRUE(worker.ask(ready()).refused().hello_again());
}

TEST_F(ServerTest, counts_garbage_and_lives) {
  Dealer stranger(coordinator_.endpoint());
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    std::string bytes(random() % 100, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    stranger.send_bytes(bytes);
  }
  wire::Envelope backwards;
  backwards.mutable_welcome();
  stranger.send(backwards);
  Dealer client(coordinator_.endpoint());
  EXPECT_TRUE(client.ask(submission("k")).has_submitted());
  wire::Envelope reply;
  stranger.send(status_request());
  do {
    reply = stranger.receive();
  } while (reply.has_refused());
  EXPECT_GE(reply.status_reply().dropped_messages(), 501U);
}

TEST_F(ServerTest, refuses_inputs_that_are_not_in_the_store) {
  Dealer client(coordinator_.endpoint());
  wire::Envelope envelope = submission("k");
  envelope.mutable_submit()->mutable_inputs(0)->set_hash(std::string(32, '0'));
  EXPECT_THAT(client.ask(envelope).refused().reason(), HasSubstr("input_surface"));
}

TEST_F(ServerTest, a_stale_done_is_refused_and_a_second_done_taken_only_once) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer first(coordinator_.endpoint());
  first.ask(hello());
  const wire::Assign assign = first.ask(ready()).assign();
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  first.send(goodbye);
  EXPECT_TRUE(first.ask(hello()).has_welcome());
  Dealer second(coordinator_.endpoint());
  second.ask(hello());
  const wire::Assign again = second.ask(ready()).assign();
  EXPECT_EQ(again.task(), assign.task());
  EXPECT_NE(again.attempt(), assign.attempt());
  EXPECT_FALSE(first.ask(done(assign)).accepted().taken());
  EXPECT_TRUE(second.ask(done(again)).accepted().taken());
  EXPECT_TRUE(second.ask(done(again)).accepted().taken());
  EXPECT_FALSE(first.ask(done(assign)).accepted().taken());
  const wire::JobStatus job = client.ask(status_request()).status_reply().jobs(0);
  EXPECT_EQ(job.tasks_done(), 1U);
}

TEST_F(ServerTest, a_damaged_input_is_put_aside_and_made_again) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer worker(coordinator_.endpoint());
  worker.ask(hello());
  const wire::Assign inspect = worker.ask(ready()).assign();
  worker.ask(done(inspect));
  const wire::Assign cut = worker.ask(ready()).assign();
  std::string hash;
  for (const wire::Artifact& input : cut.inputs()) {
    if (input.name() == "subdomain") hash = input.hash();
  }
  std::ofstream(store_.path_of(hash), std::ios::in | std::ios::out) << "X";
  EXPECT_TRUE(worker.ask(claim_of_damage(cut, hash)).has_accepted());
  const wire::Assign again = worker.ask(ready()).assign();
  EXPECT_EQ(again.task(), inspect.task());
  EXPECT_TRUE(worker.ask(done(again)).accepted().taken());
  EXPECT_EQ(worker.ask(ready()).assign().task(), cut.task());
  EXPECT_EQ(count_files(folder_.path() / "damaged"), 1U);
}

TEST_F(ServerTest, answers_others_while_a_file_is_read_that_is_said_to_be_damaged) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer worker(coordinator_.endpoint());
  worker.ask(hello());
  const wire::Assign inspect = worker.ask(ready()).assign();
  const std::string hash = inspect.inputs(inspect.inputs_size() - 1).hash();
  // Who reads a pipe waits for who writes it.
  const std::filesystem::path path = store_.path_of(hash);
  const std::string other_bytes(inspect.inputs(inspect.inputs_size() - 1).size(), 'x');
  std::filesystem::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const wire::Envelope failed = claim_of_damage(inspect, hash);
  worker.send(failed);
  worker.send(failed);
  wire::Envelope heartbeat;
  heartbeat.mutable_heartbeat()->set_task(inspect.task());
  heartbeat.mutable_heartbeat()->set_attempt(inspect.attempt());
  worker.send(heartbeat);
  EXPECT_FALSE(worker.hears_nothing(5000)) << "the heartbeat is not answered";
  EXPECT_EQ(client.ask(status_request()).status_reply().jobs_size(), 1);
  const int writer = ::open(path.c_str(), O_WRONLY);
  std::filesystem::remove(path);
  std::ofstream(path) << other_bytes;
  ::close(writer);
  EXPECT_TRUE(worker.receive().accepted().taken());
  EXPECT_EQ(count_files(folder_.path() / "damaged"), 1U);
}

TEST_F(ServerTest, a_cancelled_job_ends_its_attempts) {
  Dealer client(coordinator_.endpoint());
  const std::string job = client.ask(submission("k")).submitted().job();
  Dealer worker(coordinator_.endpoint());
  worker.ask(hello());
  const wire::Assign assign = worker.ask(ready()).assign();
  wire::Envelope cancel;
  cancel.mutable_cancel()->set_job(job);
  EXPECT_TRUE(client.ask(cancel).cancelled().found());
  const wire::Envelope told = worker.receive();
  EXPECT_EQ(told.accepted().attempt(), assign.attempt());
  EXPECT_FALSE(told.accepted().taken());
  cancel.mutable_cancel()->set_job("job-77");
  EXPECT_FALSE(client.ask(cancel).cancelled().found());
}

TEST_F(ServerTest, with_a_full_disk_it_is_stuck_and_goes_on_when_there_is_room) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer worker(coordinator_.endpoint());
  worker.ask(hello());
  const wire::Assign assign = worker.ask(ready()).assign();
  coordinator_.limit_file_size(8192);
  worker.send(done(assign));
  std::string state;
  while (state != "stuck") {
    const wire::StatusReply status = client.ask_until_answered(status_request()).status_reply();
    ASSERT_EQ(status.jobs_size(), 1);
    state = status.jobs(0).state();
    ASSERT_EQ(status.jobs(0).tasks_done(), 0U) << "told before it was durable";
  }
  coordinator_.limit_file_size(RLIM_INFINITY);
  wire::Envelope answer = worker.ask_until_answered(done(assign));
  while (!answer.has_accepted()) {
    answer =
        worker.ask(answer.has_refused() ? hello(assign.task(), assign.attempt()) : done(assign));
  }
  EXPECT_TRUE(answer.accepted().taken());
  worker.send(ready());
  // Before that come the answers to what was said more than once.
  for (int i = 0; i < 100 && !answer.has_assign(); ++i) answer = worker.receive();
  EXPECT_TRUE(answer.has_assign());
}

TEST_F(ServerTest, a_second_coordinator_on_the_store_is_refused) {
  Dealer client(coordinator_.endpoint());
  client.ask(status_request());
  CoordinatorOptions options;
  options.store = folder_.path();
  options.endpoints = {"ipc://" + (folder_.path() / "other").string()};
  EXPECT_THROW(run_coordinator(options), UsageError);
}

TEST_F(ServerTest, a_signal_stops_it_cleanly) {
  Dealer client(coordinator_.endpoint());
  client.ask(status_request());
  EXPECT_TRUE(size_of_file(endpoints_file(folder_.path())));
  EXPECT_EQ(coordinator_.stop(SIGTERM), 0);
  EXPECT_FALSE(size_of_file(endpoints_file(folder_.path())));
}

TEST_F(ServerTest, killed_before_every_result_it_goes_on_and_accepts_each_once) {
  coordinator_.stop(SIGKILL);
  std::string table;
  int taken = 0;
  std::optional<wire::Assign> running;
  for (int restarts = 0; restarts < 20 && taken < tasks_of_the_job; ++restarts) {
    ChildCoordinator next(folder_.path());
    Dealer worker(next.endpoint());
    EXPECT_EQ(worker.ask(submission("k")).submitted().existed(), restarts > 0);
    const wire::Envelope welcome =
        worker.ask(running ? hello(running->task(), running->attempt()) : hello());
    EXPECT_EQ(welcome.welcome().keep_running(), running.has_value());
    if (running) {
      const wire::Envelope result = done(*running);
      if (running->kind() == traits_of(TaskKind::number).on_wire)
        table = result.done().texts().at("table");
      if (worker.ask(result).accepted().taken()) ++taken;
      running.reset();
      if (taken == tasks_of_the_job) break;
    }
    running = worker.ask(ready()).assign();
  }
  EXPECT_EQ(taken, tasks_of_the_job);
  EXPECT_EQ(table, "cut 1 4\nleaf 2 10 100\ncut 3 4\nleaf 6 10 100\nleaf 7 10 100\n");
  const JobDatabase database(folder_.path() / "tetfarm.db");
  EXPECT_EQ(database.load().jobs.at(JobId{1}).phase, JobPhase::done);
  for (const AttemptRow& attempt : database.history().attempts_of({}, {}, 1000)) {
    EXPECT_EQ(attempt.state, AttemptState::done);
  }
}

TEST(Server, other_hosts_are_let_in_only_when_asked_for) {
  const TempFolder folder;
  CoordinatorOptions options;
  options.store = folder.path();
  options.endpoints = {"tcp://0.0.0.0:*"};
  EXPECT_THROW(run_coordinator(options), UsageError);
  options.endpoints = {};
  EXPECT_THROW(run_coordinator(options), UsageError);
  options.endpoints = {"nonsense"};
  EXPECT_THROW(run_coordinator(options), UsageError);
}

TEST(Server, runs_in_a_thread_and_tells_the_port_it_got) {
  const TempFolder folder;
  std::atomic<bool> stop{false};
  std::string endpoint;
  CoordinatorOptions options;
  options.store = folder.path();
  options.endpoints = {"tcp://127.0.0.1:*"};
  options.handle_signals = false;
  options.stop = &stop;
  options.on_listening = [&](const std::vector<std::string>& bound) {
    endpoint = bound.front();
    stop = true;
  };
  std::thread thread([&] { run_coordinator(options); });
  thread.join();
  EXPECT_THAT(endpoint, testing::StartsWith("tcp://127.0.0.1:"));
  EXPECT_THAT(endpoint, testing::Not(HasSubstr("*")));
}

}  // namespace
}  // namespace tetfarm
