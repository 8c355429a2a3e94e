#include "base/hash.h"

#include <xxhash.h>

#include <array>
#include <cstdio>

#include "base/check.h"

namespace tetfarm {

struct Hasher::State {
  XXH3_state_t* xxh = nullptr;
};

std::string Hash128::hex() const {
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(high),
                static_cast<unsigned long long>(low));
  return text.data();
}

Hash128 hash128(const void* data, std::size_t size) {
  TF_CHECK(data != nullptr || size == 0);
  const XXH128_hash_t hash = XXH3_128bits(data, size);
  return {hash.high64, hash.low64};
}

Hasher::Hasher() : state_(std::make_unique<State>()) {
  state_->xxh = XXH3_createState();
  TF_CHECK(state_->xxh != nullptr);
  XXH3_128bits_reset(state_->xxh);
}

Hasher::~Hasher() {
  if (state_) XXH3_freeState(state_->xxh);
}

Hasher::Hasher(Hasher&&) noexcept = default;

Hasher& Hasher::operator=(Hasher&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}

void Hasher::add(const void* data, std::size_t size) {
  TF_CHECK(state_ != nullptr);  // not moved from
  XXH3_128bits_update(state_->xxh, data, size);
}

Hash128 Hasher::finish() const {
  TF_CHECK(state_ != nullptr);
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
  return {hash.high64, hash.low64};
}

}  // namespace tetfarm
