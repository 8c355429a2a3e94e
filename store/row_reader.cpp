#include "store/row_reader.h"

#include <sqlite3.h>

#include <array>
#include <sstream>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "store/job_history.h"
#include "store/sqlite_statement.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

template <class Enum, std::size_t count>
Enum value_of(const std::string& name, const std::array<Enum, count>& all) {
  for (const Enum value : all) {
    if (name == name_of(value)) return value;
  }
  throw CorruptFile("unknown state '" + name + "'", "database");
}

JobPhase phase_of(const std::string& name) {
  return value_of(name, std::array{JobPhase::running, JobPhase::done, JobPhase::failed,
                                   JobPhase::cancelled, JobPhase::waiting});
}
TaskState task_state_of(const std::string& name) {
  return value_of(name, std::array{TaskState::waiting, TaskState::ready, TaskState::leased,
                                   TaskState::done, TaskState::failed, TaskState::replaced});
}
SubdomainState subdomain_state_of(const std::string& name) {
  return value_of(name, std::array{SubdomainState::open, SubdomainState::cut, SubdomainState::leaf,
                                   SubdomainState::joined});
}

/// "3 5", as row_writer.cpp writes them.
std::vector<JobId> job_ids(const std::string& text) {
  std::vector<JobId> ids;
  std::istringstream words(text);
  for (std::uint64_t id = 0; words >> id;) ids.push_back(JobId{id});
  if (!words.eof()) throw CorruptFile("'" + text + "' are no jobs", "database");
  return ids;
}

void load_jobs(sqlite3* database, const std::string& which, DurableState& state) {
  const std::string sql =
      "SELECT id, coalesce(key, ''), name, job_toml, phase, exit_code, message, "
      "created_ms, finished_ms, owner, content, priority, waits_for, end_untold FROM jobs" +
      which;
  Statement rows(database, sql.c_str());
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
    job.owner = rows.text();
    job.content = rows.text();
    job.priority = static_cast<int>(rows.integer());
    job.after = job_ids(rows.text());
    job.end_untold = rows.integer() != 0;
    state.jobs.emplace(job.id, std::move(job));
  }
}

/// Of which jobs and tasks the rows are read: what gives their ids in SQL, "" for all.
struct Part {
  std::string jobs;
  std::string tasks;

  std::string of_job(const char* column) const { return within(column, jobs); }
  std::string of_task(const char* column) const { return within(column, tasks); }

 private:
  static std::string within(const char* column, const std::string& ids) {
    return ids.empty() ? "" : std::string(" WHERE ") + column + " IN (" + ids + ")";
  }
};

Part part_of(const std::string& jobs) { return {jobs, ids_of_tasks(jobs)}; }

/// A job that has ended may still have an attempt for a moment.
Part unfinished_part() {
  return part_of(
      "SELECT id FROM jobs WHERE phase IN ('running', 'waiting') UNION SELECT tasks.job FROM "
      "attempts JOIN tasks ON tasks.id = attempts.task WHERE attempts.state = 'running'");
}

constexpr const char* subdomain_columns =
    "SELECT job, path, parts, state, interdomain_nodes, interior_nodes, tets, meshed, hash, size, "
    "work, joined_into FROM subdomains JOIN artifacts USING (hash)";

SubdomainRow read_subdomain_columns(Statement& rows) {
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
  return subdomain;
}

void load_subdomains(sqlite3* database, const Part& part, DurableState& state) {
  const std::string sql = subdomain_columns + part.of_job("job");
  Statement rows(database, sql.c_str());
  while (rows.step()) {
    SubdomainRow subdomain = read_subdomain_columns(rows);
    state.subdomains.emplace(SubdomainKey{subdomain.job, subdomain.path}, std::move(subdomain));
  }
}

void load_artifacts(sqlite3* database, const char* table, const Part& part, DurableState& state,
                    std::vector<ArtifactRef> TaskRow::*list) {
  TF_CHECK(list == &TaskRow::inputs || list == &TaskRow::outputs);
  const std::string sql = std::string("SELECT task, name, hash, size FROM ") + table +
                          " JOIN artifacts USING (hash)" + part.of_task("task") +
                          " ORDER BY task, place";
  Statement rows(database, sql.c_str());
  while (rows.step()) {
    const TaskId task{rows.unsigned_integer()};
    ArtifactRef artifact;
    artifact.name = rows.text();
    artifact.hash = rows.text();
    artifact.size = rows.unsigned_integer();
    (state.tasks.at(task).*list).push_back(std::move(artifact));
  }
}

void load_values(sqlite3* database, const Part& part, DurableState& state) {
  const std::string sql =
      "SELECT task, sort, name, number, text FROM task_values" + part.of_task("task");
  Statement rows(database, sql.c_str());
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

void load_tasks(sqlite3* database, const Part& part, DurableState& state) {
  const std::string sql =
      std::string("SELECT ") + task_columns + " FROM tasks" + part.of_task("id");
  Statement rows(database, sql.c_str());
  while (rows.step()) {
    TaskRow task = read_task_columns(rows);
    state.tasks.emplace(task.id, std::move(task));
  }
  load_artifacts(database, "task_inputs", part, state, &TaskRow::inputs);
  load_artifacts(database, "task_outputs", part, state, &TaskRow::outputs);
  load_values(database, part, state);
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
  TF_CHECK(database != nullptr);
  Statement row(database, sql);
  row.step();
  return row.unsigned_integer();
}

/// The highest id that a row of the kind ever had: of those that were removed a floor is left.
std::uint64_t highest_given(sqlite3* database, const std::string& kind) {
  const std::string sql = "SELECT max((SELECT coalesce(max(id), 0) FROM " + kind +
                          "s), (SELECT coalesce(max(value), 0) FROM floors WHERE name = '" + kind +
                          "'))";
  return highest(database, sql.c_str());
}

}  // namespace

TaskKind task_kind_of(const std::string& name) {
  const std::optional<TaskKind> kind = task_kind_named(name);
  if (!kind) {
    throw CorruptFile("a task of the kind '" + name + "', which this program does not know",
                      "database");
  }
  return *kind;
}

AttemptState attempt_state_of(const std::string& name) {
  return value_of(name,
                  std::array{AttemptState::running, AttemptState::done, AttemptState::failed,
                             AttemptState::crashed, AttemptState::killed, AttemptState::lost,
                             AttemptState::returned, AttemptState::revoked, AttemptState::starved});
}

std::string ids_of_tasks(const std::string& jobs) {
  return "SELECT id FROM tasks WHERE state <> 'replaced' AND job IN (" + jobs +
         ") UNION ALL SELECT id FROM tasks WHERE state = 'replaced' AND job IN (" + jobs + ")";
}

TaskRow read_task_columns(Statement& rows) {
  TaskRow task;
  task.id = TaskId{rows.unsigned_integer()};
  task.job = JobId{rows.unsigned_integer()};
  task.kind = task_kind_of(rows.text());
  task.path = rows.unsigned_integer();
  task.state = task_state_of(rows.text());
  task.attempt = AttemptId{rows.unsigned_integer()};
  task.crashes = static_cast<std::uint32_t>(rows.integer());
  task.losses = static_cast<std::uint32_t>(rows.integer());
  task.exit_code = static_cast<std::int32_t>(rows.integer());
  task.message = rows.text();
  task.seconds = rows.real();
  task.peak_rss_bytes = rows.unsigned_integer();
  task.oom_count = static_cast<std::uint32_t>(rows.integer());
  task.memory_bytes = rows.unsigned_integer();
  return task;
}

DurableState read_state(sqlite3* database, JobsToRead jobs) {
  DurableState state;
  load_jobs(database, "", state);
  const Part part = jobs == JobsToRead::all ? Part{} : unfinished_part();
  load_subdomains(database, part, state);
  load_tasks(database, part, state);
  for (AttemptRow& attempt : JobHistory(database).running_attempts()) {
    state.running_attempts.emplace(attempt.id, std::move(attempt));
  }
  load_hosts(database, state);
  state.last_task = highest_given(database, "task");
  state.last_attempt = highest_given(database, "attempt");
  state.last_job = highest_given(database, "job");
  state.last_worker = highest(database, "SELECT coalesce(max(id), 0) FROM workers");
  return state;
}

DurableState read_job(sqlite3* database, JobId job) {
  DurableState state;
  const Part part = part_of(std::to_string(job.value));
  load_jobs(database, " WHERE id = " + std::to_string(job.value), state);
  load_subdomains(database, part, state);
  load_tasks(database, part, state);
  return state;
}

std::optional<TaskRow> read_task(sqlite3* database, TaskId task) {
  DurableState state;
  load_tasks(database, {"", std::to_string(task.value)}, state);
  if (state.tasks.empty()) return std::nullopt;
  return std::move(state.tasks.begin()->second);
}

std::vector<SubdomainRow> read_tree(sqlite3* database, JobId job) {
  DurableState state;
  load_subdomains(database, part_of(std::to_string(job.value)), state);
  std::vector<SubdomainRow> tree;
  for (auto& [key, node] : state.subdomains) tree.push_back(std::move(node));
  return tree;
}

std::vector<SubdomainRow> read_tree(sqlite3* database, JobId job, std::uint64_t after,
                                    std::size_t limit) {
  const std::string sql =
      std::string(subdomain_columns) + " WHERE job = ?1 AND path > ?2 ORDER BY path LIMIT ?3";
  Statement rows(database, sql.c_str());
  rows.bind(job.value).bind(after).bind(static_cast<std::uint64_t>(limit));
  std::vector<SubdomainRow> tree;
  while (rows.step()) tree.push_back(read_subdomain_columns(rows));
  return tree;
}

}  // namespace tetfarm
