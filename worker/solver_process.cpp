#include "worker/solver_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <thread>

#include "base/clock.h"
#include "base/error.h"

namespace tetfarm {
namespace {

constexpr std::int64_t longest_pause_ms = 100;
constexpr int no_shell = 127;

/// A group leader's last act: it is of the group itself.
void kill_own_group(int) { ::kill(0, SIGKILL); }

std::vector<std::string> environment_of(const SolverCommand& solver) {
  std::vector<std::string> words;
  for (char** word = ::environ; *word != nullptr; ++word) words.emplace_back(*word);
  for (const auto& [name, value] : solver.variables) words.push_back(name + "=" + value);
  return words;
}

/// What execve takes; they live as long as the strings.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// All that is needed after fork, where nothing may be allocated.
struct Prepared {
  const char* folder;
  int log;
  char* const* arguments;
  char* const* environment;
  pid_t parent;
};

[[noreturn]] void become_shell(const Prepared& prepared) {
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(input, STDIN_FILENO);
  ::dup2(prepared.log, STDOUT_FILENO);
  ::dup2(prepared.log, STDERR_FILENO);
  // The room of a task is a limit of Tetfarm's own work, not of the solver's.
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) == 0) {
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_DATA, &limit);
  }
  ::prctl(PR_SET_PDEATHSIG, 0);
  for (const int signal : {SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  if (::chdir(prepared.folder) != 0) ::_exit(no_shell);
  ::execve("/bin/sh", prepared.arguments, prepared.environment);
  ::_exit(no_shell);
}

/// Leads the group of the solver, and ends as it does.
[[noreturn]] void watch(const Prepared& prepared) {
  ::setsid();
  struct sigaction action {};
  action.sa_handler = kill_own_group;
  ::sigaction(SIGTERM, &action, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != prepared.parent) ::_exit(no_shell);
  // What the worker reads from its task must end with the task.
  const int highest = 1024;
  for (int fd = STDERR_FILENO + 1; fd < highest; ++fd) {
    if (fd != prepared.log) ::close(fd);
  }
  const pid_t shell = ::fork();
  if (shell == 0) become_shell(prepared);
  if (shell < 0) ::_exit(no_shell);
  int status = 0;
  while (::waitpid(shell, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    ::signal(WTERMSIG(status), SIG_DFL);
    ::kill(::getpid(), WTERMSIG(status));
  }
  ::_exit(WIFEXITED(status) ? WEXITSTATUS(status) : no_shell);
}

/// Whatever the solver has started ends with it.
class ProcessGroup {
 public:
  explicit ProcessGroup(pid_t leader) : leader_(leader) {}
  ~ProcessGroup() {
    ::kill(-leader_, SIGKILL);
    if (!is_reaped_) ::waitpid(leader_, nullptr, 0);
  }
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;

  /// Whether it has ended, and how.
  bool has_ended(int& status) {
    const pid_t ended = ::waitpid(leader_, &status, WNOHANG);
    if (ended < 0 && errno != EINTR) throw IoError("cannot wait for", "the solver", errno);
    is_reaped_ = ended == leader_;
    return is_reaped_;
  }

 private:
  pid_t leader_;
  bool is_reaped_ = false;
};

SolverEnd wait_for(ProcessGroup& group, std::int64_t time_limit_ms,
                   const std::function<void()>& tick) {
  const std::int64_t start = steady_ms();
  int status = 0;
  while (!group.has_ended(status)) {
    const std::int64_t ran_ms = steady_ms() - start;
    if (ran_ms > time_limit_ms) return {true, 0, 0};
    tick();
    const std::int64_t pause_ms = std::clamp<std::int64_t>(ran_ms / 16, 1, longest_pause_ms);
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
  }
  if (WIFSIGNALED(status)) return {false, 0, WTERMSIG(status)};
  return {false, WEXITSTATUS(status), 0};
}

}  // namespace

SolverEnd run_solver(const SolverCommand& solver, const std::function<void()>& tick) {
  std::vector<std::string> words = {"sh", "-c", solver.command};
  const std::vector<char*> arguments = pointers_to(words);
  std::vector<std::string> variables = environment_of(solver);
  const std::vector<char*> environment = pointers_to(variables);
  const int log = ::open(solver.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0) throw IoError("cannot write", solver.log.string(), errno);
  const Prepared prepared = {solver.folder.c_str(), log, arguments.data(), environment.data(),
                             ::getpid()};
  const pid_t leader = ::fork();
  const int error = errno;
  if (leader == 0) watch(prepared);
  ::close(log);
  if (leader < 0) throw IoError("cannot start a process for", "the solver", error);
  ProcessGroup group(leader);
  return wait_for(group, solver.time_limit_ms, tick);
}

}  // namespace tetfarm
