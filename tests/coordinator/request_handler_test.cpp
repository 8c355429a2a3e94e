#include "coordinator/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tetfarm
