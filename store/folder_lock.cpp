#include "store/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/error.h"

namespace tetfarm {

std::optional<FolderLock> FolderLock::take(const std::filesystem::path& folder,
                                           const std::string& file) {
  const std::filesystem::path path = folder / file;
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) throw IoError("cannot open", path.string(), errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return FolderLock(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (error_number == EWOULDBLOCK) return std::nullopt;
  throw IoError("cannot lock", path.string(), error_number);
}

FolderLock FolderLock::of_store(const std::filesystem::path& store) {
  std::optional<FolderLock> lock = take(store, "coordinator.lock");
  if (!lock) throw UsageError("another coordinator is using this store", store.string());
  return std::move(*lock);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace tetfarm
