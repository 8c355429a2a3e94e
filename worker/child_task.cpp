#include "worker/child_task.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "base/check.h"
#include "base/child_process.h"
#include "base/error.h"
#include "base/work_stage.h"
#include "store/rows.h"
#include "tasks/failure_cause.h"
#include "worker/task_environment.h"

namespace tetfarm {
namespace {

constexpr std::size_t kept_words = 2000;
constexpr std::size_t largest_frame = std::size_t{64} << 20;

void close_fd(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IoError("cannot create a pipe", "task", errno);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return ends;
}

/// The assignment as a file in memory: unlike a pipe it never blocks, however long it is.
int assignment_fd(const wire::Assign& assign, bool is_without_shared_store) {
  wire::TaskStart start;
  *start.mutable_assign() = assign;
  start.set_without_shared_store(is_without_shared_store);
  const std::string bytes = start.SerializeAsString();
  const int fd = ::memfd_create("tetfarm-task", MFD_CLOEXEC);
  if (fd < 0) throw IoError("cannot create a file in memory", "task", errno);
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(fd, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      ::close(fd);
      throw IoError("cannot write the task", "task", error);
    }
    written += static_cast<std::size_t>(n);
  }
  ::lseek(fd, 0, SEEK_SET);
  return fd;
}

/// How many processes the kernel has killed for want of memory since the machine started.
std::uint64_t kernel_oom_kills() {
  std::ifstream file("/proc/vmstat");
  std::string key;
  std::uint64_t value = 0;
  while (file >> key >> value) {
    if (key == "oom_kill") return value;
  }
  return 0;
}

bool was_ended_from_outside(int status) {
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGTERM);
}

/// Between fork and exec: async-signal-safe calls only.
[[noreturn]] void become_program(char* const* arguments, char* const* environment, pid_t worker,
                                 TaskFds fds, std::uint64_t memory_limit) {
  become_task_process(worker, fds, memory_limit);
  ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

pid_t start_program(const ChildTaskOptions& options, TaskFds fds) {
  TF_CHECK(!options.command.empty());
  std::vector<std::string> words = options.command;
  if (!options.store.empty()) words.push_back(options.store);
  const std::vector<char*> arguments = exec_arguments(words);
  const std::vector<std::string> variables = task_environment(::environ);
  const std::vector<char*> environment = exec_arguments(variables);
  const pid_t worker = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) {
    become_program(arguments.data(), environment.data(), worker, fds, options.memory_limit_bytes);
  }
  return process;
}

pid_t start_process(const ChildTaskOptions& options, TaskFds fds) {
  if (options.host != nullptr) {
    const auto process = options.host->start(options.store, fds, options.memory_limit_bytes);
    if (process) return *process;
  }
  return start_program(options, fds);
}

std::uint32_t frame_length(const std::string& bytes) {
  TF_CHECK(bytes.size() >= 4);
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    length |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return length;
}

}  // namespace

std::string frame_of(const wire::Envelope& envelope) {
  const std::string body = envelope.SerializeAsString();
  TF_CHECK(body.size() <= largest_frame);
  std::string frame;
  for (std::size_t i = 0; i < 4; ++i) frame += static_cast<char>(body.size() >> (8 * i) & 0xFF);
  return frame + body;
}

ChildTask::ChildTask(const ChildTaskOptions& options, const wire::Assign& assign)
    : task_(assign.task()), attempt_(assign.attempt()), start_(std::chrono::steady_clock::now()) {
  oom_kills_before_ = kernel_oom_kills();
  int in = assignment_fd(assign, options.is_without_shared_store);
  std::array<int, 2> frames = make_pipe();
  std::array<int, 2> words = make_pipe();
  process_ = start_process(options, {in, words[1], frames[1]});
  const int error = errno;
  close_fd(in);
  close_fd(frames[1]);
  close_fd(words[1]);
  frames_fd_ = frames[0];
  words_fd_ = words[0];
  if (process_ < 0) {
    close_fd(frames_fd_);
    close_fd(words_fd_);
    throw IoError("cannot start a process", options.command[0], error);
  }
}

ChildTask::~ChildTask() {
  if (process_ > 0) {
    kill();
    ::waitpid(process_, nullptr, 0);
  }
  close_fd(frames_fd_);
  close_fd(words_fd_);
}

void ChildTask::kill() {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

void ChildTask::end_overdue(std::int64_t limit_ms) {
  TF_CHECK(limit_ms > 0);
  overdue_ms_ = limit_ms;
  kill();
}

/// Adds a line under the time since the start.
void ChildTask::write_log(std::string line) {
  while (!line.empty() && line.back() == '\n') line.pop_back();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  std::array<char, 32> time;
  std::snprintf(time.data(), time.size(), "%9.2f s  ", seconds.count());
  log_ += time.data() + line + "\n";
  if (log_.size() > longest_log) log_.erase(0, log_.size() - longest_log);
}

/// Once: a task may go through some of its stages many times.
void ChildTask::log_stage(const std::string& stage) {
  const bool is_known = std::find(stages_.begin(), stages_.end(), stage) != stages_.end();
  if (is_known || stages_.size() == work_stages) return;
  stages_.push_back(stage);
  write_log(stage);
}

void ChildTask::read_last_words() {
  std::array<char, 4096> buffer;
  while (true) {
    const ssize_t n = ::read(words_fd_, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    last_words_.append(buffer.data(), static_cast<std::size_t>(n));
    write_log(std::string(buffer.data(), static_cast<std::size_t>(n)));
    if (last_words_.size() > kept_words) last_words_.erase(0, last_words_.size() - kept_words);
  }
}

void ChildTask::read_frames(const Hear& hear) {
  std::array<char, 65536> buffer;
  while (!frames_ended_) {
    const ssize_t n = ::read(frames_fd_, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    if (n == 0) frames_ended_ = true;
    unread_.append(buffer.data(), static_cast<std::size_t>(n));
  }
  take_frames(hear);
}

void ChildTask::take_frames(const Hear& hear) {
  while (unread_.size() >= 4) {
    const std::size_t length = frame_length(unread_);
    if (length > largest_frame) {
      frames_ended_ = true;
      kill();
      return;
    }
    if (unread_.size() < 4 + length) return;
    wire::Envelope envelope;
    const bool understood = envelope.ParseFromArray(unread_.data() + 4, static_cast<int>(length));
    unread_.erase(0, 4 + length);
    if (!understood) continue;
    if (envelope.has_heartbeat()) {
      log_stage(envelope.heartbeat().doing().stage());
      hear(envelope.heartbeat().doing());
    } else if (envelope.has_done() || envelope.has_failed()) {
      answer_ = std::move(envelope);
    }
  }
}

std::optional<wire::Envelope> ChildTask::poll(const Hear& hear) {
  if (process_ <= 0) return std::nullopt;
  read_last_words();
  read_frames(hear);
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  do {
    ended = ::wait4(process_, &status, frames_ended_ ? 0 : WNOHANG, &usage);
  } while (ended < 0 && errno == EINTR);
  if (ended == 0) return std::nullopt;
  read_last_words();
  read_frames(hear);
  TF_CHECK(ended == process_ || ended < 0);
  process_ = -1;
  return outcome(status, usage);
}

std::string ChildTask::how_it_ended(int status) const {
  std::string text = "the task's process ";
  if (overdue_ms_ > 0) {
    text = "it hung, or took longer than its limit of " + std::to_string(overdue_ms_ / 1000) +
           " s; the task's process ";
  }
  if (WIFSIGNALED(status)) {
    text += "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
            ::strsignal(WTERMSIG(status)) + ")";
  } else {
    text += "ended with code " + std::to_string(WEXITSTATUS(status)) + " and without a result";
  }
  std::string words = last_words_;
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words.empty() ? text : text + "; its output: " + words;
}

wire::Envelope ChildTask::outcome(int status, const rusage& usage) {
  const bool clean = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  const std::uint64_t peak_rss_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  wire::Envelope envelope;
  if (clean && answer_) {
    envelope = std::move(*answer_);
  } else {
    const bool was_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    const bool starved =
        overdue_ms_ == 0 && ((was_killed && kernel_oom_kills() > oom_kills_before_) ||
                             last_words_.find("std::bad_alloc") != std::string::npos);
    wire::Failed& failed = *envelope.mutable_failed();
    failed.set_message(how_it_ended(status) + (starved ? "; it ran out of memory" : ""));
    failed.set_exit_code(static_cast<int>(starved ? ExitCode::out_of_resources : ExitCode::failed));
    const bool was_ended = overdue_ms_ == 0 && was_ended_from_outside(status);
    failed.set_cause(on_wire(starved     ? FailureCause::out_of_memory
                             : was_ended ? FailureCause::killed
                                         : FailureCause::error));
  }
  TF_CHECK(envelope.has_done() || envelope.has_failed());
  write_log(envelope.has_done()
                ? "done, peak memory " + std::to_string(peak_rss_bytes >> 20U) + " MiB"
                : "failed: " + envelope.failed().message());
  if (envelope.has_done()) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
    envelope.mutable_done()->set_task(task_);
    envelope.mutable_done()->set_attempt(attempt_);
    envelope.mutable_done()->set_seconds(seconds.count());
    envelope.mutable_done()->set_peak_rss_bytes(peak_rss_bytes);
    envelope.mutable_done()->set_log(log_);
    (*envelope.mutable_done()->mutable_numbers())["cpu_seconds"] =
        seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  } else {
    envelope.mutable_failed()->set_task(task_);
    envelope.mutable_failed()->set_attempt(attempt_);
    envelope.mutable_failed()->set_peak_rss_bytes(peak_rss_bytes);
    envelope.mutable_failed()->set_log(log_);
  }
  return envelope;
}

}  // namespace tetfarm
