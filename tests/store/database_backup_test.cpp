#include "store/database_backup.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "store/database_file.h"
#include "store/job_database.h"
#include "store/sqlite_statement.h"
#include "tests/base/temp_folder.h"
#include "tests/support/failing_writes.h"

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

TEST(DatabaseBackup, a_damaged_one_is_not_restored_and_nothing_changes) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  const std::filesystem::path copy = folder.path() / "copy";
  JobDatabase(path).apply(job_of(1, "wing"));
  back_up_database(path, copy);
  execute(open_database(copy, DatabaseAccess::write).get(),
          "PRAGMA foreign_keys = OFF; DELETE FROM jobs");
  JobDatabase(path).apply(job_of(2, "a later job"));
  EXPECT_THROW(restore_database(copy, path, 1), CorruptFile);
  EXPECT_EQ(JobDatabase(path).load().jobs.size(), 2U);
  EXPECT_EQ(count_files(folder.path()), 2U);
}

TEST(DatabaseBackup, none_is_made_of_a_damaged_database) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "tetfarm.db";
  JobDatabase(path).apply(job_of(1, "wing"));
  execute(open_database(path, DatabaseAccess::write).get(),
          "PRAGMA foreign_keys = OFF; DELETE FROM jobs");
  EXPECT_THROW(back_up_database(path, folder.path() / "copy"), CorruptFile);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "copy"));
}

/// What waits in SQLite waits no more.
class NoPauses {
 public:
  NoPauses() {
    hurried_.zName = "hurried";
    hurried_.xSleep = [](sqlite3_vfs*, int microseconds) { return microseconds; };
    sqlite3_vfs_register(&hurried_, 1);
  }
  ~NoPauses() { sqlite3_vfs_unregister(&hurried_); }
  NoPauses(const NoPauses&) = delete;
  NoPauses& operator=(const NoPauses&) = delete;

 private:
  sqlite3_vfs hurried_ = *sqlite3_vfs_find(nullptr);
};

TEST(DatabaseCopy, that_is_not_whole_is_told) {
  const TempFolder folder;
  JobDatabase(folder.path() / "from").apply(job_of(1, "wing"));
  const SqlitePtr from = open_database(folder.path() / "from", DatabaseAccess::read);
  const NoPauses no_pauses;
  const SqlitePtr to = open_database(folder.path() / "to", DatabaseAccess::write);
  {
    const SqlitePtr other = open_database(folder.path() / "to", DatabaseAccess::write);
    execute(other.get(), "BEGIN EXCLUSIVE");
    sqlite3_busy_timeout(to.get(), 0);
    EXPECT_THROW(copy_database(from.get(), to.get()), IoError) << "another writes to it";
  }
  {
    const test::FailingWrites full(ENOSPC);
    EXPECT_THROW(copy_database(from.get(), to.get()), IoError) << "the disk is full";
  }
  copy_database(from.get(), to.get());
  EXPECT_EQ(JobDatabase::open_to_read(folder.path() / "to").load().jobs.size(), 1U);
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
