/// A file that is filled at several places at once: mesh files whose arrays lie one after the other
/// get a piece of each array with each part of the mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tetfarm {

/// Every failure throws IoError naming the file.
class OutputFile {
 public:
  enum class Start { empty, as_it_is };

  /// Makes the file, or opens the one that is there: empty, or to be written over in places.
  explicit OutputFile(std::filesystem::path path, Start start = Start::empty);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  void write(std::int64_t offset, std::string_view bytes);
  /// The numbers as they lie in memory.
  template <class T>
  void write(std::int64_t offset, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(offset, std::string_view(reinterpret_cast<const char*>(values.data()),
                                   values.size() * sizeof(T)));
  }
  /// On the disk, or throws.
  void finish();

 private:
  /// Lets the disk work while the rest is made, so that `finish` does not wait for all of it.
  void begin_to_store(std::int64_t written);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::int64_t since_stored_ = 0;  ///< bytes
};

}  // namespace tetfarm
