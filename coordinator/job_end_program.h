/// The thread that starts a program of the administrator's whenever a job has ended: to call a web
/// hook, to send a message. The decisions do not wait for it.
///
/// The program is started without a shell and without arguments, in a process group of its own, and
/// gets what it is to know in its environment, of which nothing else is what a user wrote without
/// having been checked. One runs at a time. One that fails, or takes longer than the limit and is
/// ended with all its children, is started again after a while, and given up after some tries.
/// What was not told when a coordinator ends is told by the next one: at least once, and perhaps
/// twice.
/// Units: milliseconds of the steady clock, unless another is named.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

struct JobEndOptions {
  std::filesystem::path program;  ///< see checked_job_end_program
  std::filesystem::path store;
  std::string endpoint;  ///< of the coordinator, for a program that asks it
  std::int64_t limit_ms = 60'000;
  std::int64_t grace_ms = 2'000;  ///< between SIGTERM and SIGKILL
  std::int64_t again_ms = 5'000;
  int tries = 3;
};

/// An end that was told, or was given up.
struct ToldEnd {
  JobId job;
  std::int64_t finished_ms = 0;  ///< as of its row: which of its ends
  std::string trouble;           ///< "": the program ended with 0
};

/// The absolute path of a program that can be started.
/// @throws UsageError when it is no file that may be executed, or one that everybody may write to.
std::filesystem::path checked_job_end_program(const std::filesystem::path& program);

/// What the program finds in its environment, "NAME=VALUE", without what it has from the
/// coordinator's own (PATH, HOME, LANG, TZ). @pre the job has ended.
std::vector<std::string> environment_of_end(const JobRow& job, const JobEndOptions& options);

class JobEndProgram {
 public:
  explicit JobEndProgram(JobEndOptions options);
  /// Ends the program that runs; what was not told stays so.
  ~JobEndProgram();
  JobEndProgram(const JobEndProgram&) = delete;
  JobEndProgram& operator=(const JobEndProgram&) = delete;

  /// The job's end is to be told; nothing happens where it is already, or was told and not taken.
  /// @pre the end is durable.
  void give(const JobRow& job);
  /// Those that were told since the last call.
  std::vector<ToldEnd> take_told();
  /// Failures of the program since the last call, for the log.
  std::vector<std::string> take_troubles();

 private:
  using Key = std::pair<JobId, std::int64_t>;
  struct Order {
    Key key;
    std::vector<std::string> environment;
    std::int64_t not_before_ms = 0;
    int tries = 0;
  };
  void run();
  void note(Order order, const std::string& trouble);
  Order* next_order();

  const JobEndOptions options_;
  std::mutex mutex_;
  std::condition_variable has_work_;
  bool is_over_ = false;
  std::set<Key> known_;  ///< given and not taken
  std::deque<Order> orders_;
  std::vector<ToldEnd> told_;
  std::vector<std::string> troubles_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace tetfarm
