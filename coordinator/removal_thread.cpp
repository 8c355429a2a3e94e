#include "coordinator/removal_thread.h"

#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/thread_without_signals.h"

namespace tetfarm {

RemovalThread::RemovalThread(const ArtifactStore& store) : store_(store) {
  thread_ = thread_without_signals([this] { run(); });
}

RemovalThread::~RemovalThread() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_work_.notify_one();
  thread_.join();
}

void RemovalThread::give(const std::vector<std::string>& hashes) {
  if (hashes.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    TF_CHECK(!is_over_);
    hashes_.insert(hashes.begin(), hashes.end());
  }
  has_work_.notify_one();
}

bool RemovalThread::keep(const std::string& hash) {
  std::unique_lock lock(mutex_);
  if (hashes_.erase(hash) > 0) return true;
  has_removed_.wait(lock, [&] { return at_work_on_ != hash || hash.empty(); });
  return false;
}

std::vector<std::string> RemovalThread::take_troubles() {
  const std::lock_guard lock(mutex_);
  return std::exchange(troubles_, {});
}

void RemovalThread::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    has_work_.wait(lock, [this] { return is_over_ || !hashes_.empty(); });
    if (hashes_.empty()) return;
    at_work_on_ = *hashes_.begin();
    hashes_.erase(hashes_.begin());
    lock.unlock();
    std::error_code error;
    if (ArtifactStore::is_hash(at_work_on_)) {
      std::filesystem::remove(store_.path_of(at_work_on_), error);
    }
    lock.lock();
    if (error)
      troubles_.push_back("cannot remove artifact " + at_work_on_ + ": " + error.message());
    at_work_on_.clear();
    has_removed_.notify_all();
  }
}

}  // namespace tetfarm
