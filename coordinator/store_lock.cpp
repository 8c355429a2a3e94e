#include "coordinator/store_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"

namespace tetfarm {

StoreLock::StoreLock(const std::filesystem::path& store) {
  const std::filesystem::path path = store / "coordinator.lock";
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw IoError("cannot open", path.string(), errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int error_number = errno;
  ::close(descriptor_);
  if (error_number == EWOULDBLOCK) {
    throw UsageError("another coordinator is using this store", store.string());
  }
  throw IoError("cannot lock", path.string(), error_number);
}

StoreLock::~StoreLock() { ::close(descriptor_); }

}  // namespace tetfarm
