#include "cli/watched_farm.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/clock.h"
#include "base/error.h"
#include "store/artifact_store.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/fake_coordinator.h"

namespace tetfarm {
namespace {

/// A coordinator that is silent, or has one job and does as it is told.
class WatchedCoordinator : public ::testing::Test {
 protected:
  ViewOptions options(double timeout_s) const {
    ViewOptions options;
    options.client.endpoint = coordinator_.endpoint();
    options.client.timeout_s = timeout_s;
    return options;
  }

  std::atomic<bool> is_silent_ = false;
  FakeCoordinator coordinator_{[this](const wire::Envelope& said) {
    wire::Envelope answer;
    if (is_silent_) return std::vector<wire::Envelope>{};
    if (said.has_query()) {
      answer.mutable_query_reply()->add_jobs()->set_job("job-77");
    } else if (said.has_cancel()) {
      answer.mutable_cancelled()->set_found(said.cancel().job() == "job-77");
    } else if (said.has_retry()) {
      answer.mutable_retried()->set_count(said.retry().task());
    } else if (said.has_drain_workers()) {
      answer.mutable_draining()->set_count(said.drain_workers().worker());
    } else {
      answer.mutable_status_reply()->set_workers(3);
      if (!said.status_request().farm_only()) answer.mutable_status_reply()->add_jobs();
    }
    return std::vector<wire::Envelope>{answer};
  }};
};

TEST_F(WatchedCoordinator, is_asked_and_told_over_one_connection) {
  WatchedFarm farm(options(10));
  EXPECT_EQ(farm.farm().workers(), 3U);
  EXPECT_EQ(farm.farm().jobs_size(), 0);
  EXPECT_EQ(farm.job("job-77").jobs_size(), 1);
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  EXPECT_EQ(farm.page(query).jobs(0).job(), "job-77");
  EXPECT_TRUE(farm.cancel("job-77"));
  EXPECT_FALSE(farm.cancel("job-1"));
  wire::Retry retry;
  retry.set_task(4);
  EXPECT_EQ(farm.retry(retry), 4U);
  EXPECT_EQ(farm.drain(5), 5U);
  EXPECT_EQ(farm.endpoint(), coordinator_.endpoint());
  EXPECT_FALSE(farm.is_at_rest());
}

TEST_F(WatchedCoordinator, is_waited_for_longer_than_one_slice) {
  is_silent_ = true;
  WatchedFarm farm(options(20));
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
    is_silent_ = false;
  });
  EXPECT_EQ(farm.farm().workers(), 3U);
  later.join();
}

TEST_F(WatchedCoordinator, that_is_silent_for_too_long_does_not_answer_and_may_later) {
  is_silent_ = true;
  WatchedFarm farm(options(0.2));
  EXPECT_THROW(farm.farm(), NoAnswer);
  is_silent_ = false;
  EXPECT_EQ(farm.farm().workers(), 3U);
}

TEST_F(WatchedCoordinator, holds_nobody_up_who_gives_up) {
  is_silent_ = true;
  WatchedFarm farm(options(600));
  const std::int64_t begin = steady_ms();
  std::thread giving_up([&] { farm.give_up(); });
  EXPECT_THROW(farm.farm(), NoAnswer);
  giving_up.join();
  EXPECT_LT(steady_ms() - begin, 10'000);
}

TEST_F(WatchedCoordinator, shows_files_of_the_store_that_is_named_and_no_others) {
  const TempFolder folder;
  const ArtifactStore store(folder.path() / "store");
  const StoredArtifact there = store.publish("a sub-domain");
  ViewOptions seeing = options(10);
  seeing.store = store.folder().string();
  WatchedFarm farm(seeing);
  EXPECT_TRUE(farm.sees_files());
  wire::Artifact file;
  file.set_hash(there.hash);
  file.set_size(there.size);
  EXPECT_EQ(farm.find_file(file), store.path_of(there.hash));
  file.set_size(there.size + 1);
  EXPECT_EQ(farm.find_file(file), std::nullopt);
  for (const char* hash : {"", "../../store_id", "/etc/passwd", "..", "a/b"}) {
    file.set_hash(hash);
    EXPECT_EQ(farm.find_file(file), std::nullopt) << hash;
  }
  file.set_hash(there.hash);
  file.set_size(there.size);
  WatchedFarm blind(options(10));
  EXPECT_FALSE(blind.sees_files());
  EXPECT_EQ(blind.find_file(file), std::nullopt);
}

}  // namespace
}  // namespace tetfarm
