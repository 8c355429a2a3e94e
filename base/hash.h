/// XXH3-128, the checksum of artifacts and the digest of meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace tetfarm {

/// A 128-bit hash; printed as 32 hexadecimal digits, high half first.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  friend bool operator==(const Hash128&, const Hash128&) = default;
  std::string hex() const;
};

/// Hash of one block of bytes.
Hash128 hash128(const void* data, std::size_t size);
inline Hash128 hash128(std::string_view bytes) { return hash128(bytes.data(), bytes.size()); }

/// Hash of a stream of bytes: the same as hash128 of their concatenation.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  void add(const void* data, std::size_t size);
  Hash128 finish() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tetfarm
