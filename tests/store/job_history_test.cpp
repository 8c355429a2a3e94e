#include "store/job_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "base/error.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

AttemptRow attempt(std::uint64_t id, std::uint64_t task, std::uint64_t worker, AttemptState state) {
  AttemptRow row;
  row.id = AttemptId{id};
  row.task = TaskId{task};
  row.worker = WorkerId{worker};
  row.state = state;
  row.started_ms = 1000;
  row.ended_ms = state == AttemptState::running ? 0 : 3500;
  return row;
}

/// Two jobs with a task each; two workers, the second gone.
ChangeSet two_jobs() {
  ChangeSet changes;
  for (std::uint64_t id = 1; id <= 2; ++id) {
    JobRow job;
    job.id = JobId{id};
    changes.jobs.push_back(job);
    TaskRow task;
    task.id = TaskId{id};
    task.job = JobId{id};
    changes.tasks.push_back(task);
    changes.workers.push_back(
        {WorkerId{id}, "host-" + std::to_string(id), 7, 4, 1U << 30U, "0.1", 6, id == 2});
  }
  return changes;
}

EventRow event(std::uint64_t job, std::uint64_t task, const std::string& what) {
  EventRow row;
  row.job = JobId{job};
  row.task = TaskId{task};
  row.what = what;
  return row;
}

std::vector<std::string> words(const std::vector<PastEvent>& events) {
  std::vector<std::string> list;
  for (const PastEvent& past : events) list.push_back(past.row.what);
  return list;
}

TEST(JobHistory, events_come_in_order_by_job_by_task_and_page_by_page) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = two_jobs();
  changes.events = {event(1, 1, "a"), event(2, 2, "b"), event(1, 0, "c"), event(1, 1, "d")};
  database.apply(changes);
  const JobHistory history = database.history();
  EXPECT_THAT(words(history.events({})), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(words(history.events({.job = JobId{1}})), ElementsAre("a", "c", "d"));
  EXPECT_THAT(words(history.events({.job = JobId{1}, .task = TaskId{1}})), ElementsAre("a", "d"));
  const std::vector<PastEvent> page = history.events({.limit = 3});
  EXPECT_THAT(words(page), ElementsAre("a", "b", "c"));
  EXPECT_THAT(words(history.events({.after = page.back().id, .limit = 3})), ElementsAre("d"));
  EXPECT_THAT(words(history.events({.limit = 2, .newest = true})), ElementsAre("c", "d"));
}

TEST(JobHistory, only_the_newest_events_and_logs_are_kept) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db", {.events = 10, .logs = 3});
  database.apply(two_jobs());
  for (std::uint64_t i = 1; i <= 25; ++i) {
    ChangeSet changes;
    changes.events = {event(1, 1, std::to_string(i))};
    changes.attempts = {attempt(i, 1, 1, AttemptState::done)};
    changes.attempts[0].log = "log " + std::to_string(i);
    database.apply(changes);
  }
  const std::vector<PastEvent> events = database.history().events({});
  ASSERT_THAT(events, SizeIs(10));
  EXPECT_EQ(events.front().row.what, "16");
  EXPECT_EQ(events.back().id, 25U);
  EXPECT_EQ(database.history().log_of(AttemptId{22}), std::nullopt);
  EXPECT_EQ(database.history().log_of(AttemptId{23}), "log 23");
  EXPECT_THAT(database.history().attempts_of(TaskId{1}), SizeIs(25)) << "attempts are kept";
}

TEST(JobHistory, attempts_of_a_job_come_page_by_page) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = two_jobs();
  for (std::uint64_t i = 1; i <= 6; ++i) {
    changes.attempts.push_back(attempt(i, 1 + i % 2, 1, AttemptState::lost));
  }
  database.apply(changes);
  const JobHistory history = database.history();
  const std::vector<AttemptRow> first = history.attempts_of(JobId{2}, {}, 2);
  ASSERT_THAT(first, SizeIs(2));
  EXPECT_EQ(first[1].id, AttemptId{3});
  const std::vector<AttemptRow> second = history.attempts_of(JobId{2}, first[1].id, 2);
  ASSERT_THAT(second, SizeIs(1));
  EXPECT_EQ(second[0].id, AttemptId{5});
  EXPECT_THAT(history.attempts_of({}, {}, 100), SizeIs(6));
}

TEST(JobHistory, subdomains_of_a_job_come_by_rising_path_page_by_page) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = two_jobs();
  for (std::uint64_t path = 7; path >= 1; --path) {
    SubdomainRow row;
    row.job = JobId{1 + path % 2};
    row.path = path;
    row.hash = std::string(32, 'a');
    row.size = 10;
    row.work = static_cast<double>(path);
    changes.subdomains.push_back(row);
  }
  database.apply(changes);
  const JobHistory history = database.history();
  const std::vector<SubdomainRow> first = history.tree(JobId{2}, 0, 2);
  ASSERT_THAT(first, SizeIs(2));
  EXPECT_EQ(first[0].path, 1U);
  EXPECT_EQ(first[1].path, 3U);
  EXPECT_EQ(first[1].work, 3);
  const std::vector<SubdomainRow> second = history.tree(JobId{2}, 3, 100);
  ASSERT_THAT(second, SizeIs(2));
  EXPECT_EQ(second[1].path, 7U);
  EXPECT_THAT(history.tree(JobId{2}, 7, 100), IsEmpty());
  EXPECT_THAT(history.tree(JobId{2}), SizeIs(4));
}

TEST(JobHistory, a_worker_is_told_with_what_it_did) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = two_jobs();
  changes.attempts = {attempt(1, 1, 1, AttemptState::done), attempt(2, 1, 1, AttemptState::crashed),
                      attempt(3, 2, 1, AttemptState::done),
                      attempt(4, 2, 1, AttemptState::running)};
  database.apply(changes);
  const std::vector<WorkerRecord> here = database.history().workers({}, 10, false);
  ASSERT_THAT(here, SizeIs(1));
  EXPECT_EQ(here[0].done, 2U);
  EXPECT_EQ(here[0].not_done, 1U);
  EXPECT_DOUBLE_EQ(here[0].busy_seconds, 7.5);
  const std::vector<WorkerRecord> all = database.history().workers({}, 10, true);
  ASSERT_THAT(all, SizeIs(2));
  EXPECT_EQ(all[1].row.host, "host-2");
  EXPECT_THAT(database.history().workers(WorkerId{2}, 10, true), IsEmpty());
  EXPECT_TRUE(database.history().worker(WorkerId{2})->gone);
  EXPECT_FALSE(database.history().worker(WorkerId{9}));
}

TEST(JobHistory, is_read_beside_a_writer_and_by_readers_that_cannot_write) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "db";
  EXPECT_THROW(JobDatabase::open_to_read(path), IoError);
  JobDatabase writer(path);
  JobDatabase reader = JobDatabase::open_to_read(path);
  ChangeSet changes = two_jobs();
  changes.events = {event(1, 1, "a")};
  writer.apply(changes);
  EXPECT_THAT(words(reader.history().events({})), ElementsAre("a"));
  EXPECT_THROW(reader.apply(changes), IoError);
}

/// In a child without privileges: 42 when the reader sees what was written.
int read_as_nobody(const std::filesystem::path& path) {
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) _exit(1);
    if (::access(path.parent_path().c_str(), W_OK) == 0) _exit(2);
    try {
      const JobDatabase reader = JobDatabase::open_to_read(path);
      _exit(words(reader.history().events({})) == std::vector<std::string>{"a"} ? 42 : 3);
    } catch (const Error& error) {
      fprintf(stderr, "%s\n", error.what());
      _exit(4);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

TEST(JobHistory, is_read_in_a_folder_that_may_not_be_written_to) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "a %20 ?db";
  ChangeSet changes = two_jobs();
  changes.events = {event(1, 1, "a")};
  { JobDatabase(path).apply(changes); }
  // Its owner lets others read it.
  std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0644));
  std::filesystem::permissions(folder.path(), static_cast<std::filesystem::perms>(0555));
  EXPECT_EQ(read_as_nobody(path), 42);
  std::filesystem::permissions(folder.path(), static_cast<std::filesystem::perms>(0755));
}

}  // namespace
}  // namespace tetfarm
