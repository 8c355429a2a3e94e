/// A file without a name, gone with the process: what does not fit in memory for a while.
#pragma once

#include <cstdint>
#include <filesystem>

namespace tetfarm {

class ScratchFile {
 public:
  ScratchFile() = default;
  /// @throws IoError, as all that follows.
  explicit ScratchFile(const std::filesystem::path& folder);
  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&& other) noexcept;
  ~ScratchFile();

  bool is_open() const { return descriptor_ >= 0; }
  std::int64_t size() const { return size_; }
  void append(const void* data, std::size_t bytes);
  /// At any place; what lies between it and the end before is zero.
  void write(std::int64_t place, const void* data, std::size_t bytes);
  /// @pre the bytes are there.
  void read(std::int64_t place, void* data, std::size_t bytes) const;

 private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;
};

}  // namespace tetfarm
