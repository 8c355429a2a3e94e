#include "coordinator/decisions/leases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::int64_t lease_ms = 1000;

AttemptRow attempt_of(std::uint64_t number, const char* nonce) {
  AttemptRow attempt;
  attempt.id = AttemptId{number};
  attempt.nonce_hash = nonce;
  return attempt;
}

std::map<AttemptId, AttemptRow> running(const std::vector<AttemptRow>& attempts) {
  std::map<AttemptId, AttemptRow> rows;
  for (const AttemptRow& attempt : attempts) rows[attempt.id] = attempt;
  return rows;
}

TEST(Leases, run_out_a_term_after_the_last_renewal) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, "a"), 0);
  leases.begin(attempt_of(2, "b"), 0);
  leases.renew(AttemptId{2}, 500);
  EXPECT_THAT(leases.run_out(lease_ms), IsEmpty()) << "on the last millisecond it still holds";
  EXPECT_THAT(leases.run_out(lease_ms + 1), ElementsAre(AttemptId{1}));
  EXPECT_THAT(leases.run_out(lease_ms + 501), ElementsAre(AttemptId{1}, AttemptId{2}));
  EXPECT_EQ(leases.first_end_ms(), lease_ms);
}

TEST(Leases, a_renewal_does_not_change_when_the_attempt_began) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, "a"), 40);
  leases.renew(AttemptId{1}, 900);
  EXPECT_EQ(leases.started_ms(AttemptId{1}), 40);
}

TEST(Leases, where_nothing_runs_none_ends) { EXPECT_FALSE(Leases(lease_ms).first_end_ms()); }

TEST(Leases, a_process_is_found_by_key_and_nonce_together) {
  Leases leases(lease_ms);
  AttemptRow attempt = attempt_of(1, "a");
  attempt.key = "key";
  leases.begin(attempt, 0);
  EXPECT_EQ(leases.held_by({"key", "a"}), AttemptId{1});
  EXPECT_FALSE(leases.held_by({"", "a"}));
  EXPECT_FALSE(leases.held_by({"key", ""}));
  leases.end(attempt);
  EXPECT_FALSE(leases.held_by({"key", "a"}));
}

TEST(Leases, one_without_a_nonce_is_held_by_nobody_that_could_be_found) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, ""), 0);
  leases.begin(attempt_of(2, ""), 0);
  EXPECT_FALSE(leases.held_by({}));
  EXPECT_THAT(leases.validate(running({attempt_of(1, ""), attempt_of(2, "")})), IsEmpty());
}

TEST(Leases, what_was_heard_of_an_attempt_is_forgotten_with_it) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, "a"), 0);
  EXPECT_EQ(leases.work_of(AttemptId{1}), nullptr);
  leases.note_work(AttemptId{1}, {WorkStage::edges, 0, 1, 2}, 0.5);
  ASSERT_NE(leases.work_of(AttemptId{1}), nullptr);
  EXPECT_EQ(leases.work_of(AttemptId{1})->share(), 0.5);
  leases.end(attempt_of(1, "a"));
  EXPECT_EQ(leases.work_of(AttemptId{1}), nullptr);
  EXPECT_FALSE(leases.has(AttemptId{1}));
}

TEST(Leases, one_that_ends_twice_or_begins_twice_is_a_mistake_of_our_own) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, "a"), 0);
  EXPECT_DEATH(leases.begin(attempt_of(1, "a"), 0), "");
  leases.end(attempt_of(1, "a"));
  EXPECT_DEATH(leases.end(attempt_of(1, "a")), "");
}

TEST(Leases, broken_invariants_are_told) {
  Leases leases(lease_ms);
  leases.begin(attempt_of(1, "a"), 0);
  EXPECT_THAT(leases.validate(running({attempt_of(1, "a")})), IsEmpty());
  EXPECT_THAT(leases.validate({}), ElementsAre("a process holds what it does not run",
                                               "the lease of attempt 1, which does not run"));
  EXPECT_THAT(
      leases.validate(running({attempt_of(1, "a"), attempt_of(2, "a")})),
      ElementsAre("attempt 2 runs without a lease", "attempt 2 runs in a process with another"));
}

}  // namespace
}  // namespace tetfarm
