#include "store/job_database.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/error.h"
#include "store/network_file_system.h"
#include "store/row_writer.h"
#include "store/schema.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

constexpr int busy_timeout_ms = 5000;

/// The write-ahead log needs memory that processes share, and all of SQLite needs locks that hold:
/// a network file system promises neither, and the damage would show much later.
void refuse_network_file_system(const std::filesystem::path& folder) {
  const std::string kind = network_file_system_of(folder);
  if (kind.empty()) return;
  throw UsageError("the database cannot lie on a network file system (" + kind +
                       "): its locks do not hold there, and it would be damaged; name a folder on "
                       "a disk of this "
                       "host with --database DIR (the store itself may stay where it is)",
                   folder.string());
}

template <class Enum, std::size_t count>
Enum value_of(const std::string& name, const std::array<Enum, count>& all) {
  for (const Enum value : all) {
    if (name == name_of(value)) return value;
  }
  throw CorruptFile("unknown state '" + name + "'", "database");
}

JobPhase phase_of(const std::string& name) {
  return value_of(
      name, std::array{JobPhase::running, JobPhase::done, JobPhase::failed, JobPhase::cancelled});
}
TaskKind kind_of(const std::string& name) {
  return value_of(name, std::array{TaskKind::inspect, TaskKind::decompose, TaskKind::assimilate,
                                   TaskKind::mesh, TaskKind::order, TaskKind::extract,
                                   TaskKind::cosmetic, TaskKind::number, TaskKind::assemble});
}
TaskState task_state_of(const std::string& name) {
  return value_of(name, std::array{TaskState::waiting, TaskState::ready, TaskState::leased,
                                   TaskState::done, TaskState::failed});
}
AttemptState attempt_state_of(const std::string& name) {
  return value_of(name,
                  std::array{AttemptState::running, AttemptState::done, AttemptState::failed,
                             AttemptState::crashed, AttemptState::killed, AttemptState::lost,
                             AttemptState::returned, AttemptState::revoked, AttemptState::starved});
}
SubdomainState subdomain_state_of(const std::string& name) {
  return value_of(name, std::array{SubdomainState::open, SubdomainState::cut, SubdomainState::leaf,
                                   SubdomainState::joined});
}

void load_jobs(sqlite3* database, DurableState& state) {
  Statement rows(database,
                 "SELECT id, coalesce(key, ''), name, job_toml, phase, exit_code, message, "
                 "created_ms, finished_ms FROM jobs");
  while (rows.step()) {
    JobRow job;
    job.id = JobId{rows.unsigned_integer()};
    job.key = rows.text();
    job.name = rows.text();
    job.job_toml = rows.text();
    job.phase = phase_of(rows.text());
    job.exit_code = static_cast<int>(rows.integer());
    job.message = rows.text();
    job.created_ms = rows.integer();
    job.finished_ms = rows.integer();
    state.jobs.emplace(job.id, std::move(job));
  }
}

void load_subdomains(sqlite3* database, DurableState& state) {
  Statement rows(database,
                 "SELECT job, path, parts, state, interdomain_nodes, interior_nodes, tets, meshed, "
                 "hash, size, work, joined_into FROM subdomains JOIN artifacts USING (hash)");
  while (rows.step()) {
    SubdomainRow subdomain;
    subdomain.job = JobId{rows.unsigned_integer()};
    subdomain.path = rows.unsigned_integer();
    subdomain.parts = static_cast<std::uint32_t>(rows.integer());
    subdomain.state = subdomain_state_of(rows.text());
    subdomain.interdomain_nodes = rows.unsigned_integer();
    subdomain.interior_nodes = rows.unsigned_integer();
    subdomain.tets = rows.unsigned_integer();
    subdomain.meshed = rows.integer() != 0;
    subdomain.hash = rows.text();
    subdomain.size = rows.unsigned_integer();
    subdomain.work = rows.real();
    subdomain.joined_into = rows.unsigned_integer();
    state.subdomains.emplace(SubdomainKey{subdomain.job, subdomain.path}, std::move(subdomain));
  }
}

void load_artifacts(sqlite3* database, const char* sql, DurableState& state,
                    std::vector<ArtifactRef> TaskRow::*list) {
  Statement rows(database, sql);
  while (rows.step()) {
    const TaskId task{rows.unsigned_integer()};
    ArtifactRef artifact;
    artifact.name = rows.text();
    artifact.hash = rows.text();
    artifact.size = rows.unsigned_integer();
    (state.tasks.at(task).*list).push_back(std::move(artifact));
  }
}

void load_values(sqlite3* database, DurableState& state) {
  Statement rows(database, "SELECT task, sort, name, number, text FROM task_values");
  while (rows.step()) {
    TaskRow& task = state.tasks.at(TaskId{rows.unsigned_integer()});
    const std::string sort = rows.text();
    const std::string name = rows.text();
    const double number = rows.real();
    const std::string text = rows.text();
    if (sort == "number") {
      task.numbers[name] = number;
    } else if (sort == "text") {
      task.texts[name] = text;
    } else {
      task.parameters[name] = text;
    }
  }
}

void load_tasks(sqlite3* database, DurableState& state) {
  Statement rows(database,
                 "SELECT id, job, kind, path, state, attempt, crashes, losses, exit_code, message, "
                 "seconds, peak_rss_bytes, starvings, memory_bytes FROM tasks");
  while (rows.step()) {
    TaskRow task;
    task.id = TaskId{rows.unsigned_integer()};
    task.job = JobId{rows.unsigned_integer()};
    task.kind = kind_of(rows.text());
    task.path = rows.unsigned_integer();
    task.state = task_state_of(rows.text());
    task.attempt = AttemptId{rows.unsigned_integer()};
    task.crashes = static_cast<std::uint32_t>(rows.integer());
    task.losses = static_cast<std::uint32_t>(rows.integer());
    task.exit_code = static_cast<std::int32_t>(rows.integer());
    task.message = rows.text();
    task.seconds = rows.real();
    task.peak_rss_bytes = rows.unsigned_integer();
    task.starvings = static_cast<std::uint32_t>(rows.integer());
    task.memory_bytes = rows.unsigned_integer();
    state.tasks.emplace(task.id, std::move(task));
  }
  load_artifacts(database,
                 "SELECT task, name, hash, size FROM task_inputs JOIN artifacts USING (hash) "
                 "ORDER BY task, place",
                 state, &TaskRow::inputs);
  load_artifacts(database,
                 "SELECT task, name, hash, size FROM task_outputs JOIN artifacts USING (hash) "
                 "ORDER BY task, place",
                 state, &TaskRow::outputs);
  load_values(database, state);
}

std::vector<AttemptRow> read_attempts(sqlite3* database, const char* where) {
  const std::string sql =
      std::string(
          "SELECT id, task, worker, state, started_ms, ended_ms, message, nonce, rival, "
          "memory_bytes FROM attempts ") +
      where + " ORDER BY id";
  Statement rows(database, sql.c_str());
  std::vector<AttemptRow> attempts;
  while (rows.step()) {
    AttemptRow attempt;
    attempt.id = AttemptId{rows.unsigned_integer()};
    attempt.task = TaskId{rows.unsigned_integer()};
    attempt.worker = WorkerId{rows.unsigned_integer()};
    attempt.state = attempt_state_of(rows.text());
    attempt.started_ms = rows.integer();
    attempt.ended_ms = rows.integer();
    attempt.message = rows.text();
    attempt.nonce = rows.text();
    attempt.is_rival = rows.integer() != 0;
    attempt.memory_bytes = rows.unsigned_integer();
    attempts.push_back(std::move(attempt));
  }
  return attempts;
}

void load_hosts(sqlite3* database, DurableState& state) {
  Statement rows(database, "SELECT host, since_ms, reason FROM hosts WHERE quarantined = 1");
  while (rows.step()) {
    HostRow host;
    host.host = rows.text();
    host.since_ms = rows.integer();
    host.reason = rows.text();
    state.quarantined_hosts.emplace(host.host, std::move(host));
  }
}

std::uint64_t highest(sqlite3* database, const char* sql) {
  Statement row(database, sql);
  row.step();
  return row.unsigned_integer();
}

}  // namespace

void JobDatabase::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

JobDatabase::JobDatabase(const std::filesystem::path& path) : path_(path.string()) {
  refuse_network_file_system(path.has_parent_path() ? path.parent_path() : ".");
  sqlite3* opened = nullptr;
  const int code =
      sqlite3_open_v2(path_.c_str(), &opened,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(opened);
  if (code != SQLITE_OK) throw_sqlite_error(opened, code, "cannot open " + path_);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, busy_timeout_ms);
  execute(opened, "PRAGMA journal_mode = WAL");
  execute(opened, "PRAGMA synchronous = FULL; PRAGMA foreign_keys = OFF;");
  // A table that is built anew is dropped first, which foreign keys would forbid.
  migrate(opened);
  execute(opened, "PRAGMA foreign_keys = ON");
}

JobDatabase::~JobDatabase() = default;

void JobDatabase::apply(const ChangeSet& changes) {
  if (changes.empty()) return;
  execute(database_.get(), "BEGIN IMMEDIATE");
  try {
    write_rows(database_.get(), changes);
    execute(database_.get(), "COMMIT");
  } catch (...) {
    // Some errors end the transaction by themselves; a second ROLLBACK would only hide the first
    // error.
    if (sqlite3_get_autocommit(database_.get()) == 0) {
      sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
    throw;
  }
}

DurableState JobDatabase::load() const {
  DurableState state;
  load_jobs(database_.get(), state);
  load_subdomains(database_.get(), state);
  load_tasks(database_.get(), state);
  for (AttemptRow& attempt : read_attempts(database_.get(), "WHERE state = 'running'")) {
    state.running_attempts.emplace(attempt.id, std::move(attempt));
  }
  load_hosts(database_.get(), state);
  state.last_attempt = highest(database_.get(), "SELECT coalesce(max(id), 0) FROM attempts");
  state.last_worker = highest(database_.get(), "SELECT coalesce(max(id), 0) FROM workers");
  return state;
}

std::vector<EventRow> JobDatabase::events_of(JobId job) const {
  Statement rows(database_.get(),
                 "SELECT wall_ms, job, task, attempt, worker, what, message FROM events "
                 "WHERE job = ? ORDER BY id");
  rows.bind(job.value);
  std::vector<EventRow> events;
  while (rows.step()) {
    EventRow event;
    event.wall_ms = rows.integer();
    event.job = JobId{rows.unsigned_integer()};
    event.task = TaskId{rows.unsigned_integer()};
    event.attempt = AttemptId{rows.unsigned_integer()};
    event.worker = WorkerId{rows.unsigned_integer()};
    event.what = rows.text();
    event.message = rows.text();
    events.push_back(std::move(event));
  }
  return events;
}

std::vector<AttemptRow> JobDatabase::all_attempts() const {
  return read_attempts(database_.get(), "");
}

std::vector<std::string> JobDatabase::damage() const {
  std::vector<std::string> found;
  Statement check(database_.get(), "PRAGMA integrity_check");
  while (check.step()) {
    std::string line = check.text();
    if (line != "ok") found.push_back(std::move(line));
  }
  Statement keys(database_.get(), "PRAGMA foreign_key_check");
  while (keys.step()) found.push_back("a row of " + keys.text() + " points nowhere");
  return found;
}

}  // namespace tetfarm
