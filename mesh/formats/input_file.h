/// A binary file that is read at places: stretches of it come into memory, never more. One that was
/// unpacked lies in memory already, and is read in the same way.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetfarm {

/// Threads may read at once.
class InputFile {
 public:
  /// @throws IoError.
  explicit InputFile(const std::filesystem::path& path);
  /// Bytes that outlive it; `name` is for messages.
  InputFile(std::string_view bytes, std::string name);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  std::int64_t size() const { return size_; }
  const std::string& name() const { return name_; }
  /// @throws InvalidInput when the file ends before; IoError.
  void read(std::int64_t place, void* data, std::size_t bytes) const;
  template <class T>
  T at(std::int64_t place) const {
    T value;
    read(place, &value, sizeof value);
    return value;
  }
  /// @throws InvalidInput "FILE: byte PLACE: what".
  [[noreturn]] void fail(const std::string& what, std::int64_t place) const;

 private:
  std::string name_;
  std::string_view bytes_;  ///< without a file
  int descriptor_ = -1;
  std::int64_t size_ = 0;
};

/// Turns the bytes of each number round.
template <class Number>
void turn_bytes(std::span<Number> numbers) {
  for (Number& number : numbers) {
    if constexpr (sizeof(Number) == 8) {
      std::uint64_t bits;
      std::memcpy(&bits, &number, 8);
      bits = __builtin_bswap64(bits);
      std::memcpy(&number, &bits, 8);
    } else {
      std::uint32_t bits;
      std::memcpy(&bits, &number, 4);
      bits = __builtin_bswap32(bits);
      std::memcpy(&number, &bits, 4);
    }
  }
}

}  // namespace tetfarm
