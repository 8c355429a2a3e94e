#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "base/clock.h"
#include "base/counted.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/converted_meshes.h"
#include "cli/coordinator_connection.h"
#include "cli/deliver_files.h"
#include "cli/job_outcome.h"
#include "cli/local_farm.h"
#include "cli/progress_display.h"
#include "cli/stopped_run.h"
#include "cli/typed_names.h"
#include "cli/workers_wanted.h"
#include "store/folder_lock.h"

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

void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = note_stop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

/// What comes after the job is done again by the same command.
void stop_listening() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
}

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

/// One run at a time in a folder. @throws Error, with the process that has it.
FolderLock lock_of_run(const std::filesystem::path& store, const std::string& output) {
  std::optional<FolderLock> lock = FolderLock::take(store, "run.lock");
  if (lock) return std::move(*lock);
  const std::optional<LockHolder> other = FolderLock::holder(store, "run.lock");
  throw ErrorWithHelp(ExitCode::failed,
                      output + ": another run is using this folder" +
                          (other ? ": " + other->text() : std::string()),
                      "wait for it, stop it, or give another folder with -o");
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
    display.show(status);
    farm.grow(workers_wanted(*reply));
    const std::int64_t pause_ms =
        std::clamp((steady_ms() - start) / looks_in_run, quickest_look_ms, slowest_look_ms);
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
  }
}

/// How a job ended, or what was under way when the run was told to stop.
struct Outcome {
  std::optional<wire::JobStatus> end;
  std::string job;
  std::vector<std::uint64_t> under_way;
};

/// Nothing is known of a coordinator that does not answer.
std::vector<std::uint64_t> ask_what_is_under_way(CoordinatorConnection& connection) {
  try {
    return tasks_under_way(connection.farm(answer_ms));
  } catch (const Error&) {
    return {};
  }
}

Outcome work(const RunOptions& options, const std::filesystem::path& store,
             const wire::Submit& submit) {
  LocalFarm farm({.store = store,
                  .database = options.database,
                  .workers = worker_count(options),
                  .first_workers = std::min(worker_count(options), cores()),
                  .grace_s = options.grace_s});
  CoordinatorConnection connection(farm.endpoint());
  ProgressDisplay display(options.progress);
  try {
    const auto submitted =
        ask_patiently<wire::Submitted>(farm, [&] { return connection.submit(submit, answer_ms); });
    Outcome outcome;
    if (submitted) {
      outcome.job = submitted->job();
      outcome.end = follow(farm, connection, submitted->job(), display);
    }
    display.end();
    if (!outcome.end) outcome.under_way = ask_what_is_under_way(connection);
    farm.stop(is_in_hurry);
    return outcome;
  } catch (const Error&) {
    display.end();
    farm.stop(is_in_hurry);
    throw;
  }
}

ExitCode report_stop(const RunOptions& options, const std::filesystem::path& store,
                     const Outcome& outcome) {
  const std::filesystem::path database =
      options.database.empty() ? store : std::filesystem::path(options.database);
  const StoppedRun stopped = stopped_run(store, database, outcome.job, outcome.under_way);
  if (options.json) std::printf("%s\n", stopped_json(stopped).c_str());
  std::fprintf(stderr, "%shelp: run the same command again to continue%s\n",
               stopped_text(stopped).c_str(),
               stopped.lost.empty() ? "" : "; --grace SECONDS lets running tasks finish first");
  return ExitCode::stopped_at_checkpoint;
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  const std::int64_t start = steady_ms();
  listen_to_signals();
  const JobInput input = read_job(options);
  check_submittable(input);
  require_readable(input);
  remark_on_workers(options);
  const std::filesystem::path folder = std::filesystem::absolute(options.output);
  const std::filesystem::path store = folder / ".tetfarm";
  make_folders(store);
  const FolderLock lock = lock_of_run(store, options.output);
  wire::Submit submit = publish_job(ArtifactStore(store), input);
  submit.set_replaces_others(true);
  Outcome outcome = work(options, store, submit);
  if (outcome.end && outcome.end->state() == "done" &&
      set_damaged_aside(*outcome.end, ArtifactStore(store))) {
    outcome = work(options, store, submit);
  }
  if (!outcome.end) return report_stop(options, store, outcome);
  name_as_typed(*outcome.end, options, input);
  std::vector<std::filesystem::path> files = deliver_files(*outcome.end, store, folder);
  stop_listening();
  convert_mesh(*outcome.end, options.progress, files);
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  return report_outcome(*outcome.end,
                        {.files = std::move(files), .seconds = seconds, .json = options.json});
}

}  // namespace tetfarm
