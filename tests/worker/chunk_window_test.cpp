#include "worker/chunk_window.h"

#include <gmock/gmock.h>

#include <vector>

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::uint64_t size = 100 * chunk_bytes;

/// The numbers of the chunks that are due.
std::vector<std::uint64_t> due(ChunkWindow& window, std::uint64_t there, std::int64_t now_ms) {
  std::vector<std::uint64_t> chunks;
  while (const auto offset = window.next(size, there, now_ms)) {
    chunks.push_back(*offset / chunk_bytes);
  }
  return chunks;
}

TEST(ChunkWindow, begins_with_two_chunks_and_ends_with_the_file) {
  ChunkWindow window;
  EXPECT_THAT(due(window, 0, 0), ElementsAre(0U, 1U));
  window.start_again(size - chunk_bytes / 2);
  EXPECT_EQ(window.next(size, size - chunk_bytes / 2, 0), size - chunk_bytes / 2);
  EXPECT_EQ(window.next(size, size - chunk_bytes / 2, 0), std::nullopt);
}

TEST(ChunkWindow, a_lost_chunk_is_due_again_after_a_while_and_then_more_patiently) {
  ChunkWindow window;
  due(window, 0, 0);
  EXPECT_THAT(due(window, 0, chunk_again_ms), IsEmpty());
  const std::int64_t second = chunk_again_ms + 1;
  EXPECT_THAT(due(window, 0, second), ElementsAre(0U)) << "and only one at a time";
  EXPECT_THAT(due(window, 0, second + 2 * chunk_again_ms), IsEmpty());
  EXPECT_THAT(due(window, 0, second + 2 * chunk_again_ms + 1), ElementsAre(0U));
}

TEST(ChunkWindow, what_has_arrived_is_not_due_again) {
  ChunkWindow window;
  due(window, 0, 0);
  window.note(chunk_bytes, 100);
  EXPECT_THAT(due(window, chunk_bytes, 100), AllOf(Contains(2U), Not(Contains(0U))));
  EXPECT_THAT(due(window, chunk_bytes, 100 + chunk_again_ms + 1),
              AllOf(Contains(1U), Not(Contains(0U))));
}

TEST(ChunkWindow, grows_on_a_quick_connection_up_to_its_limit_and_shrinks_on_a_slow_one) {
  ChunkWindow window;
  std::uint64_t there = 0;
  std::int64_t now = 0;
  for (; there < size / 2; there += chunk_bytes) {
    window.note(there, now += 10);
    due(window, there, now);
    EXPECT_LE(window.width(), chunks_at_once);
  }
  EXPECT_EQ(window.width(), chunks_at_once);
  for (; there < size; there += chunk_bytes) {
    window.note(there, now += 1'500);
    due(window, there, now);
  }
  EXPECT_LT(window.width(), 4U);
}

TEST(ChunkWindow, does_not_ask_twice_for_what_comes_slowly) {
  ChunkWindow window;
  std::uint64_t asked = 0;
  std::uint64_t there = 0;
  // A chunk each three seconds.
  for (std::int64_t now = 0; now < 300'000; now += 100) {
    while (window.next(size, there, now)) ++asked;
    if (now > 0 && now % 3'000 == 0) {
      there += chunk_bytes;
      window.note(there, now);
    }
  }
  EXPECT_LE(asked, there / chunk_bytes + 6);
}

}  // namespace
}  // namespace tetfarm
