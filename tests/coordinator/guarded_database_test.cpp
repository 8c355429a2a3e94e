#include "coordinator/guarded_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>

#include "tests/base/temp_folder.h"
#include "tests/support/failing_writes.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using Look = GuardedDatabase::Look;
using Outcome = GuardedDatabase::Outcome;

ChangeSet job(std::uint64_t id) {
  ChangeSet changes;
  changes.jobs = {
      {JobId{id}, "key" + std::to_string(id), "wing", "toml = 1", JobPhase::running, 0, "", 5, 0}};
  return changes;
}

class GuardedDatabaseTest : public testing::Test {
 protected:
  std::size_t jobs_in(const fs::path& file) const {
    return JobDatabase::open_to_read(file).load().jobs.size();
  }
  TempFolder folder_;
  fs::path path_ = folder_.path() / "tetfarm.db";
  fs::path elsewhere_ = folder_.path() / "elsewhere";
};

TEST_F(GuardedDatabaseTest, commits_while_its_files_are_in_place) {
  GuardedDatabase database(path_);
  EXPECT_EQ(database.commit(job(1)), Outcome::committed);
  EXPECT_EQ(database.look(0), Look::as_before);
  EXPECT_FALSE(database.is_closed());
}

TEST_F(GuardedDatabaseTest, commits_nothing_once_its_file_was_removed_looked_at_or_not) {
  GuardedDatabase database(path_);
  fs::rename(path_, elsewhere_);
  EXPECT_EQ(database.commit(job(1)), Outcome::closed);
  EXPECT_THAT(database.trouble(), AllOf(HasSubstr(path_.string() + ": the database was removed"),
                                        HasSubstr("Move it back, or stop the coordinator")));
  EXPECT_EQ(database.trouble_code(), ExitCode::failed);
  EXPECT_THAT(database.rows().load().jobs, testing::IsEmpty());
}

TEST_F(GuardedDatabaseTest, notices_without_a_commit_and_opens_when_the_same_file_is_back) {
  GuardedDatabase database(path_);
  EXPECT_EQ(database.look(1000), Look::as_before);
  fs::rename(path_, elsewhere_);
  EXPECT_EQ(database.look(1499), Look::as_before) << "looks twice a second";
  EXPECT_EQ(database.look(1500), Look::has_closed);
  EXPECT_EQ(database.look(2000), Look::as_before);
  EXPECT_TRUE(database.is_closed());
  fs::rename(elsewhere_, path_);
  EXPECT_EQ(database.look(2500), Look::has_opened);
  EXPECT_EQ(database.trouble(), "");
  EXPECT_EQ(database.commit(job(1)), Outcome::committed);
}

TEST_F(GuardedDatabaseTest, does_not_take_another_file_for_its_own_and_leaves_it_as_it_is) {
  const fs::path folder = folder_.path() / "other";
  fs::create_directory(folder);
  JobDatabase other(folder / "tetfarm.db");
  other.apply(job(1));
  other.apply(job(2));
  {
    GuardedDatabase database(path_);
    EXPECT_EQ(database.commit(job(7)), Outcome::committed);
    for (const char* part : {"", "-wal", "-shm"}) {
      fs::rename(path_.string() + part, elsewhere_.string() + part);
      fs::copy_file((folder / "tetfarm.db").string() + part, path_.string() + part);
    }
    EXPECT_EQ(database.look(0), Look::has_closed);
    EXPECT_THAT(database.trouble(), HasSubstr("another file has taken the place of the database"));
    EXPECT_EQ(database.commit(job(8)), Outcome::closed);
    EXPECT_EQ(database.save_when_removed(5), "");
  }
  EXPECT_EQ(jobs_in(path_), 2U) << "what the other file's log held is gone";
  EXPECT_EQ(jobs_in(elsewhere_), 1U);
}

TEST_F(GuardedDatabaseTest, saves_what_it_holds_when_its_file_was_removed) {
  GuardedDatabase database(path_);
  EXPECT_EQ(database.commit(job(1)), Outcome::committed);
  EXPECT_EQ(database.save_when_removed(5), "") << "the file is there";
  for (const char* part : {"", "-wal", "-shm"}) fs::remove(path_.string() + part);
  const std::string saved = database.save_when_removed(5);
  EXPECT_EQ(saved, path_.string() + ".saved-5");
  EXPECT_EQ(jobs_in(saved), 1U);
}

TEST_F(GuardedDatabaseTest, misses_its_log_too_and_saves_it_when_it_ends) {
  {
    GuardedDatabase database(path_);
    EXPECT_EQ(database.commit(job(1)), Outcome::committed);
    fs::remove(path_.string() + "-wal");
    EXPECT_EQ(database.look(0), Look::has_closed);
    EXPECT_THAT(database.trouble(), HasSubstr("tetfarm.db-wal: the log of the database"));
    EXPECT_EQ(database.commit(job(2)), Outcome::closed);
  }
  EXPECT_EQ(jobs_in(path_), 1U);
}

class FailingDisk : public GuardedDatabaseTest, public testing::WithParamInterface<int> {};

TEST_P(FailingDisk, closes_it_until_a_write_goes_through_again) {
  const test::FailingWrites disk;
  GuardedDatabase database(path_);
  EXPECT_EQ(database.commit(job(1)), Outcome::committed);
  disk.fail_with(GetParam());
  EXPECT_EQ(database.commit(job(2)), Outcome::closed);
  EXPECT_THAT(database.trouble(),
              AllOf(HasSubstr(path_.string()), HasSubstr("nothing is accepted until the database "
                                                         "can be written to again")));
  EXPECT_EQ(database.look(1000), Look::as_before);
  EXPECT_TRUE(database.is_closed());
  disk.fail_with(0);
  EXPECT_EQ(database.look(20'000), Look::has_opened);
  EXPECT_EQ(database.commit(job(3)), Outcome::committed);
  EXPECT_FALSE(database.rows().load().jobs.contains(JobId{2}));
}

INSTANTIATE_TEST_SUITE_P(Kinds, FailingDisk, testing::Values(EROFS, EIO, ENOSPC, EDQUOT, EACCES));

TEST_F(GuardedDatabaseTest, is_tried_ever_less_often_while_writes_keep_failing) {
  const test::FailingWrites disk;
  GuardedDatabase database(path_);
  disk.fail_with(EROFS);
  EXPECT_EQ(database.commit(job(1)), Outcome::closed);
  for (const std::int64_t failing_ms : {1'000, 1'500, 2'500, 4'500, 8'500}) {
    EXPECT_EQ(database.look(failing_ms), Look::as_before);
  }
  disk.fail_with(0);
  EXPECT_EQ(database.look(16'000), Look::as_before) << "the next try is 8 s after the last";
  EXPECT_EQ(database.look(16'500), Look::has_opened);
}

TEST_F(GuardedDatabaseTest, is_tried_soon_again_in_the_next_trouble) {
  const test::FailingWrites disk;
  GuardedDatabase database(path_);
  disk.fail_with(EROFS);
  EXPECT_EQ(database.commit(job(1)), Outcome::closed);
  for (const std::int64_t failing_ms : {1'000, 1'500, 2'500}) {
    EXPECT_EQ(database.look(failing_ms), Look::as_before);
  }
  disk.fail_with(0);
  EXPECT_EQ(database.look(4'500), Look::has_opened);
  EXPECT_EQ(database.commit(job(1)), Outcome::committed);
  disk.fail_with(EROFS);
  EXPECT_EQ(database.commit(job(2)), Outcome::closed);
  EXPECT_EQ(database.look(10'000), Look::as_before);
  disk.fail_with(0);
  EXPECT_EQ(database.look(10'500), Look::has_opened) << "half a second after the first try";
}

TEST_F(GuardedDatabaseTest, that_breaks_a_rule_of_its_tables_is_our_mistake_and_not_waited_for) {
  GuardedDatabase database(path_);
  ChangeSet orphan;
  orphan.tasks.emplace_back();
  orphan.tasks.back().id = TaskId{1};
  orphan.tasks.back().job = JobId{77};
  EXPECT_THROW(database.commit(orphan), Error);
  EXPECT_FALSE(database.is_closed());
}

}  // namespace
}  // namespace tetfarm
