#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "base/clock.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/coordinator_connection.h"
#include "cli/job_outcome.h"
#include "cli/job_report.h"
#include "cli/local_farm.h"
#include "cli/progress_display.h"

namespace tetfarm {
namespace {

constexpr std::int64_t first_look_ms = 20;
constexpr std::int64_t slowest_look_ms = 200;
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

int worker_count(const RunOptions& options) {
  if (options.workers > 0) return options.workers;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
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
  std::int64_t pause_ms = first_look_ms;
  while (true) {
    const auto reply =
        ask_patiently<wire::StatusReply>(farm, [&] { return connection.status(job, answer_ms); });
    if (!reply) return std::nullopt;
    if (reply->jobs_size() == 0) throw Error(ExitCode::failed, "the coordinator lost " + job);
    const wire::JobStatus& status = reply->jobs(0);
    if (has_ended(status)) return status;
    if (status.state() == "stuck") throw Error(ExitCode::out_of_resources, status.message());
    display.show(status);
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    pause_ms = std::min(2 * pause_ms, slowest_look_ms);
  }
}

std::optional<wire::JobStatus> work(const RunOptions& options, const std::filesystem::path& store,
                                    const wire::Submit& submit) {
  LocalFarm farm({.store = store,
                  .database = options.database,
                  .workers = worker_count(options),
                  .grace_s = options.grace_s});
  CoordinatorConnection connection(farm.endpoint());
  ProgressDisplay display(options.progress);
  try {
    const auto submitted =
        ask_patiently<wire::Submitted>(farm, [&] { return connection.submit(submit, answer_ms); });
    std::optional<wire::JobStatus> end;
    if (submitted) end = follow(farm, connection, submitted->job(), display);
    display.end();
    farm.stop(is_in_hurry);
    return end;
  } catch (const Error&) {
    display.end();
    farm.stop(is_in_hurry);
    throw;
  }
}

/// Result files that were damaged since they were made; whether there were any. They are set aside,
/// so that the job makes them again.
bool set_damaged_aside(const wire::JobStatus& status, const ArtifactStore& store) {
  bool is_damaged = false;
  for (const wire::Artifact& file : status.files()) {
    try {
      store.verify(file.hash(), file.size());
    } catch (const CorruptFile&) {
      store.set_aside(file.hash());
      is_damaged = true;
    }
  }
  return is_damaged;
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  const std::int64_t start = steady_ms();
  listen_to_signals();
  const JobInput input = read_job(options);
  const std::filesystem::path folder = std::filesystem::absolute(options.output);
  const std::filesystem::path store = folder / ".tetfarm";
  make_folders(store);
  wire::Submit submit = publish_job(ArtifactStore(store), input);
  submit.set_replaces_others(true);
  std::optional<wire::JobStatus> end = work(options, store, submit);
  if (end && end->state() == "done" && set_damaged_aside(*end, ArtifactStore(store))) {
    end = work(options, store, submit);
  }
  if (!end) {
    std::fprintf(stderr, "stopped at a checkpoint\nhelp: the same command goes on from here\n");
    return ExitCode::stopped_at_checkpoint;
  }
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  return report_outcome(
      *end, {.store = store, .output = folder, .seconds = seconds, .json = options.json});
}

}  // namespace tetfarm
