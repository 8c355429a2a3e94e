/// Numbers and arrays one after the other in memory, little endian: the bodies of artifact files.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.h"
#include "base/hash.h"
#include "mesh/core/subdomain.h"

namespace tetfarm {

// Arrays are copied as they lie in memory; a big-endian machine would need to turn each number.
static_assert(std::endian::native == std::endian::little);

class ByteWriter {
 public:
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void array(std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size_bytes());
  }
  template <class T>
  void array(const std::vector<T>& items) {
    array(std::span<const T>(items));
  }
  /// Not its length.
  void text(std::string_view text) { bytes_ += text; }
  void origins(const std::vector<Origin>& origins) {
    for (const Origin& origin : origins) number(origin.owner);
    for (const Origin& origin : origins) number(origin.index);
  }
  void hash(const Hash128& hash) {
    number(hash.low);
    number(hash.high);
  }
  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Throws CorruptFile naming `name`. Nothing is allocated before the bytes that would fill it are
/// known to be there.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  template <class T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    T value;
    std::memcpy(&value, take(1, sizeof value).data(), sizeof value);
    return value;
  }
  std::size_t count() {
    const auto value = number<std::uint64_t>();
    if (value > std::numeric_limits<std::int32_t>::max()) {
      fail("has a count of " + std::to_string(value));
    }
    return value;
  }
  template <class T>
  std::vector<T> array(std::size_t count) {
    const std::string_view bytes = take(count, sizeof(T));
    std::vector<T> items(count);
    if (count > 0) std::memcpy(items.data(), bytes.data(), bytes.size());
    return items;
  }
  std::string text(std::size_t count) { return std::string(take(count, 1)); }
  std::vector<Origin> origins(std::size_t count) {
    const auto owners = array<std::uint64_t>(count);
    const auto indices = array<std::uint32_t>(count);
    std::vector<Origin> origins(count);
    for (std::size_t i = 0; i < count; ++i) origins[i] = {owners[i], indices[i]};
    return origins;
  }
  Hash128 hash() {
    Hash128 hash;
    hash.low = number<std::uint64_t>();
    hash.high = number<std::uint64_t>();
    return hash;
  }
  void expect_end() const {
    if (!rest_.empty()) fail("has " + std::to_string(rest_.size()) + " surplus bytes");
  }
  [[noreturn]] void fail(const std::string& what) const { throw CorruptFile(what, name_); }

 private:
  std::string_view take(std::size_t count, std::size_t item_size) {
    if (count > rest_.size() / item_size) fail("is cut short");
    const std::string_view bytes = rest_.substr(0, count * item_size);
    rest_.remove_prefix(bytes.size());
    return bytes;
  }

  std::string_view rest_;
  const std::string& name_;
};

}  // namespace tetfarm
