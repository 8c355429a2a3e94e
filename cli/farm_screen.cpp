#include "cli/farm_screen.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/check.h"
#include "base/counted.h"
#include "base/mebibytes.h"
#include "base/utf8.h"
#include "cli/progress_display.h"
#include "cli/text_table.h"
#include "json/job_share.h"
#include "json/reply_values.h"
#include "proto/doing.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

bool still_runs(const wire::JobStatus& job) {
  return job.state() == "running" || job.state() == "stuck";
}

/// Those that run come first, then those that wait for others.
int place_among_jobs(const wire::JobStatus& job) {
  if (still_runs(job)) return 0;
  return job.state() == "waiting" ? 1 : 2;
}

std::string head_of(const SeenFarm& seen) {
  std::uint64_t waiting = 0;
  std::uint64_t running = 0;
  std::uint64_t in_quarantine = 0;
  std::uint64_t jobs = 0;
  for (const wire::JobStatus& job : seen.status.jobs()) {
    in_quarantine += static_cast<std::uint64_t>(job.quarantine_size());
    if (!still_runs(job)) continue;
    ++jobs;
    waiting += job.tasks_ready();
    running += job.tasks_running();
  }
  std::string text = counted(jobs, "job") + (jobs == 1 ? " runs; " : " run; ") +
                     counted(waiting, "task") + (waiting == 1 ? " waits, " : " wait, ") +
                     std::to_string(running) + (running == 1 ? " runs" : " run");
  if (in_quarantine > 0) text += ", " + std::to_string(in_quarantine) + " in quarantine";
  text += "; " + counted(seen.status.workers(), "worker") + "\n";
  if (!seen.status.trouble().empty()) text += harmless(seen.status.trouble()) + "\n";
  return text;
}

/// What a worker does, and since when.
std::vector<std::string> row_of_worker(const wire::WorkerLine& worker,
                                       const std::map<std::uint64_t, wire::RunningTask>& running) {
  std::string task = worker.task() == 0 ? "" : std::to_string(worker.task());
  std::string seconds;
  std::string does = doing_text(worker.doing());
  const auto found = running.find(worker.task());
  if (found != running.end()) {
    const wire::RunningTask& known = found->second;
    seconds = clock_text(known.seconds());
    task += " " + known.kind() +
            (known.path() == 0 ? "" : " " + task_place(known.kind(), known.path()));
  }
  return {worker_name(worker.worker()),
          worker.host(),
          worker.state(),
          mebibytes(worker.memory_bytes()),
          task,
          seconds,
          does};
}

std::string workers_of(const SeenFarm& seen) {
  std::map<std::uint64_t, wire::RunningTask> running;
  for (const wire::JobStatus& job : seen.status.jobs()) {
    for (const wire::RunningTask& task : job.running()) running[task.task()] = task;
  }
  std::vector<const wire::WorkerLine*> workers;
  for (const wire::WorkerLine& worker : seen.workers) workers.push_back(&worker);
  std::stable_sort(workers.begin(), workers.end(),
                   [](const wire::WorkerLine* a, const wire::WorkerLine* b) {
                     return (a->task() != 0) > (b->task() != 0);
                   });
  std::vector<std::vector<std::string>> rows;
  for (const wire::WorkerLine* worker : workers) rows.push_back(row_of_worker(*worker, running));
  return table_text({"WORKER", "HOST", "STATE", "MEMORY", "TASK", "SINCE", "DOES"}, rows);
}

}  // namespace

std::vector<std::string> FarmScreen::row_of(const wire::JobStatus& job, std::int64_t now_ms) {
  SeenJob& seen = jobs_[job.job()];
  seen.rate.note(job, now_ms);
  seen.share = std::max(seen.share, share_of_job(job, seen.rate.share()));
  TF_CHECK(seen.share >= 0 && seen.share <= 1);
  const auto left_s = seconds_of_meshing_left(job, seen.rate.tets_per_second());
  const std::string leaves = job.leaves_made() == 0 ? ""
                                                    : std::to_string(job.leaves_meshed()) + "/" +
                                                          std::to_string(job.leaves_made());
  return {job.job(),
          job.name(),
          job.state(),
          still_runs(job) ? job.stage() : "",
          std::to_string(std::lround(std::floor(100 * seen.share))) + " %",
          leaves,
          job.elements() == 0 ? "" : short_count(static_cast<double>(job.elements())),
          std::to_string(job.tasks_running()) + "+" + std::to_string(job.tasks_ready()),
          clock_text(job.seconds()),
          left_s ? clock_text(*left_s) : ""};
}

std::string FarmScreen::text(const SeenFarm& seen, std::int64_t now_ms) {
  std::vector<const wire::JobStatus*> jobs;
  for (const wire::JobStatus& job : seen.status.jobs()) jobs.push_back(&job);
  std::reverse(jobs.begin(), jobs.end());
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const wire::JobStatus* a, const wire::JobStatus* b) {
                     return place_among_jobs(*a) < place_among_jobs(*b);
                   });
  std::vector<std::vector<std::string>> rows;
  for (const wire::JobStatus* job : jobs) rows.push_back(row_of(*job, now_ms));
  const std::string table = table_text(
      {"JOB", "NAME", "STATE", "STAGE", "DONE", "SUB-DOMAINS", "ELEMENTS", "TASKS", "TIME", "ETA"},
      rows);
  const std::string workers = workers_of(seen);
  return head_of(seen) + (table.empty() ? "" : "\n") + table + (workers.empty() ? "" : "\n") +
         workers;
}

std::string cut_to_screen(const std::string& text, std::size_t lines, std::size_t columns) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    all.emplace_back(columns == 0 ? line : cut_utf8(line, columns));
  }
  if (lines > 1 && all.size() > lines) {
    const std::size_t left_out = all.size() - lines + 1;
    all.resize(lines - 1);
    all.push_back("... " + counted(left_out, "line") + " more");
  }
  std::string shown;
  for (const std::string& line : all) shown += (shown.empty() ? "" : "\n") + line;
  return shown;
}

}  // namespace tetfarm
