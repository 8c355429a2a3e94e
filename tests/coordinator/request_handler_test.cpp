#include "coordinator/request_handler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "proto/wire.h"
#include "tests/coordinator/store_messages.h"

namespace tetfarm {
namespace {

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

}  // namespace
}  // namespace tetfarm
