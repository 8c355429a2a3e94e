#include "coordinator/views/store_at_rest.h"

#include <gtest/gtest.h>

#include "base/error.h"
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

TEST_F(StoreOfTheDead, answers_as_a_coordinator_would_but_for_what_runs) {
  const StoreAtRest store(folder_.path(), folder_.path());
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  EXPECT_EQ(store.answer(query).jobs(0).state(), "stopped");
  EXPECT_EQ(store.answer(query).jobs(0).tasks_ready(), 1U);
  query.set_subject(wire::Query::TASKS);
  EXPECT_EQ(store.answer(query).tasks(0).state(), "ready");
  query.set_subject(wire::Query::EVENTS);
  EXPECT_GT(store.answer(query).events_size(), 0);
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(1);
  const wire::Explanation told = store.answer(query).explanation();
  ASSERT_EQ(told.inputs_size(), 2);
  EXPECT_TRUE(told.inputs(0).is_there()) << "it is in the store";
  std::filesystem::remove_all(folder_.path() / "artifacts");
  EXPECT_FALSE(store.answer(query).explanation().inputs(0).is_there());
}

TEST_F(StoreOfTheDead, tells_every_job_however_many_pages_they_are) {
  {
    JobDatabase database(folder_.path() / "tetfarm.db");
    ChangeSet changes;
    for (std::uint64_t i = 2; i <= 61; ++i) {
      changes.jobs.push_back({JobId{i}, "", std::string(100'000, 'x'), "",
                              i % 2 == 0 ? JobPhase::running : JobPhase::cancelled, 0, "", 1, 2});
    }
    database.apply(changes);
  }
  const StoreAtRest store(folder_.path(), folder_.path());
  const wire::StatusReply all = store.status("");
  ASSERT_EQ(all.jobs_size(), 61);
  EXPECT_EQ(all.next(), 0U);
  for (int i = 0; i < 61; ++i) {
    EXPECT_EQ(all.jobs(i).job(), "job-" + std::to_string(i + 1));
    EXPECT_EQ(all.jobs(i).state(), i == 0 || i % 2 == 1 ? "stopped" : "cancelled") << i;
  }
  const wire::StatusReply one = store.status("job-60");
  ASSERT_EQ(one.jobs_size(), 1);
  EXPECT_EQ(one.jobs(0).job(), "job-60");
}

TEST(StoreAtRestFolder, has_to_be_a_store_with_a_database) {
  const TempFolder folder;
  const auto code_of = [&folder] {
    try {
      const StoreAtRest store(folder.path(), folder.path());
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::ok;
  };
  EXPECT_EQ(code_of(), ExitCode::not_found) << "no store";
  const ArtifactStore store(folder.path());
  EXPECT_EQ(code_of(), ExitCode::not_found) << "no database";
  { const JobDatabase database(folder.path() / "tetfarm.db"); }
  EXPECT_EQ(code_of(), ExitCode::ok);
}

}  // namespace
}  // namespace tetfarm
