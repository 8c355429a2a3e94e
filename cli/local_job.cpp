#include "cli/local_job.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>
#include <utility>

#include "base/clock.h"
#include "base/counted.h"
#include "base/error_with_help.h"
#include "cli/coordinator_connection.h"
#include "cli/deliver_files.h"
#include "cli/job_outcome.h"
#include "cli/local_farm.h"
#include "cli/progress_display.h"
#include "cli/progress_lines.h"
#include "cli/stopped_run.h"
#include "cli/watched_farm.h"
#include "cli/workers_wanted.h"
#include "dashboard/dashboard.h"

namespace tetfarm {
namespace {

constexpr std::int64_t quickest_look_ms = 5;
constexpr std::int64_t slowest_look_ms = 200;
/// The end of a job is noticed late by at most this share of what it took.
constexpr std::int64_t looks_in_run = 16;
constexpr std::int64_t answer_ms = 500;
constexpr std::int64_t coordinator_start_ms = 60'000;

volatile std::sig_atomic_t stop_signals = 0;

void note_stop(int) { stop_signals = stop_signals + 1; }
bool is_stopped() { return stop_signals > 0; }
bool is_in_hurry() { return stop_signals > 1; }

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int worker_count(const RunOptions& options) {
  return options.workers > 0 ? options.workers : cores();
}

void remark_on_workers(const RunOptions& options) {
  if (options.workers <= cores()) return;
  std::fprintf(stderr,
               "note: -j %d is more than the %s here; the extra workers start only when there are "
               "tasks for them\n",
               options.workers, counted(static_cast<std::uint64_t>(cores()), "core").c_str());
}

/// Asks until the coordinator answers, starting it again when it dies; nothing when told to stop.
template <class Answer, class Question>
std::optional<Answer> ask_patiently(LocalFarm& farm, const Question& question) {
  const std::int64_t until = steady_ms() + coordinator_start_ms;
  while (!is_stopped()) {
    farm.look_after();
    try {
      return question();
    } catch (const Error& error) {
      if (error.code() != ExitCode::not_found || steady_ms() > until) throw;
    }
  }
  return std::nullopt;
}

/// Follows the job to its end; nothing when told to stop first.
std::optional<wire::JobStatus> follow(LocalFarm& farm, CoordinatorConnection& connection,
                                      const std::string& job, ProgressDisplay& display) {
  const std::int64_t start = steady_ms();
  while (true) {
    const auto reply =
        ask_patiently<wire::StatusReply>(farm, [&] { return connection.status(job, answer_ms); });
    if (!reply) return std::nullopt;
    if (!reply->trouble().empty()) {
      throw Error(static_cast<ExitCode>(reply->trouble_code()), reply->trouble());
    }
    if (reply->jobs_size() == 0) throw Error(ExitCode::failed, "the coordinator lost " + job);
    const wire::JobStatus& status = reply->jobs(0);
    display.show_forecast(status);
    if (has_ended(status)) return status;
    if (status.state() == "stuck") throw Error(ExitCode::out_of_resources, status.message());
    display.show(status, reply->workers());
    farm.grow(workers_wanted(*reply));
    const std::int64_t pause_ms =
        std::clamp((steady_ms() - start) / looks_in_run, quickest_look_ms, slowest_look_ms);
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
  }
}

/// Nothing is known of a coordinator that does not answer.
std::vector<std::uint64_t> ask_what_is_under_way(CoordinatorConnection& connection) {
  try {
    return tasks_under_way(connection.farm(answer_ms));
  } catch (const Error&) {
    return {};
  }
}

/// Browsers see the farm while it lives; standard error says where.
std::unique_ptr<Dashboard> dashboard_of(const RunOptions& options,
                                        const std::filesystem::path& store, const LocalFarm& farm) {
  if (!options.is_watched) return nullptr;
  ViewOptions view;
  view.client.endpoint = farm.endpoint();
  view.store = store.string();
  auto dashboard = std::make_unique<Dashboard>(
      DashboardOptions{.address = options.http_address, .token_file = {}, .acts = false},
      std::make_unique<WatchedFarm>(view));
  std::fprintf(stderr, "watch it at %s\n", dashboard->url().c_str());
  return dashboard;
}

LocalOutcome work(const RunOptions& options, const std::filesystem::path& store,
                  const wire::Submit& submit) {
  LocalFarm farm({.store = store,
                  .database = options.database,
                  .workers = worker_count(options),
                  .first_workers = std::min(worker_count(options), cores()),
                  .grace_s = options.grace_s,
                  .runs_solvers = options.runs_solvers});
  std::unique_ptr<Dashboard> dashboard = dashboard_of(options, store, farm);
  CoordinatorConnection connection(farm.endpoint());
  ProgressDisplay display(options.progress);
  try {
    const auto submitted =
        ask_patiently<wire::Submitted>(farm, [&] { return connection.submit(submit, answer_ms); });
    LocalOutcome outcome;
    if (submitted) {
      outcome.job = submitted->job();
      outcome.end = follow(farm, connection, submitted->job(), display);
    }
    display.end();
    dashboard.reset();
    if (!outcome.end) outcome.under_way = ask_what_is_under_way(connection);
    farm.stop(is_in_hurry);
    return outcome;
  } catch (const Error&) {
    display.end();
    dashboard.reset();
    farm.stop(is_in_hurry);
    throw;
  }
}

}  // namespace

void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = note_stop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

void stop_listening() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
}

FolderLock lock_of_run(const std::filesystem::path& store, const std::string& output) {
  std::optional<FolderLock> lock = FolderLock::take(store, "run.lock");
  if (lock) return std::move(*lock);
  const std::optional<LockHolder> other = FolderLock::holder(store, "run.lock");
  throw ErrorWithHelp(ExitCode::failed,
                      output + ": another run is using this folder" +
                          (other ? ": " + other->text() : std::string()),
                      "wait for it, stop it, or give another folder with -o");
}

LocalOutcome run_locally(const RunOptions& options, const std::filesystem::path& store,
                         wire::Submit submit) {
  remark_on_workers(options);
  submit.set_replaces_others(true);
  LocalOutcome outcome = work(options, store, submit);
  const bool is_done = outcome.end && outcome.end->state() == "done";
  if (is_done && set_damaged_aside(*outcome.end, ArtifactStore(store))) {
    outcome = work(options, store, submit);
  }
  return outcome;
}

ExitCode report_stop(const RunOptions& options, const std::filesystem::path& store,
                     const LocalOutcome& outcome) {
  const std::filesystem::path database =
      options.database.empty() ? store : std::filesystem::path(options.database);
  const StoppedRun stopped = stopped_run(store, database, outcome.job, outcome.under_way);
  if (options.json) std::printf("%s\n", stopped_json(stopped).c_str());
  std::fprintf(stderr, "%shelp: run the same command again to continue%s\n",
               stopped_text(stopped).c_str(),
               stopped.lost.empty() ? "" : "; --grace SECONDS lets running tasks finish first");
  CommandEnd end;
  end.state = "stopped";
  end.job = stopped.job;
  end.exit_code = static_cast<int>(ExitCode::stopped_at_checkpoint);
  end.help = "run the same command again to continue";
  tell_end(options.progress, std::move(end));
  return ExitCode::stopped_at_checkpoint;
}

}  // namespace tetfarm
