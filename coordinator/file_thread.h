/// The thread that carries out file orders, so that a slow disk makes nobody wait for a heartbeat.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "coordinator/file_orders.h"

namespace tetfarm {

class FileThread {
 public:
  /// `store` outlives it. @throws IoError.
  explicit FileThread(const ArtifactStore& store);
  /// Waits for the order that is being carried out; the others are forgotten.
  ~FileThread();
  FileThread(const FileThread&) = delete;
  FileThread& operator=(const FileThread&) = delete;

  /// Orders are carried out one after the other.
  void give(FileOrder order);
  /// The answers since the last call; never waits.
  std::vector<FileAnswer> take_answers();
  /// Readable when there are answers.
  int fd() const { return event_; }

 private:
  void run();

  const ArtifactStore& store_;
  int event_ = -1;
  std::mutex mutex_;
  std::condition_variable has_work_;
  bool is_over_ = false;
  std::deque<FileOrder> orders_;
  std::vector<FileAnswer> answers_;
  std::thread thread_;
};

}  // namespace tetfarm
