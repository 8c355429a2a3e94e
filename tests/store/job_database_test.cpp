#include "store/job_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "store/schema.h"
#include "store/sqlite_statement.h"
#include "tests/base/temp_folder.h"
#include "tests/support/seen_syncs.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::string some_hash(char digit) { return std::string(32, digit); }

ChangeSet some_changes() {
  ChangeSet changes;
  JobRow job{JobId{1}, "key",   "wing", "toml = 1", JobPhase::running, 0, "", 5, 0,
             "owner",  "job 1", -7,     {}};
  TaskRow task;
  task.id = TaskId{3};
  task.job = JobId{1};
  task.kind = TaskKind::decompose;
  task.path = std::uint64_t{1} << 62U;
  task.state = TaskState::leased;
  task.attempt = AttemptId{9};
  task.crashes = 1;
  task.losses = 2;
  task.message = "it's \"quoted\"; DROP TABLE tasks";
  task.inputs = {{"job", some_hash('a'), 10}, {"subdomain", some_hash('b'), 1ULL << 40U}};
  task.parameters = {{"parts", "4"}};
  task.numbers = {{"third", 1.0 / 3}, {"huge", 1e300}};
  task.texts = {{"reason", std::string("a\0b", 3)}};
  SubdomainRow subdomain{JobId{1}, 1, 4,     SubdomainState::cut, 7,
                         0,        0, false, some_hash('b'),      1ULL << 40U};
  changes.jobs = {job};
  changes.tasks = {task};
  changes.subdomains = {subdomain};
  changes.workers = {{WorkerId{2}, "host", 77, 4, 1U << 30U, "0.1", 6, false}};
  changes.attempts = {
      {AttemptId{9}, TaskId{3}, WorkerId{2}, AttemptState::running, 6, 0, "", "", false, 0}};
  changes.attempts[0].host = "host";
  changes.attempts[0].key = "key of the worker";
  changes.events = {{6, JobId{1}, TaskId{3}, AttemptId{9}, WorkerId{2}, "assigned", "x"}};
  return changes;
}

void expect_some_changes(const DurableState& state) {
  const ChangeSet changes = some_changes();
  ASSERT_THAT(state.jobs, SizeIs(1));
  EXPECT_EQ(state.jobs.begin()->second, changes.jobs[0]);
  ASSERT_THAT(state.tasks, SizeIs(1));
  EXPECT_EQ(state.tasks.begin()->second, changes.tasks[0]);
  ASSERT_THAT(state.subdomains, SizeIs(1));
  EXPECT_EQ(state.subdomains.begin()->second, changes.subdomains[0]);
  ASSERT_THAT(state.running_attempts, SizeIs(1));
  EXPECT_EQ(state.running_attempts.begin()->second, changes.attempts[0]);
  EXPECT_EQ(state.last_attempt, 9U);
  EXPECT_EQ(state.last_worker, 2U);
}

TEST(JobDatabase, what_is_written_is_read_back_by_another_connection) {
  const TempFolder folder;
  JobDatabase first(folder.path() / "db");
  first.apply(some_changes());
  const JobDatabase second(folder.path() / "db");
  expect_some_changes(second.load());
  const std::vector<PastEvent> events = second.history().events({.job = JobId{1}});
  ASSERT_THAT(events, SizeIs(1));
  EXPECT_EQ(events[0].row, some_changes().events[0]);
  EXPECT_THAT(second.damage(), IsEmpty());
}

TEST(JobDatabase, rows_written_again_replace_the_older_ones) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  database.apply(some_changes());
  ChangeSet later;
  later.tasks = some_changes().tasks;
  later.tasks[0].state = TaskState::done;
  later.tasks[0].outputs = {{"left", some_hash('c'), 1}, {"right", some_hash('d'), 2}};
  later.tasks[0].numbers = {{"left_parts", 2}};
  later.attempts = some_changes().attempts;
  later.attempts[0].state = AttemptState::done;
  database.apply(later);
  EXPECT_EQ(database.load().tasks.at(TaskId{3}), later.tasks[0]);
  later.tasks[0].outputs.pop_back();
  later.attempts.clear();
  database.apply(later);
  const DurableState state = database.load();
  EXPECT_EQ(state.tasks.at(TaskId{3}), later.tasks[0]);
  EXPECT_THAT(state.running_attempts, IsEmpty());
  EXPECT_EQ(state.last_attempt, 9U);
  EXPECT_THAT(database.damage(), IsEmpty());
}

TEST(JobDatabase, a_transaction_with_one_impossible_row_changes_nothing) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = some_changes();
  changes.attempts.push_back(
      {AttemptId{10}, TaskId{3}, WorkerId{2}, AttemptState::running, 6, 0, "", "", false, 0});
  EXPECT_THROW(database.apply(changes), IoError) << "two attempts of one task at a time";
  EXPECT_THAT(database.load().jobs, IsEmpty());
  changes.attempts.back().task = TaskId{99};
  EXPECT_THROW(database.apply(changes), IoError) << "an attempt of no task";
  EXPECT_THAT(database.load().jobs, IsEmpty());
  database.apply(some_changes());
  expect_some_changes(database.load());
}

/// Runs `action` in a child that ends without closing anything.
template <class Action>
int in_a_child(const Action& action) {
  const pid_t child = fork();
  if (child == 0) {
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(JobDatabase, what_was_committed_survives_an_abrupt_end) {
  const TempFolder folder;
  in_a_child([&] {
    JobDatabase database(folder.path() / "db");
    database.apply(some_changes());
    kill(getpid(), SIGKILL);
  });
  const JobDatabase database(folder.path() / "db");
  expect_some_changes(database.load());
}

TEST(JobDatabase, a_process_killed_within_a_transaction_leaves_none_of_it) {
  const TempFolder folder;
  const std::string path = folder.path() / "db";
  { JobDatabase(path).apply(some_changes()); }
  in_a_child([&] {
    sqlite3* raw = nullptr;
    sqlite3_open(path.c_str(), &raw);
    sqlite3_exec(raw,
                 "PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE jobs SET phase = 'failed'; "
                 "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 20000) "
                 "INSERT INTO events SELECT NULL, i, 0, 0, 0, 0, 'half', 'a long text to spill "
                 "pages' FROM n;",
                 nullptr, nullptr, nullptr);
    kill(getpid(), SIGKILL);
  });
  JobDatabase database(path);
  expect_some_changes(database.load());
  EXPECT_THAT(database.damage(), IsEmpty());
}

TEST(JobDatabase, killed_at_any_instant_it_holds_whole_transactions_only) {
  const TempFolder folder;
  const std::string path = folder.path() / "db";
  for (int round = 0; round < 5; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      JobDatabase database(path);
      ChangeSet changes = some_changes();
      for (std::int64_t i = 0;; ++i) {
        changes.jobs[0].finished_ms = i;
        changes.tasks[0].numbers["step"] = static_cast<double>(i);
        changes.events.clear();
        database.apply(changes);
      }
    }
    usleep(static_cast<useconds_t>(20000 + 7001 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const JobDatabase database(path);
    const DurableState state = database.load();
    if (state.jobs.empty()) continue;
    EXPECT_EQ(static_cast<double>(state.jobs.at(JobId{1}).finished_ms),
              state.tasks.at(TaskId{3}).numbers.at("step"));
    EXPECT_THAT(database.damage(), IsEmpty());
  }
}

TEST(JobDatabase, a_full_disk_is_out_of_resources_and_the_old_state_stays) {
  const TempFolder folder;
  const std::string path = folder.path() / "db";
  { JobDatabase(path).apply(some_changes()); }
  const int status = in_a_child([&] {
    signal(SIGXFSZ, SIG_IGN);
    JobDatabase database(path);
    const rlimit limit{200000, 200000};
    setrlimit(RLIMIT_FSIZE, &limit);
    ChangeSet changes = some_changes();
    changes.jobs[0].job_toml = std::string(1000000, 'x');
    try {
      database.apply(changes);
    } catch (const IoError& error) {
      expect_some_changes(database.load());
      EXPECT_EQ(error.code(), ExitCode::out_of_resources) << error.what();
      _exit(testing::Test::HasFailure() ? 1 : 42);
    }
  });
  EXPECT_EQ(WEXITSTATUS(status), 42);
  expect_some_changes(JobDatabase(path).load());
}

TEST(JobDatabase, other_files_are_refused) {
  const TempFolder folder;
  std::ofstream(folder.path() / "text") << std::string(5000, 'x');
  EXPECT_THROW(JobDatabase(folder.path() / "text"), CorruptFile);
  sqlite3* raw = nullptr;
  sqlite3_open((folder.path() / "theirs").c_str(), &raw);
  sqlite3_exec(raw, "CREATE TABLE t (x)", nullptr, nullptr, nullptr);
  sqlite3_close(raw);
  EXPECT_THROW(JobDatabase(folder.path() / "theirs"), CorruptFile);
  EXPECT_THROW(JobDatabase(folder.path() / "no_folder" / "db"), IoError);
}

TEST(JobDatabase, a_newer_database_is_refused) {
  const TempFolder folder;
  const std::string path = folder.path() / "db";
  { const JobDatabase made(path); }
  sqlite3* raw = nullptr;
  sqlite3_open(path.c_str(), &raw);
  sqlite3_exec(raw, "PRAGMA user_version = 999", nullptr, nullptr, nullptr);
  sqlite3_close(raw);
  EXPECT_THROW(JobDatabase{path}, CorruptFile);
}

TEST(JobDatabase, a_rival_and_its_first_may_run_at_a_time_but_no_third) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  database.apply(some_changes());
  ChangeSet rival;
  rival.attempts = some_changes().attempts;
  rival.attempts[0].id = AttemptId{10};
  rival.attempts[0].is_rival = true;
  database.apply(rival);
  EXPECT_THAT(database.load().running_attempts, SizeIs(2));
  rival.attempts[0].id = AttemptId{11};
  EXPECT_THROW(database.apply(rival), IoError);
}

TEST(JobDatabase, is_made_for_its_owner_alone_and_closed_to_all_others) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "db";
  const auto mode = [](const std::string& file) {
    struct stat about {};
    EXPECT_EQ(::stat(file.c_str(), &about), 0) << file;
    return about.st_mode & 07777U;
  };
  {
    JobDatabase database(path);
    database.apply(some_changes());
    for (const char* part : {"", "-wal", "-shm"}) EXPECT_EQ(mode(path.string() + part), 0600U);
  }
  ::chmod(path.c_str(), 0644);
  { const JobDatabase database(path); }
  EXPECT_EQ(mode(path), 0600U) << "as an earlier program left it";
  ::chmod(path.c_str(), 0640);
  { const JobDatabase database(path); }
  EXPECT_EQ(mode(path), 0640U) << "what its owner gave a group";
}

TEST(JobDatabase, what_it_has_taken_is_on_the_disk) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "db";
  JobDatabase database(path);
  const test::SeenSyncs syncs;
  database.apply(some_changes());
  EXPECT_TRUE(syncs.has(path.string() + "-wal"));
}

TEST(JobDatabase, an_attempt_of_no_task_is_refused) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = some_changes();
  changes.tasks.clear();
  EXPECT_THROW(database.apply(changes), IoError);
  EXPECT_THAT(database.load().running_attempts, IsEmpty());
}

TEST(JobDatabase, it_has_a_log_of_what_is_written_and_tables_that_check_their_values) {
  const TempFolder folder;
  const std::string path = folder.path() / "db";
  const JobDatabase made(path);
  sqlite3* raw = nullptr;
  sqlite3_open(path.c_str(), &raw);
  {
    Statement mode(raw, "PRAGMA journal_mode");
    mode.step();
    EXPECT_EQ(mode.text(), "wal");
    Statement version(raw, "PRAGMA user_version");
    version.step();
    EXPECT_EQ(version.integer(), database_version);
    Statement strict(raw,
                     "SELECT count(*) FROM pragma_table_list "
                     "WHERE schema = 'main' AND type = 'table' AND strict = 0 "
                     "AND name NOT LIKE 'sqlite_%'");
    strict.step();
    EXPECT_EQ(strict.integer(), 0) << "tables that are not STRICT";
  }
  sqlite3_close(raw);
}

/// Three jobs: one runs, one has ended, one was cancelled while an attempt of it ran.
ChangeSet three_jobs() {
  ChangeSet changes = some_changes();
  for (const std::uint64_t id : {11U, 12U, 13U}) {
    JobRow job;
    job.id = JobId{id};
    job.phase = id == 11 ? JobPhase::running : id == 12 ? JobPhase::done : JobPhase::cancelled;
    changes.jobs.push_back(job);
    TaskRow task = changes.tasks[0];
    task.id = TaskId{10 * id};
    task.job = job.id;
    task.attempt = {};
    task.state = TaskState::replaced;
    changes.tasks.push_back(task);
    task.id = TaskId{10 * id + 1};
    task.state = TaskState::ready;
    changes.tasks.push_back(task);
    changes.subdomains.push_back(changes.subdomains[0]);
    changes.subdomains.back().job = job.id;
  }
  changes.attempts.push_back(changes.attempts[0]);
  changes.attempts.back().id = AttemptId{20};
  changes.attempts.back().task = TaskId{131};
  return changes;
}

TEST(JobDatabase, of_jobs_that_have_ended_and_of_which_nothing_runs_only_their_own_rows_are_read) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  database.apply(three_jobs());
  const DurableState part = database.load_unfinished();
  const DurableState all = database.load();
  EXPECT_EQ(part.jobs, all.jobs);
  EXPECT_EQ(part.running_attempts, all.running_attempts);
  EXPECT_EQ(part.last_task, 131U);
  std::map<TaskId, TaskRow> tasks = all.tasks;
  tasks.erase(TaskId{120});
  tasks.erase(TaskId{121});
  EXPECT_EQ(part.tasks, tasks);
  EXPECT_THAT(part.subdomains, SizeIs(3));
  EXPECT_FALSE(part.subdomains.contains({JobId{12}, 1}));
}

TEST(JobDatabase, of_jobs_that_wait_for_others_all_is_read) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = three_jobs();
  JobRow& waiting = changes.jobs.at(2);
  waiting.phase = JobPhase::waiting;
  waiting.after = {JobId{1}, JobId{11}};
  waiting.end_untold = true;
  database.apply(changes);
  const DurableState part = database.load_unfinished();
  EXPECT_EQ(part.jobs.at(waiting.id), waiting);
  EXPECT_TRUE(std::any_of(part.tasks.begin(), part.tasks.end(),
                          [&](const auto& task) { return task.second.job == waiting.id; }));
}

TEST(JobDatabase, a_job_is_removed_with_all_its_rows_and_ids_are_not_given_out_again) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes = three_jobs();
  database.apply(changes);
  const DurableState before = database.load();
  ChangeSet removal;
  removal.removed_jobs = {JobId{12}, JobId{13}};
  database.apply(removal);
  const DurableState after = database.load();
  EXPECT_THAT(after.jobs, SizeIs(before.jobs.size() - 2));
  for (const auto& [id, task] : after.tasks) EXPECT_LT(task.job, JobId{12});
  for (const auto& [key, node] : after.subdomains) EXPECT_LT(key.first, JobId{12});
  EXPECT_EQ(after.last_task, before.last_task);
  EXPECT_EQ(after.last_attempt, before.last_attempt);
  EXPECT_EQ(after.last_job, before.last_job);
  EXPECT_THAT(database.damage(), IsEmpty());
}

TEST(JobDatabase, one_job_and_one_task_are_read_alone_with_all_that_belongs_to_them) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  database.apply(three_jobs());
  const DurableState all = database.load();
  const DurableState job = database.load_job(JobId{12});
  EXPECT_EQ(job.jobs, (std::map<JobId, JobRow>{{JobId{12}, all.jobs.at(JobId{12})}}));
  EXPECT_EQ(job.tasks, (std::map<TaskId, TaskRow>{{TaskId{120}, all.tasks.at(TaskId{120})},
                                                  {TaskId{121}, all.tasks.at(TaskId{121})}}));
  EXPECT_THAT(job.subdomains, SizeIs(1));
  EXPECT_EQ(database.find_task(TaskId{121}), all.tasks.at(TaskId{121}));
  EXPECT_EQ(database.find_task(TaskId{122}), std::nullopt);
  EXPECT_THAT(database.load_job(JobId{14}).jobs, IsEmpty());
  EXPECT_EQ(database.history().tree(JobId{12}).front(), job.subdomains.begin()->second);
  EXPECT_EQ(database.history().task(TaskId{120})->state, TaskState::replaced);
  EXPECT_THAT(database.history().tasks(JobId{12}, TaskId{120}, 9), SizeIs(1));
  EXPECT_THAT(database.history().tasks({}, TaskId{110}, 3), SizeIs(3));
}

/// A table of its own for each row was a quarter of what a task cost.
TEST(JobDatabase, a_value_is_written_without_a_table_for_the_list_of_sorts_and_others_are_refused) {
  const TempFolder folder;
  JobDatabase(folder.path() / "db").apply(some_changes());
  const SqlitePtr opened = open_database(folder.path() / "db", DatabaseAccess::write);
  Statement plan(opened.get(),
                 "EXPLAIN INSERT INTO task_values VALUES (3, 'text', 'x', NULL, 'y')");
  while (plan.step()) {
    plan.integer();
    EXPECT_NE(plan.text(), "OpenEphemeral");
  }
  EXPECT_THROW(execute(opened.get(), "INSERT INTO task_values VALUES (3, 'sound', 'x', NULL, 'y')"),
               Error);
}

/// Every field has a value of its own, so that none can take another's place.
ChangeSet distinct_values() {
  ChangeSet changes;
  changes.jobs = {
      {JobId{1}, "key", "name", "toml", JobPhase::failed, 2, "message", 3, 4, "owner", "content"}};
  TaskRow task;
  task.id = TaskId{5};
  task.job = JobId{1};
  task.kind = TaskKind::cosmetic;
  task.path = 6;
  task.state = TaskState::waiting;
  task.attempt = AttemptId{7};
  task.crashes = 8;
  task.losses = 9;
  task.oom_count = 10;
  task.memory_bytes = 11;
  task.exit_code = 12;
  task.message = "why";
  task.seconds = 13.5;
  task.peak_rss_bytes = 14;
  task.inputs = {{"in 1", some_hash('a'), 15}, {"in 2", some_hash('b'), 16}};
  task.outputs = {{"out 2", some_hash('d'), 18}, {"out 1", some_hash('c'), 17}};
  task.parameters = {{"parameter", "p"}};
  task.numbers = {{"number", 0.1}};
  task.texts = {{"text", "t"}};
  changes.tasks = {task};
  SubdomainRow node{JobId{1}, 20,   21, SubdomainState::joined, 22, 23, 24, true, some_hash('e'),
                    25,       26.5, 27};
  changes.subdomains = {node};
  changes.workers = {{WorkerId{30}, "host", 31, 32, 33, "version", 34, true}};
  AttemptRow attempt{AttemptId{40},
                     TaskId{5},
                     WorkerId{30},
                     AttemptState::running,
                     41,
                     42,
                     "said",
                     "nonce",
                     true,
                     43,
                     44};
  attempt.host = "host";
  attempt.key = "a key";
  changes.attempts = {attempt};
  changes.hosts = {{"bad host", true, 50, "reason"}, {"good host", false, 51, "let go"}};
  return changes;
}

TEST(JobDatabase, each_field_comes_back_as_itself_when_it_is_new_and_when_it_has_changed) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  const auto expect = [&database](const ChangeSet& changes) {
    const DurableState state = database.load();
    EXPECT_EQ(state.jobs.at(JobId{1}), changes.jobs[0]);
    EXPECT_EQ(state.tasks.at(TaskId{5}), changes.tasks[0]);
    EXPECT_EQ(state.subdomains.at({JobId{1}, 20}), changes.subdomains[0]);
    EXPECT_EQ(state.running_attempts.at(AttemptId{40}), changes.attempts[0]);
    EXPECT_EQ(database.history().worker(WorkerId{30}), changes.workers[0]);
    EXPECT_EQ(state.last_task, 5U);
    EXPECT_EQ(state.last_attempt, 40U);
    EXPECT_EQ(state.last_worker, 30U);
  };
  ChangeSet changes = distinct_values();
  database.apply(changes);
  expect(changes);
  DurableState state = database.load();
  ASSERT_THAT(state.quarantined_hosts, SizeIs(1)) << "the other was let go";
  EXPECT_EQ(state.quarantined_hosts.at("bad host"), changes.hosts[0]);
  JobRow& job = changes.jobs[0];
  job.name = "name 2";
  job.job_toml = "toml 2";
  job.phase = JobPhase::cancelled;
  job.exit_code = 102;
  job.message = "message 2";
  job.finished_ms = 104;
  TaskRow& task = changes.tasks[0];
  task.state = TaskState::failed;
  task.attempt = AttemptId{107};
  task.crashes = 108;
  task.losses = 109;
  task.oom_count = 110;
  task.memory_bytes = 111;
  task.exit_code = 112;
  task.message = "why 2";
  task.seconds = 113.5;
  task.peak_rss_bytes = 114;
  task.outputs = {{"out 3", some_hash('f'), 119}};
  task.numbers = {{"number 2", 0.2}};
  task.texts = {{"text 2", "t 2"}};
  SubdomainRow& node = changes.subdomains[0];
  node.parts = 121;
  node.state = SubdomainState::leaf;
  node.interdomain_nodes = 122;
  node.interior_nodes = 123;
  node.tets = 124;
  node.meshed = false;
  node.hash = some_hash('9');
  node.size = 125;
  node.work = 126.5;
  node.joined_into = 127;
  changes.workers[0].gone = false;
  AttemptRow& attempt = changes.attempts[0];
  attempt.ended_ms = 142;
  attempt.message = "said 2";
  attempt.is_rival = false;
  attempt.peak_rss_bytes = 144;
  changes.hosts = {{"bad host", false, 150, "let go"}, {"good host", true, 151, "bad again"}};
  database.apply(changes);
  expect(changes);
  state = database.load();
  ASSERT_THAT(state.quarantined_hosts, SizeIs(1));
  EXPECT_EQ(state.quarantined_hosts.at("good host"), changes.hosts[1]);
}

TEST(JobDatabase, a_task_of_a_kind_that_this_program_does_not_know_is_told) {
  const TempFolder folder;
  JobDatabase(folder.path() / "db").apply(some_changes());
  {
    const SqlitePtr opened = open_database(folder.path() / "db", DatabaseAccess::write);
    execute(opened.get(), "UPDATE tasks SET kind = 'polish'");
  }
  const JobDatabase database(folder.path() / "db");
  try {
    database.load();
    ADD_FAILURE() << "there is no such kind";
  } catch (const CorruptFile& error) {
    EXPECT_STREQ(error.what(),
                 "database: a task of the kind 'polish', which this program does not know");
  }
}

}  // namespace
}  // namespace tetfarm
