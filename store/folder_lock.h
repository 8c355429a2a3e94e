/// One process at a time in a folder: an advisory lock on a file of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tetfarm {

/// Holds the lock while it lives; the kernel lets go of it when the process dies.
class FolderLock {
 public:
  /// Nothing when another process holds it. @throws IoError.
  static std::optional<FolderLock> take(const std::filesystem::path& folder,
                                        const std::string& file);
  /// The lock of a coordinator on its store. @throws UsageError when another process holds it,
  /// IoError.
  static FolderLock of_store(const std::filesystem::path& store);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_ = -1;
};

}  // namespace tetfarm
