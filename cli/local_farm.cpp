#include "cli/local_farm.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/check.h"
#include "base/child_process.h"
#include "base/clock.h"
#include "base/file_system.h"
#include "base/undo_unless_done.h"

namespace tetfarm {
namespace {

constexpr int most_short_lives = 6;
constexpr std::int64_t coordinator_end_ms = 3'000;
constexpr std::int64_t slowest_look_ms = 10;

std::string this_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw IoError("cannot find this program", "/proc/self/exe", error.value());
  return path.string();
}

const std::filesystem::path socket_folders = "/tmp";
const std::string socket_stem = "tetfarm-";

/// Removes the socket folders of runs that were killed: "/tmp/tetfarm-PROCESS-RANDOM".
void sweep_socket_folders() {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(socket_folders, ignored)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(socket_stem)) continue;
    const int process = std::atoi(name.c_str() + socket_stem.size());
    struct stat about {};
    const bool is_ours = ::lstat(entry.path().c_str(), &about) == 0 && S_ISDIR(about.st_mode) &&
                         about.st_uid == ::geteuid();
    if (!is_ours || process <= 0 || ::kill(process, 0) == 0 || errno != ESRCH) continue;
    std::filesystem::remove_all(entry.path(), ignored);
  }
}

/// Only this user may enter it. @throws IoError.
std::string make_socket_folder() {
  sweep_socket_folders();
  std::string name =
      (socket_folders / (socket_stem + std::to_string(::getpid()) + "-XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw IoError("cannot create a folder for the socket", name, errno);
  }
  return name;
}

/// A local farm has no keys, whichever keys this shell uses with other farms.
std::vector<char*> environment_without_keys() {
  std::vector<char*> kept;
  for (char* const* entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const bool is_of_keys =
        text.starts_with("TETFARM_KEY=") || text.starts_with("TETFARM_COORDINATOR_KEY=");
    if (!is_of_keys) kept.push_back(*entry);
  }
  kept.push_back(nullptr);
  return kept;
}

/// Between fork and exec: async-signal-safe calls only.
[[noreturn]] void become(char* const* arguments, char* const* environment, pid_t parent, int log) {
  live_with_parent(parent);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

}  // namespace

LocalFarm::LocalFarm(const FarmOptions& options) : options_(options) {
  folder_ = make_socket_folder();
  endpoint_ = "ipc://" + folder_.string() + "/farm";
  TF_CHECK(options.first_workers >= 0);
  workers_.resize(static_cast<std::size_t>(options.first_workers));
  UndoUnlessDone starting([this] {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  });
  start(coordinator_, coordinator_command(), "coordinator.log");
  for (Member& worker : workers_) start(worker, worker_command(), "workers.log");
  starting.done();
}

LocalFarm::~LocalFarm() {
  workers_.push_back(coordinator_);
  for (Member& member : workers_) {
    if (member.process <= 0) continue;
    ::kill(member.process, SIGKILL);
    ::waitpid(member.process, nullptr, 0);
  }
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> LocalFarm::coordinator_command() const {
  std::vector<std::string> words = {this_program(), "coordinator", "--quiet", "--store",
                                    options_.store, "--listen",    endpoint_, "--heartbeat-ms",
                                    "500",          "--lease-ms",  "5000",    "--one-job"};
  if (!options_.database.empty()) words.insert(words.end(), {"--database", options_.database});
  return words;
}

std::vector<std::string> LocalFarm::worker_command() const {
  std::vector<std::string> words = {
      this_program(), "worker",       "--quiet",
      "--store",      options_.store, "--connect",
      endpoint_,      "--grace",      std::to_string(options_.grace_s)};
  if (options_.runs_solvers) words.emplace_back("--solvers");
  return words;
}

void LocalFarm::start(Member& member, const std::vector<std::string>& command,
                      const std::string& log) {
  TF_CHECK(!command.empty());
  TF_CHECK(member.process <= 0);  // it runs once
  const std::vector<char*> arguments = exec_arguments(command);
  const std::vector<char*> environment = environment_without_keys();
  const std::filesystem::path path = options_.store / log;
  const int log_fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log_fd < 0) throw IoError("cannot write the log", path, errno);
  const pid_t parent = ::getpid();
  member.process = ::fork();
  if (member.process == 0) become(arguments.data(), environment.data(), parent, log_fd);
  const int error = errno;
  ::close(log_fd);
  if (member.process < 0) throw IoError("cannot start a process", command[0], error);
  member.life.started_ms = steady_ms();
}

/// The status of a member that has died since the last look.
std::optional<int> LocalFarm::reap(Member& member) {
  int status = 0;
  if (member.process <= 0 || ::waitpid(member.process, &status, WNOHANG) != member.process) {
    return std::nullopt;
  }
  member.process = -1;
  return status;
}

void LocalFarm::look_after() {
  if (const std::optional<int> status = reap(coordinator_)) {
    coordinator_.life.note_death(WIFEXITED(*status), steady_ms());
    const int code = WIFEXITED(*status) ? WEXITSTATUS(*status) : 0;
    const bool starved = code == static_cast<int>(ExitCode::out_of_resources);
    if (starved || coordinator_.life.short_lives >= most_short_lives) {
      throw Error(static_cast<ExitCode>(code), "the coordinator ended unexpectedly: " +
                                                   last_error(options_.store / "coordinator.log"));
    }
  }
  for (Member& worker : workers_) {
    if (const std::optional<int> status = reap(worker))
      worker.life.note_death(WIFEXITED(*status), steady_ms());
    if (worker.life.short_lives >= most_short_lives) {
      throw Error(ExitCode::failed,
                  "a worker ended unexpectedly: " + last_error(options_.store / "workers.log"));
    }
  }
  const std::int64_t now = steady_ms();
  if (coordinator_.process <= 0 && now >= coordinator_.life.start_again_ms) {
    start(coordinator_, coordinator_command(), "coordinator.log");
  }
  for (Member& worker : workers_) {
    if (worker.process <= 0 && now >= worker.life.start_again_ms) {
      start(worker, worker_command(), "workers.log");
    }
  }
}

void LocalFarm::grow(std::size_t tasks) {
  const std::size_t wanted = std::min(tasks, static_cast<std::size_t>(options_.workers));
  while (workers_.size() < wanted) {
    start(workers_.emplace_back(), worker_command(), "workers.log");
  }
}

bool LocalFarm::wait_for_end(Member& member, std::int64_t until_ms, bool (*hurry)()) {
  std::int64_t pause_ms = 1;
  while (member.process > 0 && !reap(member)) {
    if (steady_ms() >= until_ms || hurry()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    pause_ms = std::min(2 * pause_ms, slowest_look_ms);
  }
  return true;
}

void LocalFarm::stop(bool (*hurry)()) {
  for (const Member& worker : workers_) {
    if (worker.process > 0) ::kill(worker.process, SIGTERM);
  }
  const auto grace_ms = static_cast<std::int64_t>(options_.grace_s * 1000);
  const std::int64_t until = steady_ms() + grace_ms + 1'000;
  for (Member& worker : workers_) {
    if (!wait_for_end(worker, until, hurry)) break;
  }
  if (coordinator_.process <= 0) return;
  ::kill(coordinator_.process, SIGTERM);
  wait_for_end(coordinator_, steady_ms() + coordinator_end_ms, hurry);
}

}  // namespace tetfarm
