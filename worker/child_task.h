/// One task in a process of its own: a crash or an out-of-memory kill takes the task, not the
/// worker.
///
/// The child is a program, or a copy of one that is loaded already (TaskHost), that reads a
/// wire::TaskStart from its standard input and writes framed wire::Envelopes (Heartbeats with what
/// it does, then one Done or Failed) to task_result_fd. What it says on standard error is kept for
/// the message of a failure, and for the log of the attempt. It dies with the thread that started
/// it.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proto/messages.pb.h"
#include "worker/task_host.h"

namespace tetfarm {

struct ChildTaskOptions {
  /// The program and its arguments.
  std::vector<std::string> command;
  /// What the program works in: its last argument; "": none.
  std::string store = {};
  bool is_without_shared_store = false;  ///< no other task sees that store
  /// Starts the task instead of the program, where it can; not owned.
  TaskHost* host = nullptr;
  /// Limit of what the child may write to (heap, stacks, private maps; not files and shared ones
  /// that it maps); 0: none.
  std::uint64_t memory_limit_bytes = 0;
};

class ChildTask {
 public:
  /// Starts the child. Call from the thread that outlives the task. @throws IoError.
  ChildTask(const ChildTaskOptions& options, const wire::Assign& assign);
  /// Kills the child if it still runs.
  ~ChildTask();
  ChildTask(const ChildTask&) = delete;
  ChildTask& operator=(const ChildTask&) = delete;

  /// Readable when poll() has something to do.
  int fd() const { return frames_fd_; }
  pid_t process() const { return process_; }
  std::uint64_t task() const { return task_; }
  std::uint64_t attempt() const { return attempt_; }

  using Hear = std::function<void(const wire::Doing&)>;

  /// Reads what the child said. Calls `hear` with what it does; when it has ended returns Done or
  /// Failed (an Envelope without a version), with peak memory, time and the number
  /// cpu_seconds filled in. Does not block while it runs.
  std::optional<wire::Envelope> poll(const Hear& hear);

  /// Ends the child now; poll() then returns Failed.
  void kill();
  /// The same, for one that took longer than it may: an error of its own, not a kill from outside.
  void end_overdue(std::int64_t limit_ms);

 private:
  void read_frames(const Hear& hear);
  void take_frames(const Hear& hear);
  void log_stage(const std::string& stage);
  void read_last_words();
  void write_log(std::string line);
  wire::Envelope outcome(int status, const rusage& usage);
  std::string how_it_ended(int status) const;

  std::uint64_t task_;
  std::uint64_t attempt_;
  std::chrono::steady_clock::time_point start_;
  std::uint64_t oom_kills_before_ = 0;
  pid_t process_ = -1;
  int frames_fd_ = -1;
  int words_fd_ = -1;
  bool frames_ended_ = false;
  std::int64_t overdue_ms_ = 0;  ///< the limit that it broke, 0: none
  std::string unread_;
  std::string last_words_;
  std::string log_;                  ///< stages with their times, and what it said; its end
  std::vector<std::string> stages_;  ///< that are in the log
  std::optional<wire::Envelope> answer_;
};

/// A frame: the length in four bytes, little endian, then the Envelope.
std::string frame_of(const wire::Envelope& envelope);

}  // namespace tetfarm
