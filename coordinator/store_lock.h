/// One coordinator per store: an advisory lock on a file of the store's folder.
#pragma once

#include <filesystem>

namespace tetfarm {

/// Holds the lock while it lives; the kernel lets go of it when the process dies.
class StoreLock {
 public:
  /// @throws UsageError when another process holds it, IoError.
  explicit StoreLock(const std::filesystem::path& store);
  ~StoreLock();
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace tetfarm
