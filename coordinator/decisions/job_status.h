/// What a client sees of a job: counted from its rows.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"
#include "tasks/task_contract.h"

namespace tetfarm {

struct JobSummary {
  JobId job;
  std::string name;
  std::string state;  ///< waiting, running, done, failed, cancelled, stuck
  std::string stage;  ///< the first kind of task that is not finished; assemble when all are
  std::uint32_t leaves_made = 0;
  std::uint32_t leaves_meshed = 0;
  std::uint32_t leaves_mended = 0;  ///< that had their turn in cosmetics across cuts
  std::uint64_t elements = 0;
  double estimated_elements = 0;
  std::string message;
  int exit_code = 0;
  std::map<std::string, double> numbers;  ///< balance, assimilation, and of the assembled mesh
  /// Of the assembled mesh; and why sub-domains could not be cut, as "uncut:" and the heap number:
  /// at most 1000 of them, while numbers["uncut"] counts all.
  std::map<std::string, std::string> texts;
  std::vector<ArtifactRef> files;  ///< results of a done job, evidence of a failed one
  std::uint64_t tasks_done = 0;
  std::uint64_t tasks_ready = 0;
  std::uint64_t tasks_running = 0;
  std::uint64_t attempts_lost = 0;
  std::uint64_t crashes = 0;
  std::uint64_t oom_count = 0;      ///< times that a task was out of memory
  std::vector<TaskRow> quarantine;  ///< tasks that failed; at most 100 of them
  std::uint64_t peak_rss_bytes_worker = 0;
  double seconds = 0;
  std::int64_t created_ms = 0;
  std::int64_t finished_ms = 0;  ///< 0: it has not ended
  int priority = 0;
  std::vector<JobId> after = {};      ///< as of a JobRow
  std::vector<JobId> waits_for = {};  ///< those of them that are not done, of a waiting job
};

/// Of the jobs after which it begins those that are not done. One that is not there any more has
/// been removed with age (JobState::remove_old_job), and nobody waits for it.
std::vector<JobId> waits_for(const DurableState& durable, const JobRow& job);

/// "job-3 (wing)"
std::string job_words(const JobRow& job);

/// "waits for job-3 (wing), which is running"; of several the first few.
std::string waiting_words(const DurableState& durable, const JobRow& job);

/// The tasks of each job, by rising id.
using TasksOfJobs = std::map<JobId, std::vector<const TaskRow*>>;
TasksOfJobs tasks_of_jobs(const DurableState& durable);

/// `stuck_message` is empty unless nothing is being handed out for lack of room.
/// @pre `tasks` are the job's. Cost: looks at each of them.
JobSummary summary_of(const DurableState& durable, const JobRow& job,
                      const std::vector<const TaskRow*>& tasks, const std::string& stuck_message,
                      std::int64_t now_wall_ms);
/// Cost: looks at every task of all jobs.
JobSummary summary_of(const DurableState& durable, const JobRow& job,
                      const std::string& stuck_message, std::int64_t now_wall_ms);

/// The surface that the job's sub-domains have their boundary of, when it is the result of this
/// task; nothing otherwise.
std::optional<TaskFile> inspected_surface(const TaskRow& task);

}  // namespace tetfarm
