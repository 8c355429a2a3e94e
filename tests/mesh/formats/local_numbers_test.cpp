#include "mesh/formats/local_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace tetfarm {
namespace {

TEST(LocalNumbers, are_those_of_a_map_and_sort_by_the_global_ones) {
  std::mt19937_64 random(1);
  LocalNumbers numbers;
  std::map<std::int64_t, std::int32_t> known;
  for (int i = 0; i < 20'000; ++i) {
    const auto global = static_cast<std::int64_t>(random() % 9'000) << (i % 3 * 20);
    EXPECT_EQ(numbers.find(global), known.contains(global) ? known[global] : -1);
    const auto next = static_cast<std::int32_t>(known.size());
    EXPECT_EQ(numbers.of(global), known.try_emplace(global, next).first->second);
  }
  const std::vector<std::int32_t> sorted = numbers.sort();
  const std::vector<std::int64_t> globals = numbers.take();
  ASSERT_EQ(globals.size(), known.size());
  EXPECT_TRUE(std::is_sorted(globals.begin(), globals.end()));
  for (const auto& [global, local] : known) {
    EXPECT_EQ(globals[static_cast<std::size_t>(sorted[static_cast<std::size_t>(local)])], global);
  }
}

}  // namespace
}  // namespace tetfarm
