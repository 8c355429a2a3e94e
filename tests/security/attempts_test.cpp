// A worker with a key that is right tells of tasks that are not its own, or lies of those that are.
#include <cmath>
#include <limits>

#include "tasks/failure_cause.h"
#include "tests/security/raw_worker.h"

namespace tetfarm {
namespace {

using test::done_message;
using test::failed_message;
using test::RawPeer;
using test::RawWorker;
using ::testing::HasSubstr;

constexpr std::uint64_t largest = ~std::uint64_t{0};
constexpr const char* some_hash = "0123456789abcdef0123456789abcdef";

class Attempts : public test::WithOneJob {
 protected:
  Attempts() : owner_(farm(), farm().keys_of("node"), "of the owner") {}

  void SetUp() override {
    WithOneJob::SetUp();
    held_ = owner_.take_task();
  }
  /// The owner still holds its attempt.
  void expect_untouched() {
    EXPECT_EQ(job_status().tasks_running(), 1U);
    EXPECT_EQ(job_status().tasks_done(), 0U);
    EXPECT_EQ(job_status().crashes(), 0U);
    EXPECT_EQ(owner_.take_task().attempt(), held_.attempt()) << "the same is said again";
  }
  wire::Envelope done_with(const std::string& name, const std::string& hash,
                           std::uint64_t size) const {
    wire::Envelope done = done_message(held_.task(), held_.attempt());
    wire::Artifact& output = *done.mutable_done()->add_outputs();
    output.set_name(name);
    output.set_hash(hash);
    output.set_size(size);
    return done;
  }

  RawWorker owner_;
  wire::Assign held_;
};

TEST_F(Attempts, the_result_of_another_workers_attempt_is_not_taken) {
  RawWorker thief(farm(), farm().keys_of("spare"), "of the thief");
  EXPECT_FALSE(thief.is_taken(done_message(held_.task(), held_.attempt())));
  expect_untouched();
  EXPECT_EQ(counted("stale"), 1U);
}

TEST_F(Attempts, another_workers_attempt_cannot_be_made_to_fail) {
  RawWorker thief(farm(), farm().keys_of("spare"), "of the thief");
  EXPECT_FALSE(thief.is_taken(failed_message(held_.task(), held_.attempt())));
  expect_untouched();
}

TEST_F(Attempts, a_nonce_that_was_read_somewhere_takes_no_attempt_over) {
  RawWorker worker(farm(), farm().keys_of("spare"), "of the owner");
  RawPeer& thief = worker.peer();
  wire::Envelope hello = test::hello_of("of the owner");
  hello.mutable_hello()->set_running_task(held_.task());
  hello.mutable_hello()->set_running_attempt(held_.attempt());
  EXPECT_FALSE(thief.ask(hello).welcome().keep_running());
  const wire::Envelope answer = thief.ask(failed_message(held_.task(), held_.attempt()));
  EXPECT_FALSE(answer.accepted().taken());
  expect_untouched();
}

TEST_F(Attempts, a_guessed_nonce_under_the_same_key_takes_no_attempt_over) {
  RawWorker worker(farm(), farm().keys_of("node"), "of the thief");
  RawPeer& thief = worker.peer();
  for (const std::string nonce : {"of the owne", "of the owner ", "", "%", "of the owner' or '1"}) {
    wire::Envelope hello = test::hello_of(nonce);
    hello.mutable_hello()->set_running_task(held_.task());
    hello.mutable_hello()->set_running_attempt(held_.attempt());
    EXPECT_FALSE(thief.ask(hello).welcome().keep_running()) << nonce;
  }
  expect_untouched();
  EXPECT_EQ(counted("senseless"), 1U) << "a hello without a nonce";
}

TEST_F(Attempts, an_attempt_that_is_over_cannot_be_brought_again) {
  wire::Envelope killed = failed_message(held_.task(), held_.attempt());
  killed.mutable_failed()->set_cause(on_wire(FailureCause::killed));
  EXPECT_TRUE(owner_.is_taken(killed));
  EXPECT_FALSE(owner_.is_taken(done_message(held_.task(), held_.attempt())));
  EXPECT_FALSE(owner_.is_taken(failed_message(held_.task(), held_.attempt())));
  const wire::Assign second = owner_.take_task();
  EXPECT_EQ(second.task(), held_.task());
  EXPECT_NE(second.attempt(), held_.attempt());
  EXPECT_FALSE(owner_.is_taken(done_message(held_.task(), held_.attempt())));
  EXPECT_EQ(counted("stale"), 3U);
}

TEST_F(Attempts, numbers_of_tasks_and_attempts_that_cannot_be_are_stale) {
  RawWorker guesser(farm(), farm().keys_of("spare"), "of the guesser");
  for (const std::uint64_t task : {std::uint64_t{0}, held_.task(), largest}) {
    for (const std::uint64_t attempt : {std::uint64_t{0}, held_.attempt() + 1, largest}) {
      EXPECT_FALSE(guesser.is_taken(done_message(task, attempt)));
      EXPECT_FALSE(guesser.is_taken(failed_message(task, attempt)));
    }
  }
  expect_untouched();
}

TEST_F(Attempts, a_heartbeat_for_anothers_attempt_is_told_that_it_is_not_its_own) {
  RawWorker thief(farm(), farm().keys_of("spare"), "of the thief");
  wire::Envelope beat;
  beat.mutable_heartbeat()->set_task(held_.task());
  beat.mutable_heartbeat()->set_attempt(held_.attempt());
  EXPECT_FALSE(thief.is_taken(beat));
  expect_untouched();
}

TEST_F(Attempts, outputs_that_are_not_in_the_store_make_no_result) {
  EXPECT_FALSE(owner_.is_taken(done_with("surface", some_hash, 100)));
  EXPECT_EQ(job_status().tasks_done(), 0U);
}

TEST_F(Attempts, an_output_of_another_size_than_its_file_makes_no_result) {
  const std::string hash = held_.inputs(0).hash();
  EXPECT_FALSE(owner_.is_taken(done_with("surface", hash, held_.inputs(0).size() + 1)));
  EXPECT_EQ(job_status().tasks_done(), 0U);
}

TEST_F(Attempts, a_hash_that_is_a_path_makes_no_result) {
  EXPECT_FALSE(owner_.is_taken(done_with("surface", "../../keys/coordinator.key", 84)));
  EXPECT_FALSE(
      owner_.is_taken(done_with("surface", (farm().keys_folder() / "coordinator.key"), 84)));
  EXPECT_EQ(job_status().tasks_done(), 0U);
}

TEST_F(Attempts, outputs_of_the_wrong_kind_make_an_unusable_result) {
  // The file is there, but it is no output of an inspection.
  EXPECT_TRUE(
      owner_.is_taken(done_with("../../../x", held_.inputs(0).hash(), held_.inputs(0).size())));
  EXPECT_EQ(job_status().state(), "failed");
  EXPECT_EQ(job_status().tasks_done(), 0U);
  EXPECT_THAT(job_status().message(), HasSubstr("unusable result"));
}

TEST_F(Attempts, numbers_that_are_no_numbers_make_an_unusable_result) {
  const double inf = std::numeric_limits<double>::infinity();
  wire::Envelope done = done_with("surface", held_.inputs(0).hash(), held_.inputs(0).size());
  for (const auto& [name, number] : {std::pair{"leaves", 1e300},
                                     {"estimated_elements", std::nan("")},
                                     {"elements", -inf},
                                     {"depth", -1e18},
                                     {"triangles", inf}}) {
    (*done.mutable_done()->mutable_numbers())[name] = number;
  }
  done.mutable_done()->set_seconds(-inf);
  done.mutable_done()->set_peak_rss_bytes(largest);
  EXPECT_TRUE(owner_.is_taken(done));
  EXPECT_EQ(job_status().state(), "failed");
}

TEST_F(Attempts, evidence_with_a_name_that_leads_out_is_kept_under_a_plain_one) {
  wire::Envelope failed = failed_message(held_.task(), held_.attempt());
  failed.mutable_failed()->set_exit_code(3);
  failed.mutable_failed()->set_cause(on_wire(FailureCause::for_good));
  failed.mutable_failed()->set_message("bad surface");
  wire::Artifact& evidence = *failed.mutable_failed()->add_evidence();
  evidence.set_name("../../../planted");
  evidence.set_hash(held_.inputs(0).hash());
  evidence.set_size(held_.inputs(0).size());
  EXPECT_TRUE(owner_.is_taken(failed));
  const wire::JobStatus status = job_status();
  for (const wire::Artifact& file : status.files()) {
    EXPECT_EQ(file.name().find('/'), std::string::npos) << file.name();
  }
  farm().ask({"wait", job(), "-o", "inner/out", "--store", "store", "--progress", "none"}, "anna");
  EXPECT_FALSE(std::filesystem::exists(farm().folder() / "planted"));
  EXPECT_FALSE(std::filesystem::exists(farm().folder().parent_path() / "planted"));
}

TEST_F(Attempts, a_false_tale_of_damage_removes_no_file) {
  const std::string hash = held_.inputs(0).hash();
  wire::Envelope failed = failed_message(held_.task(), held_.attempt());
  failed.mutable_failed()->set_cause(on_wire(FailureCause::damaged_input));
  failed.mutable_failed()->add_damaged_inputs(hash);
  failed.mutable_failed()->add_damaged_inputs(some_hash);
  failed.mutable_failed()->add_damaged_inputs("../../keys/coordinator.key");
  EXPECT_TRUE(owner_.is_taken(failed));
  bool is_there = false;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(farm().store() / "artifacts")) {
    is_there =
        is_there || file.path().filename().string().find(hash.substr(4)) != std::string::npos;
  }
  EXPECT_TRUE(is_there);
  EXPECT_TRUE(std::filesystem::exists(farm().keys_folder() / "coordinator.key"));
}

TEST_F(Attempts, exit_codes_and_times_out_of_range_end_nothing) {
  wire::Envelope failed = failed_message(held_.task(), held_.attempt());
  failed.mutable_failed()->set_exit_code(std::numeric_limits<std::int32_t>::min());
  failed.mutable_failed()->set_peak_rss_bytes(largest);
  failed.mutable_failed()->set_cause(on_wire(FailureCause::killed));
  EXPECT_TRUE(owner_.is_taken(failed));
  EXPECT_EQ(job_status().state(), "running");
}

TEST_F(Attempts, a_worker_that_claims_all_memory_and_all_time_is_one_worker) {
  const std::uint32_t workers = farm().status().workers();
  RawWorker boaster(farm(), farm().keys_of("spare"), "of the boaster");
  wire::Envelope hello = test::hello_of("of the boaster");
  hello.mutable_hello()->set_memory_bytes(largest);
  hello.mutable_hello()->set_pool_memory_bytes(largest);
  hello.mutable_hello()->set_ends_in_ms(largest);
  hello.mutable_hello()->set_cores(0xFFFFFFFFU);
  hello.mutable_hello()->set_process(std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(boaster.peer().ask(hello).has_welcome());
  EXPECT_EQ(farm().status().workers(), workers + 1);
  expect_untouched();
}

TEST_F(Attempts, a_hundred_hellos_over_one_connection_are_one_worker) {
  const std::uint32_t workers = farm().status().workers();
  RawWorker many(farm(), farm().keys_of("spare"), "many");
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(many.peer().ask(test::hello_of("nonce " + std::to_string(i))).has_welcome());
  }
  EXPECT_EQ(farm().status().workers(), workers + 1);
  expect_untouched();
}

TEST_F(Attempts, readiness_said_a_hundred_times_gives_one_task) {
  for (int i = 0; i < 100; ++i) owner_.peer().send(test::ready_message());
  for (int i = 0; i < 100; ++i) {
    const auto answer = owner_.peer().hear();
    ASSERT_TRUE(answer && answer->has_assign());
    EXPECT_EQ(answer->assign().attempt(), held_.attempt());
  }
  EXPECT_EQ(job_status().tasks_running(), 1U);
}

TEST_F(Attempts, before_its_hello_a_worker_may_only_be_told_to_say_it) {
  RawPeer rude = peer("spare");
  EXPECT_TRUE(rude.ask(test::ready_message()).refused().hello_again());
  EXPECT_TRUE(rude.ask(done_message(held_.task(), held_.attempt())).refused().hello_again());
  expect_untouched();
}

/// A farm of its own, with a small limit.
TEST(WorkerLimit, those_above_it_are_refused) {
  test::Farm farm({"--max-workers", "2"});
  RawWorker first(farm, farm.keys_of("node"), "first");
  RawWorker second(farm, farm.keys_of("node"), "second");
  RawPeer third(farm.endpoint(), farm.keys_of("spare"));
  EXPECT_THAT(third.ask(test::hello_of("third")).refused().reason(), HasSubstr("2 workers"));
  EXPECT_EQ(farm.status().workers(), 2U);
  EXPECT_EQ(farm.refused("too_many_workers"), 1U);
}

}  // namespace
}  // namespace tetfarm
