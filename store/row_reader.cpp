#include "store/row_reader.h"

#include <sqlite3.h>

#include <array>
#include <utility>

#include "base/error.h"
#include "store/job_history.h"
#include "store/sqlite_statement.h"

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
  return value_of(
      name, std::array{JobPhase::running, JobPhase::done, JobPhase::failed, JobPhase::cancelled});
}
TaskState task_state_of(const std::string& name) {
  return value_of(name, std::array{TaskState::waiting, TaskState::ready, TaskState::leased,
                                   TaskState::done, TaskState::failed, TaskState::replaced});
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

TaskKind task_kind_of(const std::string& name) {
  return value_of(
      name, std::array{TaskKind::inspect, TaskKind::decompose, TaskKind::assimilate, TaskKind::mesh,
                       TaskKind::order, TaskKind::extract, TaskKind::cosmetic, TaskKind::number,
                       TaskKind::write, TaskKind::assemble});
}

AttemptState attempt_state_of(const std::string& name) {
  return value_of(name,
                  std::array{AttemptState::running, AttemptState::done, AttemptState::failed,
                             AttemptState::crashed, AttemptState::killed, AttemptState::lost,
                             AttemptState::returned, AttemptState::revoked, AttemptState::starved});
}

DurableState read_state(sqlite3* database) {
  DurableState state;
  load_jobs(database, state);
  load_subdomains(database, state);
  load_tasks(database, state);
  for (AttemptRow& attempt : JobHistory(database).running_attempts()) {
    state.running_attempts.emplace(attempt.id, std::move(attempt));
  }
  load_hosts(database, state);
  state.last_attempt = highest(database,
                               "SELECT max((SELECT coalesce(max(id), 0) FROM attempts), "
                               "(SELECT coalesce(max(value), 0) FROM floors WHERE "
                               "name = 'attempt'))");
  state.last_worker = highest(database, "SELECT coalesce(max(id), 0) FROM workers");
  return state;
}

}  // namespace tetfarm
