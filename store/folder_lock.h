/// One process at a time in a folder: an advisory lock on a file of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tetfarm {

/// Who took a lock last, as the lock's file says.
struct LockHolder {
  std::int64_t process = 0;
  std::string host;

  /// "process 4711 on node-3".
  std::string text() const;
  /// Whether the process may still be there: it lives, or is one of another host.
  bool may_live() const;
};

/// Holds the lock while it lives; the kernel lets go of it when the process dies.
class FolderLock {
 public:
  /// Nothing when another process holds it. @throws IoError.
  static std::optional<FolderLock> take(const std::filesystem::path& folder,
                                        const std::string& file);
  /// The same on a file that holds something else: who has it is not written into it. A file that
  /// was renamed stays locked. @throws IoError.
  static std::optional<FolderLock> take_unsigned(const std::filesystem::path& path);
  /// Nothing when nobody has the lock, as far as its file says: who has died without letting go is
  /// in it still. @throws IoError.
  static std::optional<LockHolder> holder(const std::filesystem::path& folder,
                                          const std::string& file);
  /// The lock of a coordinator on its store. @throws UsageError when another process holds it, with
  /// which, IoError.
  static FolderLock of_store(const std::filesystem::path& store);
  static std::optional<LockHolder> holder_of_store(const std::filesystem::path& store);

  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  FolderLock(int descriptor, bool is_signed) : descriptor_(descriptor), is_signed_(is_signed) {}
  int descriptor_ = -1;
  bool is_signed_ = true;  ///< the file says who has it
};

}  // namespace tetfarm
