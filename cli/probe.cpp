#include "cli/probe.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>

#include "base/check.h"
#include "base/clock.h"
#include "base/error_with_help.h"

namespace tetfarm {
namespace {

/// The two ends of a pipe.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw IoError("cannot make", "a pipe", errno);
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void close_writing() { close_end(1); }

 private:
  void close_end(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }
  std::array<int, 2> ends_ = {-1, -1};
};

[[noreturn]] void look_in_child(const Probe& probe, int out) {
  ::setpgid(0, 0);
  const std::string packed = packed_findings(looked_at(probe));
  std::size_t written = 0;
  while (written < packed.size()) {
    const ssize_t count = ::write(out, packed.data() + written, packed.size() - written);
    if (count < 0 && errno != EINTR) ::_exit(1);
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  ::_exit(0);
}

/// All that comes until the other end is closed; less when `until_ms` comes first.
std::string read_until(int in, std::int64_t until_ms, bool& is_whole) {
  std::string bytes;
  std::array<char, 4096> block;
  is_whole = false;
  while (true) {
    const std::int64_t left_ms = until_ms - steady_ms();
    pollfd waits{in, POLLIN, 0};
    if (left_ms <= 0) return bytes;
    if (::poll(&waits, 1, static_cast<int>(left_ms)) <= 0) continue;
    const ssize_t count = ::read(in, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      is_whole = count == 0;
      return bytes;
    }
    bytes.append(block.data(), static_cast<std::size_t>(count));
  }
}

/// A process that waits for a disk may not end even then; it is left to itself.
void end_child(pid_t process) {
  ::kill(-process, SIGKILL);
  ::kill(process, SIGKILL);
  for (int i = 0; i < 50 && ::waitpid(process, nullptr, WNOHANG) == 0; ++i) ::usleep(1'000);
}

}  // namespace

Findings looked_at(const Probe& probe) {
  TF_CHECK(probe.look != nullptr);
  try {
    return probe.look();
  } catch (const ErrorWithHelp& error) {
    return {{probe.check, Verdict::problem, error.what(), error.help()}};
  } catch (const std::exception& error) {
    return {{probe.check, Verdict::problem, error.what(), probe.remedy}};
  }
}

Findings looked_at_within(const Probe& probe, std::int64_t timeout_ms) {
  Pipe pipe;
  const pid_t process = ::fork();
  if (process < 0) throw IoError("cannot start a process", probe.check, errno);
  if (process == 0) look_in_child(probe, pipe.writing());
  pipe.close_writing();
  bool is_whole = false;
  const std::string packed = read_until(pipe.reading(), steady_ms() + timeout_ms, is_whole);
  end_child(process);
  Findings findings = unpacked_findings(packed);
  if (is_whole && !packed.empty()) return findings;
  const std::string seconds = std::to_string((timeout_ms + 999) / 1000);
  return {{probe.check, Verdict::problem,
           is_whole ? "looking at it ended in a crash"
                    : "no answer within " + seconds + " s: looking at it was given up",
           probe.remedy}};
}

}  // namespace tetfarm
