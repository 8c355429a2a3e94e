#include "store/schema.h"

#include <sqlite3.h>

#include <array>
#include <string>

#include "base/error.h"
#include "store/job_database.h"
#include "store/sqlite_statement.h"

namespace tetfarm {
namespace {

constexpr const char* first_schema = R"sql(
CREATE TABLE jobs (
  id INTEGER PRIMARY KEY,
  key TEXT UNIQUE,
  name TEXT NOT NULL,
  job_toml TEXT NOT NULL,
  phase TEXT NOT NULL CHECK (phase IN ('running', 'done', 'failed', 'cancelled')),
  exit_code INTEGER NOT NULL,
  message TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  finished_ms INTEGER NOT NULL
) STRICT;
CREATE TABLE artifacts (
  hash TEXT PRIMARY KEY CHECK (length(hash) = 32),
  size INTEGER NOT NULL CHECK (size >= 0)
) STRICT, WITHOUT ROWID;
CREATE TABLE subdomains (
  job INTEGER NOT NULL REFERENCES jobs (id),
  path INTEGER NOT NULL CHECK (path >= 1),
  parts INTEGER NOT NULL CHECK (parts >= 1),
  state TEXT NOT NULL CHECK (state IN ('open', 'cut', 'leaf')),
  interdomain_nodes INTEGER NOT NULL,
  interior_nodes INTEGER NOT NULL,
  tets INTEGER NOT NULL,
  meshed INTEGER NOT NULL CHECK (meshed IN (0, 1)),
  hash TEXT NOT NULL REFERENCES artifacts (hash),
  PRIMARY KEY (job, path)
) STRICT, WITHOUT ROWID;
CREATE TABLE tasks (
  id INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs (id),
  kind TEXT NOT NULL CHECK (kind IN ('inspect', 'decompose', 'mesh', 'number', 'assemble')),
  path INTEGER NOT NULL CHECK (path >= 0),
  state TEXT NOT NULL CHECK (state IN ('waiting', 'ready', 'leased', 'done', 'failed')),
  attempt INTEGER NOT NULL CHECK (attempt > 0 OR state NOT IN ('leased', 'done')),
  crashes INTEGER NOT NULL,
  losses INTEGER NOT NULL,
  exit_code INTEGER NOT NULL,
  message TEXT NOT NULL,
  seconds REAL NOT NULL,
  peak_rss_bytes INTEGER NOT NULL,
  UNIQUE (job, kind, path)
) STRICT;
CREATE TABLE task_inputs (
  task INTEGER NOT NULL REFERENCES tasks (id),
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  hash TEXT NOT NULL REFERENCES artifacts (hash),
  PRIMARY KEY (task, place)
) STRICT, WITHOUT ROWID;
CREATE TABLE task_outputs (
  task INTEGER NOT NULL REFERENCES tasks (id),
  place INTEGER NOT NULL,
  name TEXT NOT NULL,
  hash TEXT NOT NULL REFERENCES artifacts (hash),
  PRIMARY KEY (task, place)
) STRICT, WITHOUT ROWID;
CREATE TABLE task_values (
  task INTEGER NOT NULL REFERENCES tasks (id),
  sort TEXT NOT NULL CHECK (sort IN ('parameter', 'number', 'text')),
  name TEXT NOT NULL,
  number REAL,
  text TEXT,
  PRIMARY KEY (task, sort, name)
) STRICT, WITHOUT ROWID;
CREATE TABLE workers (
  id INTEGER PRIMARY KEY,
  host TEXT NOT NULL,
  process INTEGER NOT NULL,
  cores INTEGER NOT NULL,
  memory_bytes INTEGER NOT NULL,
  program_version TEXT NOT NULL,
  seen_ms INTEGER NOT NULL,
  gone INTEGER NOT NULL CHECK (gone IN (0, 1))
) STRICT;
CREATE TABLE attempts (
  id INTEGER PRIMARY KEY,
  task INTEGER NOT NULL REFERENCES tasks (id),
  worker INTEGER NOT NULL REFERENCES workers (id),
  state TEXT NOT NULL CHECK (state IN ('running', 'done', 'failed', 'crashed', 'killed', 'lost',
                                       'returned', 'revoked')),
  started_ms INTEGER NOT NULL,
  ended_ms INTEGER NOT NULL,
  message TEXT NOT NULL
) STRICT;
CREATE UNIQUE INDEX one_running_attempt ON attempts (task) WHERE state = 'running';
CREATE TABLE events (
  id INTEGER PRIMARY KEY,
  wall_ms INTEGER NOT NULL,
  job INTEGER NOT NULL,
  task INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  worker INTEGER NOT NULL,
  what TEXT NOT NULL,
  message TEXT NOT NULL
) STRICT;
CREATE INDEX events_of_job ON events (job);
)sql";

/// Which kinds of task there are is left to the reader of the rows, so that a new one needs no new
/// table.
constexpr const char* any_kind_of_task = R"sql(
CREATE TABLE new_tasks (
  id INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs (id),
  kind TEXT NOT NULL,
  path INTEGER NOT NULL CHECK (path >= 0),
  state TEXT NOT NULL CHECK (state IN ('waiting', 'ready', 'leased', 'done', 'failed')),
  attempt INTEGER NOT NULL CHECK (attempt > 0 OR state NOT IN ('leased', 'done')),
  crashes INTEGER NOT NULL,
  losses INTEGER NOT NULL,
  exit_code INTEGER NOT NULL,
  message TEXT NOT NULL,
  seconds REAL NOT NULL,
  peak_rss_bytes INTEGER NOT NULL,
  UNIQUE (job, kind, path)
) STRICT;
INSERT INTO new_tasks SELECT * FROM tasks;
DROP TABLE tasks;
ALTER TABLE new_tasks RENAME TO tasks;
)sql";

/// Assimilation: a state of sub-domains, whose list is left to the reader too, and two columns.
constexpr const char* joined_subdomains = R"sql(
CREATE TABLE new_subdomains (
  job INTEGER NOT NULL REFERENCES jobs (id),
  path INTEGER NOT NULL CHECK (path >= 1),
  parts INTEGER NOT NULL CHECK (parts >= 1),
  state TEXT NOT NULL,
  interdomain_nodes INTEGER NOT NULL,
  interior_nodes INTEGER NOT NULL,
  tets INTEGER NOT NULL,
  meshed INTEGER NOT NULL CHECK (meshed IN (0, 1)),
  hash TEXT NOT NULL REFERENCES artifacts (hash),
  work REAL NOT NULL,
  joined_into INTEGER NOT NULL,
  PRIMARY KEY (job, path)
) STRICT, WITHOUT ROWID;
INSERT INTO new_subdomains SELECT *, 0, 0 FROM subdomains;
DROP TABLE subdomains;
ALTER TABLE new_subdomains RENAME TO subdomains;
)sql";

/// Out of memory is counted apart; an attempt knows whose process it is and what room it has; two
/// attempts of a task may race; hosts may be in quarantine.
constexpr const char* quarantine = R"sql(
ALTER TABLE tasks ADD COLUMN starvings INTEGER NOT NULL DEFAULT 0;
ALTER TABLE tasks ADD COLUMN memory_bytes INTEGER NOT NULL DEFAULT 0;
CREATE TABLE new_attempts (
  id INTEGER PRIMARY KEY,
  task INTEGER NOT NULL REFERENCES tasks (id),
  worker INTEGER NOT NULL REFERENCES workers (id),
  state TEXT NOT NULL,
  started_ms INTEGER NOT NULL,
  ended_ms INTEGER NOT NULL,
  message TEXT NOT NULL,
  nonce TEXT NOT NULL,
  rival INTEGER NOT NULL CHECK (rival IN (0, 1)),
  memory_bytes INTEGER NOT NULL
) STRICT;
INSERT INTO new_attempts SELECT *, '', 0, 0 FROM attempts;
DROP TABLE attempts;
ALTER TABLE new_attempts RENAME TO attempts;
CREATE UNIQUE INDEX one_running_attempt ON attempts (task, rival) WHERE state = 'running';
CREATE TABLE hosts (
  host TEXT PRIMARY KEY,
  quarantined INTEGER NOT NULL CHECK (quarantined IN (0, 1)),
  since_ms INTEGER NOT NULL,
  reason TEXT NOT NULL
) STRICT, WITHOUT ROWID;
)sql";

/// What an attempt took and said, for people; ids that a restored database must not give out again.
constexpr const char* history = R"sql(
ALTER TABLE attempts ADD COLUMN peak_rss_bytes INTEGER NOT NULL DEFAULT 0;
CREATE INDEX attempts_of_task ON attempts (task);
CREATE TABLE attempt_logs (
  attempt INTEGER PRIMARY KEY REFERENCES attempts (id),
  log TEXT NOT NULL
) STRICT;
CREATE TABLE floors (
  name TEXT PRIMARY KEY CHECK (name = 'attempt'),
  value INTEGER NOT NULL CHECK (value >= 0)
) STRICT, WITHOUT ROWID;
)sql";

/// Leaves that are cut further: the tasks that were theirs stay as rows, in a state whose list is
/// left to the reader, and others have their places.
constexpr const char* replaced_tasks = R"sql(
CREATE TABLE new_tasks (
  id INTEGER PRIMARY KEY,
  job INTEGER NOT NULL REFERENCES jobs (id),
  kind TEXT NOT NULL,
  path INTEGER NOT NULL CHECK (path >= 0),
  state TEXT NOT NULL,
  attempt INTEGER NOT NULL CHECK (attempt > 0 OR state NOT IN ('leased', 'done')),
  crashes INTEGER NOT NULL,
  losses INTEGER NOT NULL,
  exit_code INTEGER NOT NULL,
  message TEXT NOT NULL,
  seconds REAL NOT NULL,
  peak_rss_bytes INTEGER NOT NULL,
  starvings INTEGER NOT NULL,
  memory_bytes INTEGER NOT NULL
) STRICT;
INSERT INTO new_tasks SELECT * FROM tasks;
DROP TABLE tasks;
ALTER TABLE new_tasks RENAME TO tasks;
CREATE UNIQUE INDEX one_task_in_a_place ON tasks (job, kind, path) WHERE state <> 'replaced';
)sql";

/// One job's tasks are read alone: those in their places by the index of places, the others by
/// this. And the sorts of a value are compared one by one: for a list in a CHECK SQLite makes a
/// table of its own for each row that is written, a quarter of what a task cost.
constexpr const char* tasks_of_one_job = R"sql(
CREATE INDEX replaced_tasks_of_job ON tasks (job) WHERE state = 'replaced';
CREATE TABLE new_task_values (
  task INTEGER NOT NULL REFERENCES tasks (id),
  sort TEXT NOT NULL CHECK (sort = 'parameter' OR sort = 'number' OR sort = 'text'),
  name TEXT NOT NULL,
  number REAL,
  text TEXT,
  PRIMARY KEY (task, sort, name)
) STRICT, WITHOUT ROWID;
INSERT INTO new_task_values SELECT * FROM task_values;
DROP TABLE task_values;
ALTER TABLE new_task_values RENAME TO task_values;
)sql";

/// A submission's key is its submitter's own, and stands for one content: the inputs of the job's
/// inspection. Of an attempt's process the key is kept, and of its nonce only a hash: what earlier
/// programs wrote is forgotten, and an attempt that runs belongs to nobody and is made again.
constexpr const char* who_it_belongs_to = R"sql(
CREATE TABLE new_jobs (
  id INTEGER PRIMARY KEY,
  key TEXT,
  name TEXT NOT NULL,
  job_toml TEXT NOT NULL,
  phase TEXT NOT NULL,
  exit_code INTEGER NOT NULL,
  message TEXT NOT NULL,
  created_ms INTEGER NOT NULL,
  finished_ms INTEGER NOT NULL,
  owner TEXT NOT NULL,
  content TEXT NOT NULL
) STRICT;
INSERT INTO new_jobs SELECT jobs.*, '', coalesce(
  (SELECT group_concat(line, char(10)) FROM
    (SELECT task_inputs.name || ' ' || hash AS line FROM tasks
     JOIN task_inputs ON task_inputs.task = tasks.id
     WHERE tasks.job = jobs.id AND kind = 'inspect' AND path = 0 AND state <> 'replaced'
     ORDER BY place)), '') FROM jobs;
DROP TABLE jobs;
ALTER TABLE new_jobs RENAME TO jobs;
CREATE UNIQUE INDEX one_job_of_a_key ON jobs (owner, key);
ALTER TABLE attempts RENAME COLUMN nonce TO nonce_hash;
UPDATE attempts SET nonce_hash = '';
ALTER TABLE attempts ADD COLUMN key TEXT NOT NULL DEFAULT '';
)sql";

/// Which jobs' tasks are handed out first.
constexpr const char* priorities = R"sql(
ALTER TABLE jobs ADD COLUMN priority INTEGER NOT NULL DEFAULT 0;
)sql";

/// Jobs wait for others, and are removed with age: ids of what was removed are never given out
/// again.
constexpr const char* dependencies = R"sql(
ALTER TABLE jobs ADD COLUMN waits_for TEXT NOT NULL DEFAULT '';
ALTER TABLE jobs ADD COLUMN end_untold INTEGER NOT NULL DEFAULT 0;
CREATE TABLE new_floors (
  name TEXT PRIMARY KEY,
  value INTEGER NOT NULL CHECK (value >= 0)
) STRICT, WITHOUT ROWID;
INSERT INTO new_floors SELECT * FROM floors;
DROP TABLE floors;
ALTER TABLE new_floors RENAME TO floors;
)sql";

constexpr std::array<const char*, database_version> migrations = {
    first_schema,   any_kind_of_task, joined_subdomains, quarantine, history,
    replaced_tasks, tasks_of_one_job, who_it_belongs_to, priorities, dependencies};

std::int64_t pragma(sqlite3* database, const char* sql) {
  Statement statement(database, sql);
  statement.step();
  return statement.integer();
}

}  // namespace

int schema_version(sqlite3* database) {
  return static_cast<int>(pragma(database, "PRAGMA user_version"));
}

void migrate(sqlite3* database) {
  const std::int64_t version = pragma(database, "PRAGMA user_version");
  const std::int64_t owner = pragma(database, "PRAGMA application_id");
  const bool is_empty = pragma(database, "SELECT count(*) FROM sqlite_schema") == 0;
  const std::string path = sqlite3_db_filename(database, "main");
  if (!is_empty && owner != application_id) throw CorruptFile("is not a tetfarm database", path);
  if (version > database_version) {
    throw CorruptFile(
        "was written by a newer tetfarm (database version " + std::to_string(version) + ")", path);
  }
  if (version < 0) throw CorruptFile("has an impossible database version", path);
  if (version == database_version) return;
  std::string sql = "BEGIN IMMEDIATE;";
  for (auto next = static_cast<std::size_t>(version); next < migrations.size(); ++next) {
    sql += migrations[next];
  }
  sql += "PRAGMA application_id = " + std::to_string(application_id) +
         ";PRAGMA user_version = " + std::to_string(database_version) + ";COMMIT;";
  execute(database, sql.c_str());
}

}  // namespace tetfarm
