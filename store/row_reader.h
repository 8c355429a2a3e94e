/// Reads the rows that decide what happens next; the other half of JobDatabase::load.
///
/// All functions: @throws IoError, CorruptFile. Cost: what is read, but for history.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"
#include "tasks/task_kind.h"

struct sqlite3;

namespace tetfarm {

class Statement;

enum class JobsToRead { all, unfinished };

/// Of jobs that are not to be read only their own rows come, in `jobs`.
DurableState read_state(sqlite3* database, JobsToRead jobs);

/// The job's own row, tasks and sub-domains; no attempts, nothing when there is no such job.
DurableState read_job(sqlite3* database, JobId job);
std::optional<TaskRow> read_task(sqlite3* database, TaskId task);
/// The sub-domains of a job by rising path.
std::vector<SubdomainRow> read_tree(sqlite3* database, JobId job);
std::vector<SubdomainRow> read_tree(sqlite3* database, JobId job, std::uint64_t after,
                                    std::size_t limit);

/// The SQL that gives the ids of all tasks of some jobs, which are SQL too; each half by its index.
std::string ids_of_tasks(const std::string& jobs);

/// What of a task lies in its own table, and the task of a row of these: without files and values.
inline constexpr const char* task_columns =
    "id, job, kind, path, state, attempt, crashes, losses, exit_code, message, seconds, "
    "peak_rss_bytes, starvings, memory_bytes";
TaskRow read_task_columns(Statement& rows);

/// The states of an attempt and the kinds of a task by their names. @throws CorruptFile.
AttemptState attempt_state_of(const std::string& name);
TaskKind task_kind_of(const std::string& name);

}  // namespace tetfarm
