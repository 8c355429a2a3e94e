#include "coordinator/decisions/worker_sessions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr WorkerId first{1};
constexpr WorkerId second{2};
constexpr AttemptId attempt{7};

WorkerRow row_of(WorkerId id, const char* host, std::uint64_t memory_bytes) {
  WorkerRow row;
  row.id = id;
  row.host = host;
  row.memory_bytes = memory_bytes;
  return row;
}

SessionTerms terms_of(const char* nonce) {
  SessionTerms terms;
  terms.process = {"key", nonce};
  return terms;
}

WorkerSessions one_worker() {
  WorkerSessions workers;
  workers.arrive(row_of(first, "node-1", 100), 100);
  workers.introduce(first, terms_of("a"), 0);
  return workers;
}

AttemptRow attempt_of(WorkerId worker, const char* nonce, std::uint64_t memory_bytes) {
  AttemptRow row;
  row.id = attempt;
  row.worker = worker;
  row.host = "node-1";
  row.key = "key";
  row.nonce_hash = nonce;
  row.memory_bytes = memory_bytes;
  return row;
}

TEST(WorkerSessions, a_process_that_connects_anew_takes_the_seat_of_its_earlier_connection) {
  WorkerSessions workers = one_worker();
  EXPECT_FALSE(workers.take_seat(first));
  EXPECT_FALSE(workers.take_seat(first)) << "it is its own already";
  workers.arrive(row_of(second, "node-1", 100), 100);
  workers.introduce(second, terms_of("a"), 0);
  EXPECT_EQ(workers.take_seat(second), first);
  workers.leave(first);
  EXPECT_THAT(workers.validate({}), IsEmpty());
  workers.arrive(row_of(WorkerId{3}, "node-1", 100), 100);
  workers.introduce(WorkerId{3}, terms_of("a"), 0);
  EXPECT_EQ(workers.take_seat(WorkerId{3}), second) << "the seat was the newer one's";
}

TEST(WorkerSessions, another_process_on_the_same_connection_leaves_the_seat_free) {
  WorkerSessions workers = one_worker();
  workers.take_seat(first);
  workers.introduce(first, terms_of("b"), 0);
  EXPECT_THAT(workers.validate({}), IsEmpty());
  workers.arrive(row_of(second, "node-1", 100), 100);
  workers.introduce(second, terms_of("a"), 0);
  EXPECT_FALSE(workers.take_seat(second));
}

TEST(WorkerSessions, who_works_drains_or_has_left_waits_for_no_task) {
  WorkerSessions workers = one_worker();
  workers.wait(first);
  EXPECT_THAT(workers.idle(), ElementsAre(first));
  workers.hold(first, attempt);
  EXPECT_THAT(workers.idle(), IsEmpty());
  workers.let_go(first, attempt);
  workers.wait(first);
  workers.drain(first);
  EXPECT_THAT(workers.idle(), IsEmpty());
  workers.arrive(row_of(second, "node-2", 50), 50);
  workers.wait(second);
  EXPECT_EQ(workers.leave(second).host, "node-2");
  EXPECT_THAT(workers.idle(), IsEmpty());
}

TEST(WorkerSessions, a_worker_lets_go_only_of_what_it_holds) {
  WorkerSessions workers = one_worker();
  workers.hold(first, attempt);
  workers.let_go(first, AttemptId{8});
  workers.let_go(second, attempt);
  EXPECT_EQ(workers.at(first).attempt, attempt);
  EXPECT_DEATH(workers.leave(first), "");
  workers.let_go(first, attempt);
  EXPECT_FALSE(workers.at(first).attempt);
}

TEST(WorkerSessions, the_silent_ones_are_found) {
  WorkerSessions workers = one_worker();
  EXPECT_FALSE(WorkerSessions().longest_silent_ms());
  workers.arrive(row_of(second, "node-2", 50), 50);
  workers.hear(first, 100);
  workers.hear(second, 200);
  EXPECT_EQ(workers.longest_silent_ms(), 100);
  EXPECT_THAT(workers.silent_since(100), IsEmpty());
  EXPECT_THAT(workers.silent_since(101), ElementsAre(first));
}

TEST(WorkerSessions, the_largest_memory_is_that_of_those_here_or_of_their_pools) {
  WorkerSessions workers = one_worker();
  EXPECT_EQ(WorkerSessions().largest_memory(), 0U);
  workers.arrive(row_of(second, "node-2", 50), 500);
  EXPECT_EQ(workers.largest_memory(), 500U);
  workers.leave(second);
  EXPECT_EQ(workers.largest_memory(), 100U);
}

TEST(WorkerSessions, workers_of_a_host_share_its_memory_unless_it_is_their_own) {
  WorkerSessions workers = one_worker();
  workers.arrive(row_of(second, "node-1", 100), 100);
  SessionTerms terms = terms_of("b");
  terms.shares_memory = false;
  workers.introduce(second, terms, 0);
  const auto used = workers.used_memory({{attempt, attempt_of(first, "a", 30)}});
  EXPECT_EQ(workers.free_memory(first, used), 70U);
  EXPECT_EQ(workers.free_memory(second, used), 100U);
  EXPECT_THAT(workers.used_memory({{attempt, attempt_of(second, "b", 30)}}), IsEmpty());
  EXPECT_EQ(workers.used_memory({{attempt, attempt_of(WorkerId{9}, "c", 30)}}).at("node-1"), 30U)
      << "of a worker that has not come back";
  EXPECT_EQ(workers.free_memory(first, {{"node-1", 300}}), 0U);
}

TEST(WorkerSessions, broken_invariants_are_told) {
  WorkerSessions workers = one_worker();
  workers.hold(first, attempt);
  EXPECT_THAT(workers.validate({{attempt, attempt_of(first, "a", 0)}}), IsEmpty());
  EXPECT_THAT(workers.validate({}), ElementsAre("worker 1 holds what is not its own"));
  EXPECT_THAT(workers.validate({{attempt, attempt_of(second, "a", 0)}}),
              ElementsAre("worker 1 holds what is not its own"));
  EXPECT_THAT(workers.validate({{attempt, attempt_of(first, "b", 0)}}),
              ElementsAre("worker 1 holds another process's attempt"));
  workers.wait(first);
  workers.wait(second);
  EXPECT_THAT(workers.validate({{attempt, attempt_of(first, "a", 0)}}),
              ElementsAre("worker 1 is idle and works", "worker 2 is idle and gone"));
}

}  // namespace
}  // namespace tetfarm
