#include "cli/stopped_run.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "base/counted.h"
#include "base/error.h"
#include "coordinator/views/store_at_rest.h"
#include "mesh/core/subdomain.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_named = 5;

LostTask lost_task(const wire::Explanation& explanation) {
  const wire::TaskLine& row = explanation.task();
  LostTask lost{row.task(), row.kind(), row.path(), 0};
  if (explanation.attempts().empty()) return lost;
  const wire::AttemptLine& last = *explanation.attempts().rbegin();
  const std::int64_t end = last.ended_ms() == 0 ? wall_ms() : last.ended_ms();
  lost.seconds = static_cast<double>(std::max<std::int64_t>(0, end - last.started_ms())) / 1000;
  return lost;
}

std::string text_of(const LostTask& lost) {
  std::array<char, 40> seconds;
  std::snprintf(seconds.data(), seconds.size(), "%.1f", lost.seconds);
  return lost.kind + of_task_place(lost.kind, lost.path) + ", " + seconds.data() + " s of work";
}

}  // namespace

std::vector<std::uint64_t> tasks_under_way(const wire::StatusReply& farm) {
  std::vector<std::uint64_t> tasks;
  for (const wire::WorkerStatus& worker : farm.at_work()) {
    if (worker.task() != 0) tasks.push_back(worker.task());
  }
  std::sort(tasks.begin(), tasks.end());
  tasks.erase(std::unique(tasks.begin(), tasks.end()), tasks.end());
  return tasks;
}

StoppedRun stopped_run(const std::filesystem::path& store, const std::filesystem::path& database,
                       const std::string& job, const std::vector<std::uint64_t>& under_way) {
  StoppedRun stopped;
  stopped.job = job;
  if (job.empty()) return stopped;
  const StoreAtRest rows(store, database);
  const wire::StatusReply status = rows.status(job);
  if (status.jobs_size() > 0) stopped.tasks_done = status.jobs(0).tasks_done();
  for (const std::uint64_t task : under_way) {
    wire::Query explain;
    explain.set_subject(wire::Query::EXPLAIN);
    explain.set_task(task);
    const wire::QueryReply reply = rows.answer(explain);
    const std::string& state = reply.explanation().task().state();
    if (state != "done" && state != "replaced")
      stopped.lost.push_back(lost_task(reply.explanation()));
  }
  return stopped;
}

std::string stopped_text(const StoppedRun& stopped) {
  if (stopped.job.empty()) return "stopped at a checkpoint: nothing was running\n";
  std::string text = "stopped at a checkpoint: ";
  text += stopped.tasks_done == 0 ? "no task had finished yet"
                                  : counted(stopped.tasks_done, "finished task") +
                                        (stopped.tasks_done == 1 ? " is kept" : " are kept");
  if (stopped.lost.empty()) return text + ", no work is lost\n";
  text += "\nlost, to be done again from the start:";
  for (std::size_t i = 0; i < std::min(most_named, stopped.lost.size()); ++i) {
    text += std::string(i == 0 ? " " : "; ") + text_of(stopped.lost[i]);
  }
  if (stopped.lost.size() > most_named) {
    text += "; and " + std::to_string(stopped.lost.size() - most_named) + " more";
  }
  return text + "\n";
}

std::string stopped_json(const StoppedRun& stopped) {
  nlohmann::ordered_json json = {{"type", "stopped"},
                                 {"job", stopped.job},
                                 {"tasks_done", stopped.tasks_done},
                                 {"tasks_lost", nlohmann::ordered_json::array()},
                                 {"exit_code", static_cast<int>(ExitCode::stopped_at_checkpoint)}};
  for (const LostTask& lost : stopped.lost) {
    json["tasks_lost"].push_back(
        {{"task", lost.task}, {"kind", lost.kind}, {"path", lost.path}, {"seconds", lost.seconds}});
  }
  return json.dump();
}

}  // namespace tetfarm
