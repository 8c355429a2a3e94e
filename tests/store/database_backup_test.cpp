#include "store/database_backup.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "store/job_database.h"
#include "store/sqlite_statement.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

ChangeSet job_of(std::uint64_t id, const std::string& name) {
  ChangeSet changes;
  JobRow job;
  job.id = JobId{id};
  job.name = name;
  changes.jobs = {job};
  TaskRow task;
  task.id = TaskId{id};
  task.job = job.id;
  changes.tasks = {task};
  changes.workers = {{WorkerId{1}, "host", 7, 4, 1U << 30U, "0.1", 6, false}};
  AttemptRow attempt;
  attempt.id = AttemptId{id};
  attempt.task = task.id;
  attempt.worker = WorkerId{1};
  attempt.state = AttemptState::done;
  changes.attempts = {attempt};
  return changes;
}

TEST(DatabaseBackup, holds_whole_transactions_while_others_write) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  JobDatabase database(path);
  database.apply(job_of(1, "0"));
  std::atomic<bool> stop = false;
  std::int64_t written = 0;
  for (int round = 0; round < 5; ++round) {
    stop = false;
    std::thread reader([&] {
      back_up_database(path, folder.path() / "copy");
      stop = true;
    });
    while (!stop) {
      ChangeSet changes = job_of(1, std::to_string(++written));
      changes.jobs[0].finished_ms = written;
      changes.attempts.clear();
      database.apply(changes);
    }
    reader.join();
    const JobRow job = JobDatabase::open_to_read(folder.path() / "copy").load().jobs.at(JobId{1});
    EXPECT_EQ(job.name, std::to_string(job.finished_ms));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "copy-wal"));
}

TEST(DatabaseBackup, restored_is_as_it_was_and_keeps_what_was_there) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  JobDatabase(path).apply(job_of(1, "wing"));
  back_up_database(path, folder.path() / "copy");
  JobDatabase(path).apply(job_of(2, "a later job"));
  const std::filesystem::path kept = restore_database(folder.path() / "copy", path, 77);
  EXPECT_EQ(kept.filename(), "tetfarm.db.before-restore-77");
  const JobDatabase restored(path);
  EXPECT_EQ(restored.load().jobs.size(), 1U);
  EXPECT_EQ(restored.load().jobs.at(JobId{1}).name, "wing");
  EXPECT_TRUE(restored.damage().empty());
  EXPECT_EQ(JobDatabase::open_to_read(kept).load().jobs.size(), 2U);
}

TEST(DatabaseBackup, attempts_of_the_time_that_is_undone_are_not_given_out_again) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  JobDatabase(path).apply(job_of(1, "wing"));
  back_up_database(path, folder.path() / "copy");
  JobDatabase(path).apply(job_of(500, "later"));
  restore_database(folder.path() / "copy", path, 77);
  EXPECT_GT(JobDatabase(path).load().last_attempt, 500U);
}

TEST(DatabaseBackup, is_brought_up_from_an_older_schema_when_restored) {
  const TempFolder folder;
  const std::string fixture =
      std::string(TETFARM_SOURCE_DIR) + "/tests/store/fixtures/schema_2.sql";
  std::ifstream file(fixture);
  const std::string sql((std::istreambuf_iterator<char>(file)), {});
  execute(open_database(folder.path() / "old", DatabaseAccess::write).get(), sql.c_str());
  EXPECT_EQ(restore_database(folder.path() / "old", folder.path() / "tetfarm.db", 1), "");
  EXPECT_EQ(JobDatabase(folder.path() / "tetfarm.db").load().jobs.size(), 2U);
}

TEST(DatabaseBackup, what_is_no_database_is_refused_and_nothing_changes) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  JobDatabase(path).apply(job_of(1, "wing"));
  std::ofstream(folder.path() / "text") << std::string(5000, 'x');
  EXPECT_THROW(restore_database(folder.path() / "text", path, 1), CorruptFile);
  EXPECT_THROW(restore_database(folder.path() / "nothing", path, 1), IoError);
  EXPECT_THROW(back_up_database(folder.path() / "nothing", folder.path() / "copy"), IoError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "copy"));
  EXPECT_EQ(JobDatabase(path).load().jobs.size(), 1U);
}

}  // namespace
}  // namespace tetfarm
