#include "base/hash.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(Hash128, of_nothing_is_the_published_value_of_xxh3) {
  EXPECT_EQ(hash128("").hex(), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash128, prints_32_digits_high_half_first) {
  EXPECT_EQ((Hash128{0x1, 0xab}).hex(), "000000000000000100000000000000ab");
}

TEST(Hash128, changes_with_one_bit) {
  std::string bytes(1000, 'x');
  const Hash128 before = hash128(bytes);
  bytes[500] = 'y';
  EXPECT_NE(hash128(bytes), before);
}

TEST(Hasher, of_pieces_equals_the_hash_of_the_whole) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(i * i % 251);
  for (const std::size_t step : {1U, 7U, 64U, 1024U, 5000U}) {
    Hasher hasher;
    for (std::size_t i = 0; i < bytes.size(); i += step) {
      hasher.add(bytes.data() + i, std::min(step, bytes.size() - i));
    }
    EXPECT_EQ(hasher.finish(), hash128(bytes)) << step;
  }
}

TEST(Hasher, goes_on_after_finish_and_survives_a_move) {
  Hasher hasher;
  hasher.add("abc", 3);
  EXPECT_EQ(hasher.finish(), hash128("abc"));
  Hasher moved = std::move(hasher);
  moved.add("def", 3);
  EXPECT_EQ(moved.finish(), hash128("abcdef"));
  Hasher assigned;
  assigned = std::move(moved);
  EXPECT_EQ(assigned.finish(), hash128("abcdef"));
}

}  // namespace
}  // namespace tetfarm
