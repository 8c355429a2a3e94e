#include "store/job_history.h"

#include <sqlite3.h>

#include <algorithm>
#include <utility>

#include "store/row_reader.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

constexpr const char* attempt_columns =
    "attempts.id, task, worker, attempts.state, started_ms, ended_ms, attempts.message, "
    "nonce_hash, "
    "rival, attempts.memory_bytes, attempts.peak_rss_bytes, "
    "(SELECT host FROM workers WHERE workers.id = worker), key FROM attempts ";
constexpr const char* worker_columns =
    "SELECT id, host, process, cores, memory_bytes, program_version, seen_ms, gone";

std::vector<AttemptRow> read_attempts(Statement& rows) {
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
    attempt.nonce_hash = rows.text();
    attempt.is_rival = rows.integer() != 0;
    attempt.memory_bytes = rows.unsigned_integer();
    attempt.peak_rss_bytes = rows.unsigned_integer();
    attempt.host = rows.text();
    attempt.key = rows.text();
    attempts.push_back(std::move(attempt));
  }
  return attempts;
}

WorkerRow read_worker(Statement& rows) {
  WorkerRow worker;
  worker.id = WorkerId{rows.unsigned_integer()};
  worker.host = rows.text();
  worker.process = rows.integer();
  worker.cores = static_cast<std::uint32_t>(rows.integer());
  worker.memory_bytes = rows.unsigned_integer();
  worker.program_version = rows.text();
  worker.seen_ms = rows.integer();
  worker.gone = rows.integer() != 0;
  return worker;
}

/// What each task was expected to take and took, and how good what it made is, of its values.
void read_costs(sqlite3* database, std::vector<TaskRow>& tasks) {
  Statement values(database,
                   "SELECT sort, name, number, text FROM task_values WHERE task = ? AND name IN "
                   "('expected_seconds', 'expected_bytes', 'cpu_seconds', 'tets', 'work', "
                   "'size_elements', 'size_triangles', 'size_needles', 'min_dihedral_deg')");
  for (TaskRow& task : tasks) {
    values.bind(task.id.value);
    while (values.step()) {
      const std::string sort = values.text();
      const std::string name = values.text();
      const double number = values.real();
      if (sort == "number") task.numbers[name] = number;
      if (sort == "parameter") task.parameters[name] = values.text();
    }
    values.rewind();
  }
}

}  // namespace

std::vector<PastEvent> JobHistory::events(const EventFilter& filter) const {
  const std::string job = filter.job ? "job = ?1" : "?1 = 0";
  const std::string task = filter.task ? " AND task = ?2" : " AND ?2 = 0";
  const std::string sql =
      "SELECT id, wall_ms, job, task, attempt, worker, what, message FROM events WHERE " + job +
      task + " AND id > ?3 ORDER BY id " + (filter.newest ? "DESC" : "ASC") + " LIMIT ?4";
  Statement rows(database_, sql.c_str());
  rows.bind(filter.job.value).bind(filter.task.value).bind(filter.after);
  rows.bind(static_cast<std::uint64_t>(filter.limit));
  std::vector<PastEvent> events;
  while (rows.step()) {
    PastEvent event;
    event.id = rows.unsigned_integer();
    event.row.wall_ms = rows.integer();
    event.row.job = JobId{rows.unsigned_integer()};
    event.row.task = TaskId{rows.unsigned_integer()};
    event.row.attempt = AttemptId{rows.unsigned_integer()};
    event.row.worker = WorkerId{rows.unsigned_integer()};
    event.row.what = rows.text();
    event.row.message = rows.text();
    events.push_back(std::move(event));
  }
  if (filter.newest) std::reverse(events.begin(), events.end());
  return events;
}

std::vector<TaskRow> JobHistory::tasks(JobId job, TaskId after, std::size_t limit) const {
  const std::string of_job = "AND id IN (" + ids_of_tasks("?2") + ") ";
  const std::string sql = std::string("SELECT ") + task_columns + " FROM tasks WHERE id > ?1 " +
                          (job ? of_job : "AND ?2 = 0 ") + "ORDER BY id LIMIT ?3";
  Statement rows(database_, sql.c_str());
  rows.bind(after.value).bind(job.value).bind(static_cast<std::uint64_t>(limit));
  std::vector<TaskRow> tasks;
  while (rows.step()) tasks.push_back(read_task_columns(rows));
  read_costs(database_, tasks);
  return tasks;
}

std::optional<TaskRow> JobHistory::task(TaskId task) const {
  const std::string sql = std::string("SELECT ") + task_columns + " FROM tasks WHERE id = ?";
  Statement rows(database_, sql.c_str());
  rows.bind(task.value);
  if (!rows.step()) return std::nullopt;
  return read_task_columns(rows);
}

std::vector<SubdomainRow> JobHistory::tree(JobId job) const { return read_tree(database_, job); }

std::vector<SubdomainRow> JobHistory::tree(JobId job, std::uint64_t after,
                                           std::size_t limit) const {
  return read_tree(database_, job, after, limit);
}

std::vector<AttemptRow> JobHistory::running_attempts() const {
  const std::string sql =
      std::string("SELECT ") + attempt_columns + "WHERE state = 'running' ORDER BY id";
  Statement rows(database_, sql.c_str());
  return read_attempts(rows);
}

std::vector<AttemptRow> JobHistory::attempts_of(TaskId task) const {
  const std::string sql = std::string("SELECT ") + attempt_columns + "WHERE task = ? ORDER BY id";
  Statement rows(database_, sql.c_str());
  rows.bind(task.value);
  return read_attempts(rows);
}

std::vector<AttemptRow> JobHistory::attempts_of(JobId job, AttemptId after,
                                                std::size_t limit) const {
  const std::string sql = std::string("SELECT ") + attempt_columns +
                          "JOIN tasks ON tasks.id = task WHERE attempts.id > ?1 AND "
                          "(?2 = 0 OR job = ?2) ORDER BY attempts.id LIMIT ?3";
  Statement rows(database_, sql.c_str());
  rows.bind(after.value).bind(job.value).bind(static_cast<std::uint64_t>(limit));
  return read_attempts(rows);
}

std::optional<std::string> JobHistory::log_of(AttemptId attempt) const {
  Statement rows(database_, "SELECT log FROM attempt_logs WHERE attempt = ?");
  rows.bind(attempt.value);
  if (!rows.step()) return std::nullopt;
  return rows.text();
}

std::vector<WorkerRecord> JobHistory::workers(WorkerId after, std::size_t limit,
                                              bool with_gone) const {
  const std::string sql =
      std::string(worker_columns) +
      ", coalesce(done, 0), coalesce(not_done, 0), coalesce(busy_ms, 0) FROM workers "
      "LEFT JOIN (SELECT worker, sum(state = 'done') AS done, "
      "sum(state NOT IN ('done', 'running')) AS not_done, "
      "sum(CASE WHEN state = 'running' THEN 0 ELSE ended_ms - started_ms END) AS busy_ms "
      "FROM attempts GROUP BY worker) ON worker = id "
      "WHERE id > ?1 AND (?2 OR NOT gone) ORDER BY id LIMIT ?3";
  Statement rows(database_, sql.c_str());
  rows.bind(after.value).bind(with_gone ? 1 : 0).bind(static_cast<std::uint64_t>(limit));
  std::vector<WorkerRecord> workers;
  while (rows.step()) {
    WorkerRecord record;
    record.row = read_worker(rows);
    record.done = rows.unsigned_integer();
    record.not_done = rows.unsigned_integer();
    record.busy_seconds = static_cast<double>(rows.integer()) / 1000;
    workers.push_back(std::move(record));
  }
  return workers;
}

std::optional<WorkerRow> JobHistory::worker(WorkerId id) const {
  const std::string sql = std::string(worker_columns) + " FROM workers WHERE id = ?";
  Statement rows(database_, sql.c_str());
  rows.bind(id.value);
  if (!rows.step()) return std::nullopt;
  return read_worker(rows);
}

}  // namespace tetfarm
