#include <gtest/gtest.h>

#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

TEST(MemoryAmount, is_known_in_each_unit_in_any_case) {
  const std::vector<std::pair<const char*, std::int64_t>> amounts = {
      {"3", 3},
      {"3B", 3},
      {"3b", 3},
      {"3kB", 3'000},
      {"3KB", 3'000},
      {"3MB", 3'000'000},
      {"3gb", 3'000'000'000},
      {"3TB", 3'000'000'000'000},
      {"3KiB", 3 * 1024},
      {"3MiB", std::int64_t{3} << 20U},
      {"3 GIB", std::int64_t{3} << 30U},
      {"3tib", std::int64_t{3} << 40U},
      {"1.9", 1},
      {"0.0015 kB", 1},
      {"1e3", 1000},
      {"8192TiB", std::int64_t{1} << 53U},
      {"9007199254740992", std::int64_t{1} << 53U}};
  for (const auto& [text, bytes] : amounts) EXPECT_EQ(parse_memory(text), bytes) << text;
}

TEST(MemoryAmount, is_nothing_for_less_than_a_byte_or_too_much_or_another_text) {
  for (const char* text : {"0.9", "0.0009kB", "9007199254740994", "2 GiB ", "GiB", "2 G", "2 PB",
                           "2,5GB", " 2GB", "-2GB", "+2GB", "2GB2", "2\tGB"}) {
    EXPECT_EQ(parse_memory(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace tetfarm
