/// The bytes of a file, brought into memory by the system as they are looked at.
///
/// The file must not be shortened while it is mapped; it may be removed or replaced. Memory: pages
/// that were looked at, which the system takes back when it needs them and shares among processes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace tetfarm {

class MappedFile {
 public:
  /// None, without bytes.
  MappedFile() = default;
  /// @throws IoError.
  explicit MappedFile(const std::filesystem::path& path);
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  ~MappedFile();

  std::string_view bytes() const { return bytes_; }
  /// The pages of the first so many bytes leave memory; they come back when they are looked at.
  void let_go(std::size_t count) const;

 private:
  std::string_view bytes_;
};

}  // namespace tetfarm
