#include "cli/stopped_run.h"

#include <gmock/gmock.h>

#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

TEST(StoppedRun, without_a_task_under_way_loses_nothing) {
  EXPECT_EQ(stopped_text({"job-1", 3, {}}),
            "stopped at a checkpoint: 3 finished tasks are kept, no work is lost\n");
  EXPECT_THAT(stopped_text({"job-1", 0, {}}), HasSubstr("no task had finished yet"));
  EXPECT_THAT(stopped_text({}), HasSubstr("nothing was running"));
}

TEST(StoppedRun, names_the_tasks_whose_work_is_lost) {
  const StoppedRun stopped{"job-1", 1, {{2, "mesh", 1, 12.34}, {9, "cosmetic", 6, 0.5}}};
  EXPECT_EQ(stopped_text(stopped),
            "stopped at a checkpoint: 1 finished task is kept\n"
            "lost, to be done again from the start: mesh of the whole domain, 12.3 s of work; "
            "cosmetic of sub-domain RL, 0.5 s of work\n");
  EXPECT_EQ(stopped_json(stopped),
            R"({"type":"stopped","job":"job-1","tasks_done":1,"tasks_lost":[)"
            R"({"task":2,"kind":"mesh","path":1,"seconds":12.34},)"
            R"({"task":9,"kind":"cosmetic","path":6,"seconds":0.5}],"exit_code":75})");
}

TEST(StoppedRun, of_many_lost_tasks_names_a_few) {
  StoppedRun stopped{"job-1", 0, {}};
  for (std::uint64_t task = 1; task <= 40; ++task) stopped.lost.push_back({task, "write", task, 1});
  EXPECT_THAT(stopped_text(stopped), HasSubstr("; and 35 more\n"));
}

TEST(StoppedRun, knows_the_tasks_under_way_once_each) {
  wire::StatusReply farm;
  for (const std::uint64_t task : {7, 0, 3, 7}) farm.add_at_work()->set_task(task);
  EXPECT_EQ(tasks_under_way(farm), (std::vector<std::uint64_t>{3, 7}));
}

TEST(StoppedRun, of_six_lost_tasks_names_five) {
  StoppedRun stopped{"job-1", 0, {}};
  for (std::uint64_t task = 1; task <= 5; ++task) stopped.lost.push_back({task, "write", 0, 1});
  EXPECT_EQ(stopped_text(stopped).find("more"), std::string::npos);
  stopped.lost.push_back({6, "mesh", 0, 1});
  const std::string text = stopped_text(stopped);
  EXPECT_THAT(text, HasSubstr("write, 1.0 s of work; and 1 more\n"));
  EXPECT_EQ(text.find("mesh"), std::string::npos);
}

TaskRow task_row(std::uint64_t id, TaskState state) {
  TaskRow task;
  task.id = TaskId{id};
  task.job = JobId{1};
  task.kind = TaskKind::mesh;
  task.path = id + 3;
  task.state = state;
  task.attempt = AttemptId{id};
  return task;
}

AttemptRow attempt_row(std::uint64_t id, std::uint64_t task, std::int64_t from_ms,
                       std::int64_t to_ms) {
  AttemptRow attempt;
  attempt.id = AttemptId{id};
  attempt.task = TaskId{task};
  attempt.worker = WorkerId{1};
  attempt.state = AttemptState::lost;
  attempt.started_ms = from_ms;
  attempt.ended_ms = to_ms;
  return attempt;
}

/// A run whose tasks are done, lost, and replaced.
class RowsOfAStoppedRun : public ::testing::Test {
 protected:
  RowsOfAStoppedRun() {
    ChangeSet changes;
    JobRow job;
    job.id = JobId{1};
    job.name = "wing";
    changes.jobs = {job};
    WorkerRow worker;
    worker.id = WorkerId{1};
    changes.workers = {worker};
    for (std::uint64_t path = 1; path <= 8; ++path) {
      SubdomainRow subdomain;
      subdomain.job = job.id;
      subdomain.path = path;
      subdomain.hash = std::string(32, 'a');
      subdomain.state = path < 4 ? SubdomainState::cut : SubdomainState::leaf;
      changes.subdomains.push_back(subdomain);
    }
    changes.tasks = {task_row(1, TaskState::done), task_row(2, TaskState::ready),
                     task_row(3, TaskState::replaced), task_row(4, TaskState::ready),
                     task_row(5, TaskState::done)};
    changes.attempts = {attempt_row(2, 2, 1000, 1900), attempt_row(7, 2, 2000, 4500)};
    JobDatabase(folder_.path() / "tetfarm.db").apply(changes);
  }
  StoppedRun stopped(const std::string& job, const std::vector<std::uint64_t>& under_way) const {
    return stopped_run(folder_.path(), folder_.path(), job, under_way);
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path()};
};

TEST_F(RowsOfAStoppedRun, have_lost_what_was_under_way_and_is_not_done) {
  const StoppedRun run = stopped("job-1", {1, 2, 3, 4});
  EXPECT_EQ(run.job, "job-1");
  EXPECT_EQ(run.tasks_done, 2U);
  ASSERT_EQ(run.lost.size(), 2U);
  EXPECT_EQ(run.lost[0].task, 2U);
  EXPECT_EQ(run.lost[0].kind, "mesh");
  EXPECT_EQ(run.lost[0].path, 5U);
  EXPECT_EQ(run.lost[0].seconds, 2.5) << "of its last attempt";
  EXPECT_EQ(run.lost[1].task, 4U);
  EXPECT_EQ(run.lost[1].seconds, 0) << "it had no attempt";
}

TEST_F(RowsOfAStoppedRun, are_not_read_before_there_is_a_job) {
  const StoppedRun run = stopped("", {2});
  EXPECT_EQ(run.job, "");
  EXPECT_EQ(run.tasks_done, 0U);
  EXPECT_TRUE(run.lost.empty());
}

}  // namespace
}  // namespace tetfarm
