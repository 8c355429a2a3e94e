#include <fcntl.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "base/check.h"
#include "base/clock.h"
#include "base/counted.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "base/mebibytes.h"
#include "cli/commands.h"
#include "cli/coordinator_connection.h"
#include "cli/pool_rules.h"
#include "cli/pool_view.h"
#include "coordinator/log_lines.h"
#include "pool/run_command.h"

namespace tetfarm {
namespace {

constexpr std::int64_t command_timeout_ms = 120'000;
constexpr std::int64_t status_timeout_ms = 10'000;

std::atomic<bool> wants_end = false;

void ask_to_end(int /*signal*/) { wants_end = true; }

/// A farm that wants a key of the pool wants one of each worker, too.
void require_worker_key(const PoolCommand& command) {
  if (command.keys.own.empty() || !command.worker_key.empty() || command.stop) return;
  throw ErrorWithHelp(
      ExitCode::usage,
      "--worker-key: is missing; the farm uses keys (--key), so its workers need one of their own",
      "make one: `tetfarm keys new worker`, `tetfarm keys authorize worker.pub --role worker "
      "--keys DIR`, then --worker-key worker.key");
}

/// One pool of a name on a machine: two would submit twice as much. Held until this process ends.
class OnlyOne {
 public:
  explicit OnlyOne(const std::string& name)
      : path_("/tmp/tetfarm-pool-" + std::to_string(::geteuid()) + "-" + name + ".lock"),
        fd_(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600)) {
    if (fd_ < 0) throw IoError("cannot open", path_, errno);
    if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) return;
    ::close(fd_);
    throw Error(ExitCode::failed,
                "a pool of that name is already running on this machine: " + name);
  }
  ~OnlyOne() { ::close(fd_); }
  OnlyOne(const OnlyOne&) = delete;
  OnlyOne& operator=(const OnlyOne&) = delete;

 private:
  std::string path_;
  int fd_;
};

std::string text_of(const ShellCommand& command) {
  std::string text = "$";
  for (const std::string& word : command.words) {
    const bool is_plain = word.find_first_of(" \"'|$[]") == std::string::npos;
    text += is_plain ? " " + word : " '" + word + "'";
  }
  if (command.input.empty()) return text + "\n";
  return text + " <<'end_of_input'\n" + command.input + "end_of_input\n";
}

void print_what_would_be_done(const BatchSystem& system, const PoolRules& rules) {
  for (const ShellCommand& command : system.submit({rules.max, rules.least_bytes}, {})) {
    std::printf("%s", text_of(command).c_str());
  }
  for (const ShellCommand& command : system.list()) std::printf("%s", text_of(command).c_str());
}

/// What the decisions cannot do themselves: asks the batch system and the coordinator, and does
/// what was decided.
class Pool {
 public:
  Pool(const PoolCommand& command, const BatchSystem& system, const PoolRules& rules)
      : system_(system),
        decisions_(rules),
        json_(command.json),
        runs_solvers_(command.solvers),
        connection_(command.endpoint, read_peer_keys(command.keys, command.store)) {}

  /// One look at everything, and what follows from it. How many jobs are there; nothing when the
  /// batch system did not answer.
  std::optional<std::size_t> step() {
    PoolView view;
    view.jobs = list();
    view.farm = look();
    const std::int64_t quiet = decisions_.quiet_until_ms();
    const PoolActions actions = decisions_.decide(view, steady_ms());
    TF_CHECK(view.jobs || actions.submit.empty());  // nothing is decided blindly
    for (const WorkerOrder& order : actions.submit) submit(order, *view.jobs);
    drain(actions.drain);
    cancel(actions.cancel);
    if (decisions_.quiet_until_ms() > quiet && decisions_.quiet_until_ms() > steady_ms()) {
      say({{"type", "waits"}, {"ms", decisions_.quiet_until_ms() - steady_ms()}},
          "nothing will be submitted for " +
              std::to_string((decisions_.quiet_until_ms() - steady_ms()) / 1000) + " s");
    }
    return view.jobs ? std::optional(view.jobs->size()) : std::nullopt;
  }

 private:
  void say(const nlohmann::json& what, const std::string& text) const {
    spdlog::info("{}", text);
    if (!json_) return;
    std::printf("%s\n",
                what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
  }

  CommandOutcome run(const ShellCommand& command) const {
    CommandOutcome outcome = run_command(command, command_timeout_ms);
    if (outcome.code != 0) spdlog::warn("{}: {}", command.words.front(), outcome.err);
    return outcome;
  }

  std::optional<std::vector<PoolJob>> list() const {
    std::vector<PoolJob> all;
    for (const ShellCommand& command : system_.list()) {
      const auto jobs = system_.listed(run_command(command, command_timeout_ms));
      if (!jobs) {
        spdlog::warn("{} does not answer", command.words.front());
        return std::nullopt;
      }
      all.insert(all.end(), jobs->begin(), jobs->end());
    }
    return all;
  }

  std::optional<CoordinatorView> look() {
    try {
      return coordinator_view(connection_.farm(status_timeout_ms), runs_solvers_);
    } catch (const Error& error) {
      if (error.code() != ExitCode::not_found) throw;
      spdlog::warn("{}", error.what());
      return std::nullopt;
    }
  }

  void submit(const WorkerOrder& order, const std::vector<PoolJob>& jobs) {
    for (const ShellCommand& command : system_.submit(order, jobs)) {
      const CommandOutcome outcome = run(command);
      const std::vector<std::string> ids = system_.submitted(order, outcome);
      if (ids.empty()) {
        decisions_.submission_failed(order, steady_ms());
        say({{"type", "refused"}, {"message", outcome.err}}, "nothing was submitted");
        continue;
      }
      decisions_.submitted(order, ids, steady_ms());
      say({{"type", "submitted"}, {"jobs", ids}, {"bytes", order.bytes}},
          "submitted " + counted(ids.size(), "worker") + " of " + mebibytes(order.bytes) + ": " +
              ids.front() + " …");
    }
  }

  void drain(const std::vector<std::uint64_t>& workers) {
    for (const std::uint64_t worker : workers) {
      try {
        connection_.drain(worker, status_timeout_ms);
        say({{"type", "drained"}, {"worker", "worker-" + std::to_string(worker)}},
            "told worker-" + std::to_string(worker) + " to leave");
      } catch (const Error& error) {
        if (error.code() != ExitCode::not_found) throw;
        spdlog::warn("{}", error.what());
        return;
      }
    }
  }

  void cancel(const std::vector<std::string>& jobs) {
    if (jobs.empty()) return;
    for (const ShellCommand& command : system_.cancel(jobs)) run(command);
    say({{"type", "cancelled"}, {"jobs", jobs}},
        "cancelled " + counted(jobs.size(), "job") + ": " + jobs.front() + " …");
  }

  const BatchSystem& system_;
  PoolDecisions decisions_;
  bool json_;
  bool runs_solvers_;
  CoordinatorConnection connection_;
};

void wait_between_looks(double seconds) {
  const std::int64_t until = steady_ms() + static_cast<std::int64_t>(seconds * 1000);
  while (!wants_end && steady_ms() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

ExitCode pool_command(const PoolCommand& command) {
  require_worker_key(command);
  const PoolRules rules = pool_rules(command);
  const PoolSettings system_settings = pool_settings(command, rules);
  const auto system = make_batch_system(command.system, system_settings);
  if (command.dry_run) {
    print_what_would_be_done(*system, rules);
    return ExitCode::ok;
  }
  spdlog::set_default_logger(spdlog::stderr_logger_st("tetfarm"));
  spdlog::set_formatter(one_line_formatter());
  if (command.system != "ssh") make_folders(system_settings.logs);
  const OnlyOne only_one(rules.name);
  std::signal(SIGINT, ask_to_end);
  std::signal(SIGTERM, ask_to_end);
  Pool pool(command, *system, rules);
  while (!wants_end) {
    const std::optional<std::size_t> jobs = pool.step();
    if (command.stop && jobs == std::size_t{0}) return ExitCode::ok;
    wait_between_looks(command.interval_s);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
