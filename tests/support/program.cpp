#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

namespace tetfarm::test {
namespace {

constexpr const char* program_path = TETFARM_PROGRAM;

std::filesystem::path unused_name(const std::filesystem::path& folder, const std::string& stem) {
  for (int i = 0;; ++i) {
    std::filesystem::path path = folder / (stem + "." + std::to_string(i));
    if (!std::filesystem::exists(path)) return path;
  }
}

/// The parent of each living process.
std::map<pid_t, pid_t> parents() {
  std::map<pid_t, pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = contents(entry.path() / "stat");
    const std::size_t after_name = stat.rfind(')');
    if (after_name == std::string::npos) continue;
    std::istringstream rest(stat.substr(after_name + 1));
    char state = ' ';
    pid_t parent = 0;
    if (rest >> state >> parent && state != 'Z') found[std::stoi(name)] = parent;
  }
  return found;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tetfarm_test-XXXXXX").string();
  path_ = ::mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Program::Program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::vector<std::string>& launcher)
    : out_(unused_name(folder, "stdout")), err_(unused_name(folder, "stderr")) {
  std::vector<std::string> all = launcher;
  if (all.empty()) all.emplace_back(program_path);
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int out = ::open(out_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  const int err = ::open(err_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  process_ = ::fork();
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    if (::chdir(folder.c_str()) != 0) ::_exit(127);
    // Not the keys of whoever runs the test.
    ::setenv("XDG_CONFIG_HOME", (folder / ".config").c_str(), 1);
    ::unsetenv("TETFARM_KEYS");
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(out);
  ::close(err);
}

Program::~Program() {
  if (!is_running()) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

bool Program::is_running() {
  if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
  return process_ > 0;
}

void Program::signal(int number) const {
  if (process_ > 0) ::kill(process_, number);
}

Ended Program::wait(double timeout_s) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout_s);
  while (is_running() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  Ended ended;
  if (is_running()) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status_, 0);
    process_ = -1;
  } else {
    ended.code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }
  ended.out = contents(out_);
  ended.err = contents(err_);
  return ended;
}

std::string Program::out_so_far() const { return contents(out_); }

Ended run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                  double timeout_s) {
  return Program(words, folder).wait(timeout_s);
}

std::filesystem::path built_program() { return program_path; }

std::vector<pid_t> descendants(pid_t process) {
  const std::map<pid_t, pid_t> parent_of = parents();
  std::vector<pid_t> found;
  for (const auto& [child, parent] : parent_of) {
    pid_t above = parent;
    while (above != process && parent_of.contains(above)) above = parent_of.at(above);
    if (above == process) found.push_back(child);
  }
  return found;
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_contents(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace tetfarm::test
