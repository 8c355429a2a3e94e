#include "mesh/formats/external_sort.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

struct Numbered {
  std::int32_t key = 0;
  std::int32_t order = 0;
  bool operator<(const Numbered& other) const { return key < other.key; }
};

/// The records come sorted, equal ones in the order in which they were pushed.
void expect_sorted(int count, std::size_t in_memory) {
  const TempFolder folder;
  std::mt19937 random(7);
  std::vector<Numbered> records;
  ExternalSort<Numbered> sort(folder.path(), in_memory);
  for (int i = 0; i < count; ++i) {
    records.push_back({static_cast<std::int32_t>(random() % 1000), i});
    sort.push(records.back());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "its file has no name";
  std::stable_sort(records.begin(), records.end());
  Numbered next;
  for (const Numbered& expected : records) {
    ASSERT_TRUE(sort.next(next));
    ASSERT_EQ(next.key, expected.key);
    ASSERT_EQ(next.order, expected.order);
  }
  EXPECT_FALSE(sort.next(next));
}

TEST(ExternalSort, in_memory_and_on_disk_give_the_same) {
  expect_sorted(0, 10);
  expect_sorted(500, 1000);
  expect_sorted(1000, 1000);
  expect_sorted(50'000, 9'000);
  expect_sorted(1000, 1);
}

}  // namespace
}  // namespace tetfarm
