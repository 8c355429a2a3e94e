#include "coordinator/views/store_at_rest.h"

#include <gtest/gtest.h>

#include "coordinator/decisions/job_state.h"
#include "store/artifact_store.h"
#include "store/folder_lock.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// A store whose coordinator has died while a worker had the only task of a job.
class StoreOfTheDead : public testing::Test {
 protected:
  StoreOfTheDead() {
    JobDatabase database(folder_.path() / "tetfarm.db");
    JobState state(
        {}, {}, [](const ArtifactRef&) { return true; }, now_);
    Submission submission;
    submission.name = "wing";
    submission.given = {
        {job_file_.hash, job_file_.size}, TaskFile{surface_.hash, surface_.size}, std::nullopt};
    state.submit(submission, now_);
    WorkerInfo info;
    info.host = "host";
    info.nonce = "nonce";
    info.memory_bytes = 1U << 30U;
    state.worker_is_ready(state.add_worker(info, {}, {}, now_), now_);
    state.tick(now_);
    database.apply(state.take_changes());
  }
  wire::JobStatus status() const {
    const wire::StatusReply reply = StoreAtRest(folder_.path(), folder_.path()).status("");
    EXPECT_EQ(reply.jobs_size(), 1);
    return reply.jobs(0);
  }
  std::string state_of_task() const {
    wire::Query query;
    query.set_subject(wire::Query::EXPLAIN);
    query.set_task(1);
    return StoreAtRest(folder_.path(), folder_.path()).answer(query).explanation().task().state();
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  StoredArtifact job_file_ = store_.publish("a job");
  StoredArtifact surface_ = store_.publish("a surface");
  Moment now_{5000, 5000};
};

TEST_F(StoreOfTheDead, has_stopped_jobs_whose_tasks_under_way_are_to_be_done_again) {
  const wire::JobStatus job = status();
  EXPECT_EQ(job.state(), "stopped");
  EXPECT_EQ(job.tasks_running(), 0U);
  EXPECT_EQ(job.tasks_ready(), 1U);
  EXPECT_EQ(state_of_task(), "ready");
}

TEST_F(StoreOfTheDead, is_told_as_it_was_while_somebody_may_still_serve_it) {
  const FolderLock lock = FolderLock::of_store(folder_.path());
  const wire::JobStatus job = status();
  EXPECT_EQ(job.state(), "running");
  EXPECT_EQ(job.tasks_running(), 1U);
  EXPECT_EQ(job.tasks_ready(), 0U);
  EXPECT_EQ(state_of_task(), "leased");
}

}  // namespace
}  // namespace tetfarm
