/// The thread that removes files of the store that nobody needs any more (file_needs.h): of large
/// files, or many, that takes a while, and neither the decisions nor the files that go to and from
/// workers shall wait for it.
///
/// What it was given and has not come to when the process is killed stays in the store; the next
/// coordinator finds it (FinishedJobs::take_leavings, JobState).
#pragma once

#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "store/artifact_store.h"

namespace tetfarm {

class RemovalThread {
 public:
  /// `store` outlives it.
  explicit RemovalThread(const ArtifactStore& store);
  /// Removes what it was given first.
  ~RemovalThread();
  RemovalThread(const RemovalThread&) = delete;
  RemovalThread& operator=(const RemovalThread&) = delete;

  /// Files by their hashes; such as are gone already are fine.
  /// @pre that nobody needs them is durable.
  void give(const std::vector<std::string>& hashes);
  /// From now on the file is not about to be removed: either it stays, or it is gone. Whether it
  /// was to be removed and stays. Waits while just this one is being removed.
  bool keep(const std::string& hash);
  /// What could not be removed since the last call, for the log. Each stays.
  std::vector<std::string> take_troubles();

 private:
  void run();

  const ArtifactStore& store_;
  std::mutex mutex_;
  std::condition_variable has_work_;
  std::condition_variable has_removed_;
  bool is_over_ = false;
  std::set<std::string> hashes_;
  std::string at_work_on_;  ///< "": none
  std::vector<std::string> troubles_;
  std::thread thread_;
};

}  // namespace tetfarm
