/// The durable state of the service as plain data: one struct per table of the database.
///
/// The coordinator decides on these rows and hands back the changed ones; job_database writes and
/// reads them. A task's inputs, outputs and values travel inside its row and lie in tables of their
/// own. Units: times are milliseconds since 1970 (for people; no decision depends on them).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/ids.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// waiting: for other jobs; see JobRow::after.
enum class JobPhase { running, done, failed, cancelled, waiting };
/// waiting: an input has to be made again; replaced: its leaf, or another of the job, was cut
/// further, and it is no part of the job any more; the rest as in
/// coordinator/decisions/task_states.dot.
enum class TaskState { waiting, ready, leased, done, failed, replaced };
enum class AttemptState {
  running,
  done,
  failed,
  crashed,
  killed,
  lost,
  returned,
  revoked,
  starved
};
/// joined: a leaf that was joined with others into the one that `joined_into` names.
enum class SubdomainState { open, cut, leaf, joined };

/// The end of what an attempt's process said that is kept.
inline constexpr std::size_t longest_log = 8192;

/// A file as a task knows it.
struct ArtifactRef {
  std::string name;  ///< its part in the task: "surface", "mesh:5"
  std::string hash;
  std::uint64_t size = 0;

  friend bool operator==(const ArtifactRef&, const ArtifactRef&) = default;
};

/// Of a job: from -most_priority to most_priority.
inline constexpr int most_priority = 1000;

struct JobRow {
  JobId id;
  std::string key;  ///< "" : none
  std::string name;
  std::string job_toml;
  JobPhase phase = JobPhase::running;
  int exit_code = 0;
  std::string message;
  std::int64_t created_ms = 0;
  std::int64_t finished_ms = 0;
  std::string owner = {};  ///< the submitter's public key, "": a plain connection; `key` is its own
  std::string content = {};  ///< "NAME HASH" of each input of its inspection, a line each
  int priority = 0;          ///< tasks of jobs with a higher one are handed out first
  /// Jobs that have to be done before it begins, by rising id, all below its own.
  std::vector<JobId> after = {};
  bool end_untold = false;  ///< it has ended, and the administrator's program was not told yet

  friend bool operator==(const JobRow&, const JobRow&) = default;
};

struct TaskRow {
  TaskId id;
  JobId job;
  TaskKind kind = TaskKind::inspect;
  std::uint64_t path = 0;  ///< heap number of the sub-domain, 0: none
  TaskState state = TaskState::ready;
  AttemptId attempt;               ///< the one that holds the lease, or that was accepted; 0: none
  std::uint32_t crashes = 0;       ///< errors: the task's own doing
  std::uint32_t losses = 0;        ///< lost leases and kills from outside
  std::uint32_t oom_count = 0;     ///< out of memory
  std::uint64_t memory_bytes = 0;  ///< asked for after it was out of memory; 0: not known
  std::int32_t exit_code = 0;      ///< of a failed task
  std::string message;             ///< why the last attempt failed
  double seconds = 0;              ///< of the accepted attempt
  std::uint64_t peak_rss_bytes = 0;
  std::vector<ArtifactRef> inputs;                ///< fixed when the task is made
  std::vector<ArtifactRef> outputs;               ///< of a done task; of a failed one the evidence
  std::map<std::string, std::string> parameters;  ///< fixed when the task is made
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;

  friend bool operator==(const TaskRow&, const TaskRow&) = default;
};

struct SubdomainRow {
  JobId job;
  std::uint64_t path = 1;
  std::uint32_t parts = 1;  ///< leaves that it was meant to become
  SubdomainState state = SubdomainState::open;
  std::uint64_t interdomain_nodes = 0;  ///< of its cut
  std::uint64_t interior_nodes = 0;     ///< of its volume mesh
  std::uint64_t tets = 0;
  bool meshed = false;
  std::string hash;  ///< the sub-domain's own file
  std::uint64_t size = 0;
  double work = 0;  ///< estimated elements; of a leaf with all that it was joined with
  std::uint64_t joined_into = 0;  ///< of a joined one: the path of the leaf that holds it, else 0

  friend bool operator==(const SubdomainRow&, const SubdomainRow&) = default;
};

struct AttemptRow {
  AttemptId id;
  TaskId task;
  WorkerId worker;
  AttemptState state = AttemptState::running;
  std::int64_t started_ms = 0;
  std::int64_t ended_ms = 0;
  std::string message;
  std::string nonce_hash;  ///< of the worker's process: nobody else may go on with it
  bool is_rival = false;   ///< races another attempt of its task, which is `TaskRow::attempt`
  std::uint64_t memory_bytes = 0;    ///< room that it was given; 0: not known
  std::uint64_t peak_rss_bytes = 0;  ///< of an ended one, as far as its worker said
  std::string log = {};   ///< what its process said, its end; kept apart and not read with the row
  std::string host = {};  ///< of its worker, in whose row it is kept
  std::string key = {};   ///< public key of the worker's process, "": a plain connection

  friend bool operator==(const AttemptRow&, const AttemptRow&) = default;
};

struct WorkerRow {
  WorkerId id;
  std::string host;
  std::int64_t process = 0;
  std::uint32_t cores = 0;
  std::uint64_t memory_bytes = 0;
  std::string program_version;
  std::int64_t seen_ms = 0;  ///< registration
  bool gone = false;

  friend bool operator==(const WorkerRow&, const WorkerRow&) = default;
};

/// A host that gets no tasks because different ones fail there, until a person lets it go.
struct HostRow {
  std::string host;
  bool is_quarantined = true;
  std::int64_t since_ms = 0;
  std::string reason;

  friend bool operator==(const HostRow&, const HostRow&) = default;
};

/// One line of history. Ids of 0 do not apply.
struct EventRow {
  std::int64_t wall_ms = 0;
  JobId job;
  TaskId task;
  AttemptId attempt;
  WorkerId worker;
  std::string what;  ///< "assigned", "done", "lost" …
  std::string message;

  friend bool operator==(const EventRow&, const EventRow&) = default;
};

using SubdomainKey = std::pair<JobId, std::uint64_t>;

/// Everything that decides what happens next, or the part of it that belongs to some jobs.
/// Attempts: only the running ones.
struct DurableState {
  std::map<JobId, JobRow> jobs;
  std::map<SubdomainKey, SubdomainRow> subdomains;
  std::map<TaskId, TaskRow> tasks;
  std::map<AttemptId, AttemptRow> running_attempts;
  std::map<std::string, HostRow> quarantined_hosts;
  std::uint64_t last_task = 0;  ///< the highest id ever given out
  std::uint64_t last_attempt = 0;
  std::uint64_t last_worker = 0;
  std::uint64_t last_job = 0;
};

/// Rows to insert, replace or remove, in one transaction.
struct ChangeSet {
  std::vector<JobRow> jobs;
  std::vector<SubdomainRow> subdomains;
  std::vector<TaskRow> tasks;
  std::vector<WorkerRow> workers;
  std::vector<AttemptRow> attempts;
  std::vector<HostRow> hosts;
  std::vector<EventRow> events;
  /// Forgotten with all their rows but events. Of a job nothing else changes then.
  std::vector<JobId> removed_jobs = {};

  bool empty() const {
    return jobs.empty() && subdomains.empty() && tasks.empty() && workers.empty() &&
           attempts.empty() && hosts.empty() && events.empty() && removed_jobs.empty();
  }
};

/// Whether nothing more comes of it by itself.
bool is_end(JobPhase phase);

const char* name_of(JobPhase phase);
const char* name_of(TaskState state);
const char* name_of(AttemptState state);
const char* name_of(SubdomainState state);

}  // namespace tetfarm
