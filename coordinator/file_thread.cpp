#include "coordinator/file_thread.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/thread_without_signals.h"

namespace tetfarm {

FileThread::FileThread(const ArtifactStore& store)
    : store_(store), event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (event_ < 0) throw IoError("cannot create an eventfd", "files", errno);
  thread_ = thread_without_signals([this] { run(); });
}

FileThread::~FileThread() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_work_.notify_one();
  thread_.join();
  ::close(event_);
}

void FileThread::give(FileOrder order) {
  {
    const std::lock_guard lock(mutex_);
    TF_CHECK(!is_over_);
    orders_.push_back(std::move(order));
  }
  has_work_.notify_one();
}

std::vector<FileAnswer> FileThread::take_answers() {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t got = ::read(event_, &count, sizeof count);
  const std::lock_guard lock(mutex_);
  return std::exchange(answers_, {});
}

void FileThread::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    has_work_.wait(lock, [this] { return is_over_ || !orders_.empty(); });
    if (is_over_) return;
    TF_CHECK(!orders_.empty());
    const FileOrder order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    FileAnswer answer = carry_out(order, store_);
    lock.lock();
    answers_.push_back(std::move(answer));
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t put = ::write(event_, &one, sizeof one);
  }
}

}  // namespace tetfarm
