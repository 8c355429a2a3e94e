#include "coordinator/limited_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

#include "base/check.h"
#include "base/clock.h"
#include "base/printable_text.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_tail = 400;
constexpr int look_every_ms = 20;

/// Both ends are closed when a program is started that is not to have them.
class OutputPipe {
 public:
  OutputPipe() {
    is_open_ = ::pipe2(ends_.data(), O_CLOEXEC) == 0;
    // The program's own end blocks, as it expects.
    if (is_open_) ::fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  ~OutputPipe() {
    close_end(0);
    close_end(1);
  }
  OutputPipe(const OutputPipe&) = delete;
  OutputPipe& operator=(const OutputPipe&) = delete;

  bool is_open() const { return is_open_; }
  int writing_end() const { return ends_[1]; }
  void close_writing_end() { close_end(1); }

  /// What is there, at most for a moment; true while more may come.
  bool read_some(int timeout_ms, std::string& tail) const {
    pollfd wanted{ends_[0], POLLIN, 0};
    if (::poll(&wanted, 1, timeout_ms) <= 0) return true;
    std::array<char, 4096> bytes;
    const ssize_t n = ::read(ends_[0], bytes.data(), bytes.size());
    if (n <= 0) return n < 0 && (errno == EAGAIN || errno == EINTR);
    tail.append(bytes.data(), static_cast<std::size_t>(n));
    if (tail.size() > longest_tail) tail.erase(0, tail.size() - longest_tail);
    return true;
  }

 private:
  void close_end(std::size_t which) {
    if (ends_.at(which) >= 0) ::close(ends_.at(which));
    ends_.at(which) = -1;
  }

  bool is_open_ = false;
  std::array<int, 2> ends_ = {-1, -1};
};

/// How a program is started; made and destroyed as the C library wants it.
class SpawnPlan {
 public:
  explicit SpawnPlan(int output) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&files_, output, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnPlan() {
    ::posix_spawn_file_actions_destroy(&files_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  /// The error's number; 0: it was started, and is `process`.
  int start(const LimitedProgram& program, pid_t& process) const {
    std::string path = program.path.string();
    std::array<char*, 2> words = {path.data(), nullptr};
    std::vector<std::string> variables = program.environment;
    std::vector<char*> environment;
    for (std::string& variable : variables) environment.push_back(variable.data());
    environment.push_back(nullptr);
    return ::posix_spawn(&process, path.c_str(), &files_, &attributes_, words.data(),
                         environment.data());
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

/// Its status, once it has ended. Its group keeps its number until then.
std::optional<int> ended_with(pid_t process) {
  int status = 0;
  const pid_t ended = ::waitpid(process, &status, WNOHANG);
  TF_CHECK(ended >= 0 || errno == EINTR);
  return ended == process ? std::optional(status) : std::nullopt;
}

std::string words_of_status(int status) {
  if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? ""
                                  : "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::string run_limited(const LimitedProgram& program, const std::atomic<bool>& stop) {
  OutputPipe output;
  if (!output.is_open()) return std::string("cannot be started: ") + std::strerror(errno);
  pid_t process = -1;
  const int error = SpawnPlan(output.writing_end()).start(program, process);
  if (error != 0) return std::string("cannot be started: ") + std::strerror(error);
  output.close_writing_end();
  std::string tail;
  std::string why_ended;
  std::int64_t kill_ms = steady_ms() + program.limit_ms;
  int number = SIGTERM;
  bool is_read = true;
  std::optional<int> status;
  while (!(status = ended_with(process))) {
    if (is_read) is_read = output.read_some(look_every_ms, tail);
    if (!is_read) ::usleep(look_every_ms * 1000);
    const bool is_late = steady_ms() >= kill_ms;
    if (!is_late && !(stop.load() && number == SIGTERM)) continue;
    if (number == SIGTERM) {
      why_ended = is_late ? "took longer than " + std::to_string(program.limit_ms) + " ms"
                          : "was ended with the coordinator";
    }
    ::kill(-process, number);
    kill_ms = steady_ms() + program.grace_ms;
    number = SIGKILL;
  }
  if (!why_ended.empty()) ::kill(-process, SIGKILL);  // what it left behind
  for (int i = 0; i < 16 && is_read; ++i) is_read = output.read_some(0, tail);
  const std::string trouble = why_ended.empty() ? words_of_status(*status) : why_ended;
  return trouble.empty() || tail.empty() ? trouble : trouble + "; it said: " + printable(tail);
}

}  // namespace tetfarm
