/// A file with a name that is gone with the process, however that ends: `kill -9` too.
///
/// The HDF5 library wants a name that it can follow, so that a file without one will not do. A
/// process of its own waits for the end of this one and removes it.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace tetfarm {

class PassingFile {
 public:
  /// None.
  PassingFile() = default;
  /// An empty one. @throws IoError. Cost: a fork.
  explicit PassingFile(const std::filesystem::path& folder);
  PassingFile(PassingFile&& other) noexcept;
  PassingFile& operator=(PassingFile&& other) noexcept;
  /// Waits until it is gone.
  ~PassingFile();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int alive_ = -1;  ///< closed when this process is over
  pid_t remover_ = -1;
};

}  // namespace tetfarm
