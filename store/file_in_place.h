/// Is the file under a name still the one that was opened? Who writes to a file that was removed,
/// or replaced by another, writes to nothing that anybody will find again.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace tetfarm {

class FileInPlace {
 public:
  enum class State { there, removed, replaced };

  /// Remembers the file that lies at `path` now, by device and inode. @throws IoError.
  explicit FileInPlace(std::filesystem::path path);

  /// Cost: one system call. @throws IoError when it cannot be looked at.
  State look() const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  dev_t device_ = 0;
  ino_t inode_ = 0;
};

}  // namespace tetfarm
