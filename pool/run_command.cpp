#include "pool/run_command.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"

namespace tetfarm {
namespace {

/// A file in memory: unlike a pipe it never keeps a writer waiting.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes = {}) : fd_(::memfd_create("command", MFD_CLOEXEC)) {
    if (fd_ < 0) throw IoError("cannot create a file in memory", "memfd", errno);
    std::size_t written = 0;
    while (written < bytes.size()) {
      const ssize_t count = ::write(fd_, bytes.data() + written, bytes.size() - written);
      if (count < 0 && errno != EINTR) {
        const int error = errno;
        ::close(fd_);
        throw IoError("cannot write to a file in memory", "memfd", error);
      }
      written += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    ::lseek(fd_, 0, SEEK_SET);
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int fd() const { return fd_; }
  std::string contents() const {
    std::string bytes;
    std::array<char, 65536> block;
    for (off_t at = 0;;) {
      const ssize_t count = ::pread(fd_, block.data(), block.size(), at);
      if (count <= 0) return bytes;
      bytes.append(block.data(), static_cast<std::size_t>(count));
      at += count;
    }
  }

 private:
  int fd_;
};

/// In the child. A group of its own: a Ctrl-C at the terminal is for the pool.
[[noreturn]] void become(const std::vector<char*>& words, int in, int out, int err) {
  TF_CHECK(words.size() > 1 && words.back() == nullptr);
  ::setpgid(0, 0);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execvp(words[0], words.data());
  const char* why = std::strerror(errno);
  const ssize_t ignored = ::write(STDERR_FILENO, why, std::strlen(why));
  ::_exit(ignored < 0 ? 126 : 127);
}

}  // namespace

CommandOutcome run_command(const ShellCommand& command, std::int64_t timeout_ms) {
  TF_CHECK(!command.words.empty());
  const MemoryFile in(command.input);
  const MemoryFile out;
  const MemoryFile err;
  std::vector<std::string> copy = command.words;
  std::vector<char*> words;
  for (std::string& word : copy) words.push_back(word.data());
  words.push_back(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw IoError("cannot start a process", command.words.front(), errno);
  if (process == 0) become(words, in.fd(), out.fd(), err.fd());
  const std::int64_t until = steady_ms() + timeout_ms;
  int status = 0;
  CommandOutcome outcome;
  while (true) {
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process) {
      outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      break;
    }
    if (steady_ms() >= until) {
      ::kill(-process, SIGKILL);
      ::kill(process, SIGKILL);
      ::waitpid(process, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  outcome.out = out.contents();
  outcome.err = err.contents();
  if (outcome.code < 0 && outcome.err.empty())
    outcome.err = "was killed, or did not answer in time";
  return outcome;
}

}  // namespace tetfarm
