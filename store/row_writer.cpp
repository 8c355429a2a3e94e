#include "store/row_writer.h"

#include <sqlite3.h>

#include "base/check.h"
#include "store/row_reader.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

using Files = std::vector<ArtifactRef>;

constexpr const char* put_job =
    "INSERT INTO jobs VALUES (?, nullif(?, ''), ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
    "ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
    "job_toml = excluded.job_toml, phase = excluded.phase, "
    "exit_code = excluded.exit_code, message = excluded.message, "
    "finished_ms = excluded.finished_ms, priority = excluded.priority, "
    "end_untold = excluded.end_untold";
constexpr const char* put_artifact = "INSERT INTO artifacts VALUES (?, ?) ON CONFLICT DO NOTHING";
constexpr const char* put_subdomain =
    "INSERT INTO subdomains VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
    "ON CONFLICT (job, path) DO UPDATE SET parts = excluded.parts, "
    "state = excluded.state, interdomain_nodes = excluded.interdomain_nodes, "
    "interior_nodes = excluded.interior_nodes, tets = excluded.tets, "
    "meshed = excluded.meshed, hash = excluded.hash, "
    "work = excluded.work, joined_into = excluded.joined_into";
constexpr const char* update_task =
    "UPDATE tasks SET state = ?2, attempt = ?3, crashes = ?4, losses = ?5, exit_code = ?6, "
    "message = ?7, seconds = ?8, peak_rss_bytes = ?9, starvings = ?10, memory_bytes = ?11 "
    "WHERE id = ?1";
constexpr const char* insert_task =
    "INSERT INTO tasks (id, state, attempt, crashes, losses, exit_code, message, seconds, "
    "peak_rss_bytes, starvings, memory_bytes, job, kind, path) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";
constexpr const char* insert_input = "INSERT INTO task_inputs VALUES (?, ?, ?, ?)";
// Looking costs a tenth of a DELETE that finds nothing: SQLite gives that a table for the keys.
constexpr const char* find_result =
    "SELECT EXISTS (SELECT 1 FROM task_outputs WHERE task = ?1 AND place >= ?2), "
    "EXISTS (SELECT 1 FROM task_values WHERE task = ?1 AND sort = 'number') "
    "OR EXISTS (SELECT 1 FROM task_values WHERE task = ?1 AND sort = 'text')";
constexpr const char* forget_outputs = "DELETE FROM task_outputs WHERE task = ? AND place >= ?";
constexpr const char* put_output =
    "INSERT INTO task_outputs VALUES (?, ?, ?, ?) ON CONFLICT (task, place) DO UPDATE SET "
    "name = excluded.name, hash = excluded.hash";
constexpr const char* forget_result =
    "DELETE FROM task_values WHERE task = ? AND sort IN ('number', 'text')";
constexpr const char* insert_value = "INSERT INTO task_values VALUES (?, ?, ?, ?, ?)";
constexpr const char* put_worker =
    "INSERT INTO workers VALUES (?, ?, ?, ?, ?, ?, ?, ?) "
    "ON CONFLICT (id) DO UPDATE SET gone = excluded.gone";
constexpr const char* put_attempt =
    "INSERT INTO attempts VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
    "ON CONFLICT (id) DO UPDATE SET worker = excluded.worker, "
    "state = excluded.state, ended_ms = excluded.ended_ms, "
    "message = excluded.message, rival = excluded.rival, "
    "peak_rss_bytes = excluded.peak_rss_bytes";
constexpr const char* put_log = "INSERT OR REPLACE INTO attempt_logs VALUES (?, ?)";
constexpr const char* put_host =
    "INSERT INTO hosts VALUES (?, ?, ?, ?) "
    "ON CONFLICT (host) DO UPDATE SET quarantined = excluded.quarantined, "
    "since_ms = excluded.since_ms, reason = excluded.reason";
constexpr const char* insert_event = "INSERT INTO events VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)";

std::string ids_text(const std::vector<JobId>& jobs) {
  std::string words;
  for (const JobId job : jobs) words += (words.empty() ? "" : " ") + std::to_string(job.value);
  return words;
}

}  // namespace

RowWriter::RowWriter(sqlite3* database)
    : database_(database),
      job_(database, put_job),
      artifact_(database, put_artifact),
      subdomain_(database, put_subdomain),
      task_update_(database, update_task),
      task_insert_(database, insert_task),
      input_(database, insert_input),
      result_find_(database, find_result),
      output_forget_(database, forget_outputs),
      output_(database, put_output),
      result_forget_(database, forget_result),
      value_(database, insert_value),
      worker_(database, put_worker),
      attempt_(database, put_attempt),
      log_(database, put_log),
      host_(database, put_host),
      event_(database, insert_event) {}

void RowWriter::write(const ChangeSet& changes) {
  TF_CHECK(sqlite3_get_autocommit(database_) == 0);  // within a transaction
  for (const JobRow& job : changes.jobs) write(job);
  for (const SubdomainRow& subdomain : changes.subdomains) write(subdomain);
  for (const TaskRow& task : changes.tasks) write(task);
  for (const WorkerRow& worker : changes.workers) write(worker);
  for (const AttemptRow& attempt : changes.attempts) write(attempt);
  for (const HostRow& host : changes.hosts) write(host);
  for (const EventRow& event : changes.events) write(event);
  for (const JobId job : changes.removed_jobs) remove(job);
}

void RowWriter::write(const JobRow& job) {
  TF_CHECK(job.id);
  job_.bind(job.id.value).bind(job.key).bind(job.name).bind(job.job_toml);
  job_.bind(name_of(job.phase)).bind(job.exit_code).bind(job.message);
  job_.bind(job.created_ms).bind(job.finished_ms).bind(job.owner).bind(job.content);
  job_.bind(job.priority).bind(ids_text(job.after)).bind(job.end_untold ? 1 : 0).run();
}

void RowWriter::write(const SubdomainRow& row) {
  TF_CHECK(row.job && row.path >= 1);
  artifact_.bind(row.hash).bind(row.size).run();
  subdomain_.bind(row.job.value).bind(row.path).bind(row.parts);
  subdomain_.bind(name_of(row.state)).bind(row.interdomain_nodes);
  subdomain_.bind(row.interior_nodes).bind(row.tets).bind(row.meshed ? 1 : 0).bind(row.hash);
  subdomain_.bind(row.work).bind(row.joined_into).run();
}

/// One of the two lists of files of a task.
void RowWriter::write_files(Statement& statement, TaskId task, const Files& files) {
  for (std::size_t place = 0; place < files.size(); ++place) {
    artifact_.bind(files[place].hash).bind(files[place].size).run();
    statement.bind(task.value).bind(static_cast<std::uint64_t>(place));
    statement.bind(files[place].name).bind(files[place].hash).run();
  }
}

void RowWriter::write_texts(TaskId task, const char* sort,
                            const std::map<std::string, std::string>& texts) {
  for (const auto& [name, text] : texts) {
    value_.bind(task.value).bind(sort).bind(name).bind_null().bind(text).run();
  }
}

Statement& RowWriter::bind_progress(Statement& statement, const TaskRow& task) {
  TF_CHECK(task.id);
  statement.bind(task.id.value).bind(name_of(task.state)).bind(task.attempt.value);
  statement.bind(task.crashes).bind(task.losses).bind(task.exit_code).bind(task.message);
  statement.bind(task.seconds).bind(task.peak_rss_bytes);
  return statement.bind(task.oom_count).bind(task.memory_bytes);
}

/// Of the files those that are not written over.
void RowWriter::forget_old_result(const TaskRow& task) {
  const auto count = static_cast<std::uint64_t>(task.outputs.size());
  const bool has_row = result_find_.bind(task.id.value).bind(count).step();
  const bool has_files = result_find_.integer() != 0;
  const bool has_values = result_find_.integer() != 0;
  result_find_.rewind();
  TF_CHECK(has_row);
  if (has_files) output_forget_.bind(task.id.value).bind(count).run();
  if (has_values) result_forget_.bind(task.id.value).run();
}

/// What a task reads is written once, with its first row: it never changes.
void RowWriter::write(const TaskRow& task) {
  bind_progress(task_update_, task).run();
  const bool is_new = sqlite3_changes(database_) == 0;
  if (is_new) {
    bind_progress(task_insert_, task).bind(task.job.value);
    TF_CHECK(task.job);
    task_insert_.bind(name_of(task.kind)).bind(task.path).run();
    write_files(input_, task.id, task.inputs);
    write_texts(task.id, "parameter", task.parameters);
  } else {
    forget_old_result(task);
  }
  write_files(output_, task.id, task.outputs);
  write_texts(task.id, "text", task.texts);
  for (const auto& [name, number] : task.numbers) {
    value_.bind(task.id.value).bind("number").bind(name).bind(number).bind_null().run();
  }
}

void RowWriter::write(const WorkerRow& worker) {
  TF_CHECK(worker.id);
  worker_.bind(worker.id.value).bind(worker.host).bind(worker.process).bind(worker.cores);
  worker_.bind(worker.memory_bytes).bind(worker.program_version).bind(worker.seen_ms);
  worker_.bind(worker.gone ? 1 : 0).run();
}

void RowWriter::write(const AttemptRow& attempt) {
  TF_CHECK(attempt.id && attempt.task);
  attempt_.bind(attempt.id.value).bind(attempt.task.value).bind(attempt.worker.value);
  attempt_.bind(name_of(attempt.state)).bind(attempt.started_ms);
  attempt_.bind(attempt.ended_ms).bind(attempt.message).bind(attempt.nonce_hash);
  attempt_.bind(attempt.is_rival ? 1 : 0).bind(attempt.memory_bytes);
  attempt_.bind(attempt.peak_rss_bytes).bind(attempt.key).run();
  if (!attempt.log.empty()) log_.bind(attempt.id.value).bind(attempt.log).run();
}

void RowWriter::write(const HostRow& host) {
  host_.bind(host.host).bind(host.is_quarantined ? 1 : 0);
  host_.bind(host.since_ms).bind(host.reason).run();
}

void RowWriter::write(const EventRow& event) {
  event_.bind(event.wall_ms).bind(event.job.value).bind(event.task.value);
  event_.bind(event.attempt.value).bind(event.worker.value).bind(event.what);
  event_.bind(event.message).run();
}

/// What points to a row goes before it. Rare, so nothing is prepared for it.
void RowWriter::remove(JobId job) {
  TF_CHECK(job);
  for (const std::string& kind :
       {std::string("attempt"), std::string("task"), std::string("job")}) {
    const std::string floor = "INSERT INTO floors SELECT '" + kind +
                              "', coalesce(max(id), 0) FROM " + kind +
                              "s WHERE true ON CONFLICT (name) DO UPDATE SET value = max(value, "
                              "excluded.value)";
    execute(database_, floor.c_str());
  }
  const std::string tasks = "(" + ids_of_tasks("?1") + ")";
  for (const std::string& rows :
       {"attempt_logs WHERE attempt IN (SELECT id FROM attempts WHERE task IN " + tasks + ")",
        "attempts WHERE task IN " + tasks, "task_inputs WHERE task IN " + tasks,
        "task_outputs WHERE task IN " + tasks, "task_values WHERE task IN " + tasks,
        std::string("subdomains WHERE job = ?1"), "tasks WHERE id IN " + tasks,
        std::string("jobs WHERE id = ?1")}) {
    Statement removal(database_, ("DELETE FROM " + rows).c_str());
    removal.bind(job.value).run();
  }
}

}  // namespace tetfarm
