// Messages whose texts are too long, or would forge lines: what the coordinator makes of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/request_handler.h"
#include "coordinator/views/query_answers.h"
#include "proto/wire.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class HostileTexts : public testing::Test {
 protected:
  HostileTexts()
      : store_(folder_.path()),
        roots_({}, {folder_.path(), {}, {}, {}}),
        handler_(store_, roots_, {}, refusals_) {}

  /// The answer to a message of a peer without a key; without a body when there is none.
  wire::Envelope tell(const wire::Envelope& envelope) {
    handler_.handle({"peer", "", {}, ""}, encode(envelope), state_, now_);
    state_.tick(now_);
    handler_.carry_out(state_, now_);
    const std::vector<Reply> replies = handler_.take_replies();
    return replies.empty() ? wire::Envelope{} : replies.back().envelope;
  }
  wire::Envelope submission(const std::string& name) {
    const StoredArtifact surface = store_.publish("a surface");
    wire::Envelope envelope;
    wire::Submit& submit = *envelope.mutable_submit();
    submit.set_job_toml("[geometry]\nsurface = \"a.stl\"\n");
    submit.set_name(name);
    submit.add_inputs()->set_name("input_surface");
    submit.mutable_inputs(0)->set_hash(surface.hash);
    submit.mutable_inputs(0)->set_size(surface.size);
    return envelope;
  }

  /// What a worker of its own is given of a job of its own.
  wire::Assign take_task() {
    tell(submission("wing"));
    wire::Envelope hello;
    hello.mutable_hello()->set_nonce("nonce");
    hello.mutable_hello()->set_host("host");
    tell(hello);
    wire::Envelope ready;
    ready.mutable_ready();
    return tell(ready).assign();
  }

  TempFolder folder_;
  ArtifactStore store_;
  SurfaceRoots roots_;
  Refusals refusals_;
  RequestHandler handler_;
  Moment now_{1000, 1000};
  JobState state_{{}, {}, [](const ArtifactRef&) { return true; }, now_};
};

TEST_F(HostileTexts, good_names_are_taken) {
  EXPECT_EQ(tell(submission("Flügel 2")).submitted().job(), "job-1");
}

TEST_F(HostileTexts, bad_names_are_refused_and_leave_no_job) {
  for (const std::string& name :
       {std::string("../../x"), std::string("a\n[info] all is well"), std::string("\x1b[2J"),
        std::string("\xff\xfe"), std::string(15'000'000, 'n')}) {
    const wire::Envelope answer = tell(submission(name));
    ASSERT_TRUE(answer.has_refused());
    EXPECT_EQ(answer.refused().exit_code(), 2);
    EXPECT_LT(answer.refused().reason().size(), 200U);
  }
  EXPECT_TRUE(state_.durable().jobs.empty());
  EXPECT_EQ(refusals_.of(Refusal::too_large), 1U);
}

TEST_F(HostileTexts, an_unreadable_job_file_is_refused_and_leaves_no_job) {
  wire::Envelope envelope = submission("wing");
  std::string key = "a";
  for (int i = 0; i < 120'000; ++i) key += ".a";
  envelope.mutable_submit()->set_job_toml(key + " = 1\n");
  const wire::Envelope answer = tell(envelope);
  EXPECT_THAT(answer.refused().reason(), HasSubstr("job.toml:1:32"));
  EXPECT_EQ(answer.refused().exit_code(), 2);
  EXPECT_TRUE(state_.durable().jobs.empty());
}

TEST_F(HostileTexts, a_worker_with_an_endless_host_is_refused) {
  wire::Envelope envelope;
  envelope.mutable_hello()->set_nonce("nonce");
  envelope.mutable_hello()->set_host(std::string(1'000'000, 'h'));
  EXPECT_THAT(tell(envelope).refused().reason(), HasSubstr("Hello.host has 1000000 bytes"));
  EXPECT_EQ(state_.worker_count(), 0U);
}

TEST_F(HostileTexts, a_worker_s_words_are_cut_not_refused) {
  const wire::Assign assign = take_task();
  ASSERT_NE(assign.attempt(), 0U);
  wire::Envelope failed;
  failed.mutable_failed()->set_task(assign.task());
  failed.mutable_failed()->set_attempt(assign.attempt());
  failed.mutable_failed()->set_message(std::string(1'000'000, 'm'));
  failed.mutable_failed()->set_log(std::string(1'000'000, 'l'));
  EXPECT_TRUE(tell(failed).accepted().taken());
  EXPECT_EQ(state_.durable().tasks.begin()->second.message.size(), 4096U);
}

TEST_F(HostileTexts, what_a_worker_says_of_its_work_is_made_harmless) {
  const wire::Assign assign = take_task();
  const auto say = [&](const std::string& stage, std::uint64_t done, std::uint64_t total) {
    wire::Envelope beat;
    beat.mutable_heartbeat()->set_task(assign.task());
    beat.mutable_heartbeat()->set_attempt(assign.attempt());
    wire::Doing& doing = *beat.mutable_heartbeat()->mutable_doing();
    doing.set_stage(stage);
    doing.set_done(done);
    doing.set_total(total);
    tell(beat);
    return answer_status({}, state_, now_).jobs(0).running(0);
  };
  for (const std::string& stage : {std::string(), std::string("\x1b[2J"), std::string("polish"),
                                   std::string(1'000'000, 's')}) {
    EXPECT_FALSE(say(stage, 1, 2).has_doing());
  }
  EXPECT_EQ(say("check", ~std::uint64_t{0}, 7).doing().done(), 7U);
  EXPECT_EQ(say("check", 3, 7).doing().done(), 7U) << "it does not fall";
  EXPECT_EQ(say("check", 3, 1).doing().total(), 7U);
  EXPECT_EQ(say("polish", 3, 1).doing().stage(), "check");
  EXPECT_EQ(refusals_.total(), 0U);
}

TEST_F(HostileTexts, a_heartbeat_is_answered_without_what_it_said) {
  const wire::Assign assign = take_task();
  now_.steady_ms += 5000;
  wire::Envelope beat;
  beat.mutable_heartbeat()->set_task(assign.task());
  beat.mutable_heartbeat()->set_attempt(assign.attempt());
  beat.mutable_heartbeat()->mutable_doing()->set_stage("check");
  const wire::Envelope answer = tell(beat);
  ASSERT_TRUE(answer.has_heartbeat());
  EXPECT_FALSE(answer.heartbeat().has_doing());
  EXPECT_EQ(answer.heartbeat().attempt(), assign.attempt());
}

}  // namespace
}  // namespace tetfarm
