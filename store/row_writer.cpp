#include "store/row_writer.h"

#include <sqlite3.h>

#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

void write_jobs(sqlite3* database, const std::vector<JobRow>& jobs) {
  Statement upsert(database,
                   "INSERT INTO jobs VALUES (?, nullif(?, ''), ?, ?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET name = excluded.name, "
                   "job_toml = excluded.job_toml, phase = excluded.phase, "
                   "exit_code = excluded.exit_code, message = excluded.message, "
                   "finished_ms = excluded.finished_ms");
  for (const JobRow& job : jobs) {
    upsert.bind(job.id.value).bind(job.key).bind(job.name).bind(job.job_toml);
    upsert.bind(std::string(name_of(job.phase))).bind(job.exit_code).bind(job.message);
    upsert.bind(job.created_ms).bind(job.finished_ms).run();
  }
}

void write_artifact(Statement& insert, const std::string& hash, std::uint64_t size) {
  insert.bind(hash).bind(size).run();
}

void write_subdomains(sqlite3* database, Statement& artifact,
                      const std::vector<SubdomainRow>& subdomains) {
  Statement upsert(database,
                   "INSERT INTO subdomains VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT (job, path) DO UPDATE SET parts = excluded.parts, "
                   "state = excluded.state, interdomain_nodes = excluded.interdomain_nodes, "
                   "interior_nodes = excluded.interior_nodes, tets = excluded.tets, "
                   "meshed = excluded.meshed, hash = excluded.hash, "
                   "work = excluded.work, joined_into = excluded.joined_into");
  for (const SubdomainRow& row : subdomains) {
    write_artifact(artifact, row.hash, row.size);
    upsert.bind(row.job.value).bind(row.path).bind(row.parts);
    upsert.bind(std::string(name_of(row.state))).bind(row.interdomain_nodes);
    upsert.bind(row.interior_nodes).bind(row.tets).bind(row.meshed ? 1 : 0).bind(row.hash);
    upsert.bind(row.work).bind(row.joined_into).run();
  }
}

/// One of the two lists of files of a task: forgets the old list and writes the new one.
void write_files(sqlite3* database, Statement& artifact, TaskId task,
                 const std::vector<ArtifactRef>& files, const std::string& table) {
  Statement forget(database, ("DELETE FROM " + table + " WHERE task = ? AND place >= ?").c_str());
  forget.bind(task.value).bind(static_cast<std::uint64_t>(files.size())).run();
  Statement upsert(database, ("INSERT INTO " + table +
                              " VALUES (?, ?, ?, ?) ON CONFLICT (task, place) DO UPDATE SET "
                              "name = excluded.name, hash = excluded.hash")
                                 .c_str());
  for (std::size_t place = 0; place < files.size(); ++place) {
    write_artifact(artifact, files[place].hash, files[place].size);
    upsert.bind(task.value).bind(static_cast<std::uint64_t>(place));
    upsert.bind(files[place].name).bind(files[place].hash).run();
  }
}

void write_values(sqlite3* database, const TaskRow& task) {
  Statement forget(database, "DELETE FROM task_values WHERE task = ?");
  forget.bind(task.id.value).run();
  Statement insert(database, "INSERT INTO task_values VALUES (?, ?, ?, ?, ?)");
  const auto write_texts = [&](const char* sort, const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : texts) {
      insert.bind(task.id.value).bind(std::string(sort)).bind(name).bind_null().bind(text).run();
    }
  };
  write_texts("parameter", task.parameters);
  write_texts("text", task.texts);
  for (const auto& [name, number] : task.numbers) {
    insert.bind(task.id.value).bind(std::string("number")).bind(name);
    insert.bind(number).bind_null().run();
  }
}

void write_tasks(sqlite3* database, Statement& artifact, const std::vector<TaskRow>& tasks) {
  Statement upsert(database,
                   "INSERT INTO tasks VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET state = excluded.state, "
                   "attempt = excluded.attempt, crashes = excluded.crashes, "
                   "losses = excluded.losses, exit_code = excluded.exit_code, "
                   "message = excluded.message, seconds = excluded.seconds, "
                   "peak_rss_bytes = excluded.peak_rss_bytes, "
                   "starvings = excluded.starvings, memory_bytes = excluded.memory_bytes");
  for (const TaskRow& task : tasks) {
    upsert.bind(task.id.value).bind(task.job.value).bind(std::string(name_of(task.kind)));
    upsert.bind(task.path).bind(std::string(name_of(task.state))).bind(task.attempt.value);
    upsert.bind(task.crashes).bind(task.losses).bind(task.exit_code).bind(task.message);
    upsert.bind(task.seconds).bind(task.peak_rss_bytes);
    upsert.bind(task.starvings).bind(task.memory_bytes).run();
    write_files(database, artifact, task.id, task.inputs, "task_inputs");
    write_files(database, artifact, task.id, task.outputs, "task_outputs");
    write_values(database, task);
  }
}

void write_workers(sqlite3* database, const std::vector<WorkerRow>& workers) {
  Statement upsert(database,
                   "INSERT INTO workers VALUES (?, ?, ?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET gone = excluded.gone");
  for (const WorkerRow& worker : workers) {
    upsert.bind(worker.id.value).bind(worker.host).bind(worker.process).bind(worker.cores);
    upsert.bind(worker.memory_bytes).bind(worker.program_version).bind(worker.seen_ms);
    upsert.bind(worker.gone ? 1 : 0).run();
  }
}

void write_attempts(sqlite3* database, const std::vector<AttemptRow>& attempts) {
  Statement upsert(database,
                   "INSERT INTO attempts VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET worker = excluded.worker, "
                   "state = excluded.state, ended_ms = excluded.ended_ms, "
                   "message = excluded.message, rival = excluded.rival, "
                   "peak_rss_bytes = excluded.peak_rss_bytes");
  Statement log(database, "INSERT OR REPLACE INTO attempt_logs VALUES (?, ?)");
  for (const AttemptRow& attempt : attempts) {
    upsert.bind(attempt.id.value).bind(attempt.task.value).bind(attempt.worker.value);
    upsert.bind(std::string(name_of(attempt.state))).bind(attempt.started_ms);
    upsert.bind(attempt.ended_ms).bind(attempt.message).bind(attempt.nonce);
    upsert.bind(attempt.is_rival ? 1 : 0).bind(attempt.memory_bytes);
    upsert.bind(attempt.peak_rss_bytes).run();
    if (!attempt.log.empty()) log.bind(attempt.id.value).bind(attempt.log).run();
  }
}

void write_hosts(sqlite3* database, const std::vector<HostRow>& hosts) {
  Statement upsert(database,
                   "INSERT INTO hosts VALUES (?, ?, ?, ?) "
                   "ON CONFLICT (host) DO UPDATE SET quarantined = excluded.quarantined, "
                   "since_ms = excluded.since_ms, reason = excluded.reason");
  for (const HostRow& host : hosts) {
    upsert.bind(host.host).bind(host.is_quarantined ? 1 : 0);
    upsert.bind(host.since_ms).bind(host.reason).run();
  }
}

void write_events(sqlite3* database, const std::vector<EventRow>& events) {
  Statement insert(database, "INSERT INTO events VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)");
  for (const EventRow& event : events) {
    insert.bind(event.wall_ms).bind(event.job.value).bind(event.task.value);
    insert.bind(event.attempt.value).bind(event.worker.value).bind(event.what);
    insert.bind(event.message).run();
  }
}

}  // namespace

void write_rows(sqlite3* database, const ChangeSet& changes) {
  Statement artifact(database, "INSERT INTO artifacts VALUES (?, ?) ON CONFLICT DO NOTHING");
  write_jobs(database, changes.jobs);
  write_subdomains(database, artifact, changes.subdomains);
  write_tasks(database, artifact, changes.tasks);
  write_workers(database, changes.workers);
  write_attempts(database, changes.attempts);
  write_hosts(database, changes.hosts);
  write_events(database, changes.events);
}

}  // namespace tetfarm
