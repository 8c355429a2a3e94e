#include "coordinator/damage_checks.h"
#include "tasks/failure_cause.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using Verdict = CheckedFile::Verdict;

class DamageChecksTest : public testing::Test {
 protected:
  void say(WorkerId worker) {
    TaskFailure failure;
    failure.cause = FailureCause::damaged_input;
    checks_.take({worker, TaskId{3}, attempt_, failure}, files_);
  }
  std::optional<DamageChecks::Failure> note(const ArtifactRef& file, Verdict verdict) {
    return checks_.note({attempt_, file.hash, verdict});
  }

  const AttemptId attempt_{7};
  const std::vector<ArtifactRef> files_ = {{"mesh", "a", 10}, {"cut", "b", 20}, {"again", "a", 10}};
  DamageChecks checks_;
};

TEST_F(DamageChecksTest, the_failure_comes_back_with_the_damaged_ones_when_all_were_looked_at) {
  say(WorkerId{1});
  const std::vector<FileOrder> orders = checks_.take_orders();
  ASSERT_THAT(orders, SizeIs(2)) << "a file of two names is looked at once";
  EXPECT_EQ(orders[1].file, (StoredArtifact{"b", 20}));
  EXPECT_FALSE(note(files_[0], Verdict::damaged));
  EXPECT_FALSE(note(files_[0], Verdict::damaged)) << "the other one is not known yet";
  const auto failure = note(files_[1], Verdict::sound);
  ASSERT_TRUE(failure);
  EXPECT_THAT(failure->what.damaged_inputs, ElementsAre("a"));
  EXPECT_EQ(failure->what.cause, FailureCause::damaged_input);
}

TEST_F(DamageChecksTest, where_all_are_sound_the_attempt_is_as_a_killed_one) {
  say(WorkerId{1});
  note(files_[0], Verdict::sound);
  const auto failure = note(files_[1], Verdict::sound);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->what.cause, FailureCause::killed);
  EXPECT_THAT(failure->what.damaged_inputs, IsEmpty());
}

TEST_F(DamageChecksTest, said_again_nothing_is_looked_at_twice_and_the_last_speaker_is_answered) {
  say(WorkerId{1});
  EXPECT_THAT(checks_.take_orders(), SizeIs(2));
  say(WorkerId{2});
  EXPECT_THAT(checks_.take_orders(), IsEmpty());
  note(files_[0], Verdict::damaged);
  EXPECT_EQ(note(files_[1], Verdict::damaged)->worker, WorkerId{2});
}

TEST_F(DamageChecksTest, what_could_not_be_put_aside_is_tried_again_when_it_is_said_again) {
  say(WorkerId{1});
  checks_.take_orders();
  EXPECT_FALSE(note(files_[0], Verdict::unknown));
  EXPECT_FALSE(note(files_[1], Verdict::damaged));
  say(WorkerId{1});
  EXPECT_THAT(checks_.take_orders(), SizeIs(2));
}

TEST_F(DamageChecksTest, after_it_forgot_who_speaks_old_answers_mean_nothing) {
  say(WorkerId{1});
  checks_.forget();
  EXPECT_THAT(checks_.take_orders(), IsEmpty());
  EXPECT_FALSE(note(files_[0], Verdict::damaged));
}

}  // namespace
}  // namespace tetfarm
