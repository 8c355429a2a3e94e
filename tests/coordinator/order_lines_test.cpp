#include "coordinator/order_lines.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Lines of which two are served at once, with three orders under way each.
class OrderLinesTest : public testing::Test {
 protected:
  bool add(const std::string& connection, std::uint64_t offset, std::uint64_t attempt = 1,
           std::int64_t now_ms = 0) {
    FileOrder order;
    order.connection = connection;
    order.offset = offset;
    order.attempt = AttemptId{attempt};
    order.file.hash = "hash";
    return lines_.add(order, {WorkerId{1}, TaskId{1}, AttemptId{attempt}}, at(now_ms));
  }
  /// "CONNECTION OFFSET" of each.
  std::vector<std::string> take(std::int64_t now_ms = 0) {
    std::vector<std::string> taken;
    for (const FileOrder& order : lines_.take(at(now_ms))) {
      taken.push_back(order.connection + " " + std::to_string(order.offset));
    }
    return taken;
  }
  static Moment at(std::int64_t ms) { return {ms, 0}; }

  OrderLines lines_{{.served = 2, .under_way = 3}};
};

TEST_F(OrderLinesTest, carry_out_so_many_at_once_and_the_next_as_answers_come) {
  for (std::uint64_t i = 0; i < 5; ++i) EXPECT_TRUE(add("a", i));
  EXPECT_THAT(take(), ElementsAre("a 0", "a 1", "a 2"));
  EXPECT_THAT(take(), IsEmpty());
  lines_.note_answer("a");
  EXPECT_THAT(take(), ElementsAre("a 3"));
  lines_.note_answer("nobody");
  EXPECT_THAT(take(), IsEmpty());
  lines_.note_answer("a");
  lines_.note_answer("a");
  EXPECT_THAT(take(), ElementsAre("a 4"));
}

TEST_F(OrderLinesTest, are_served_in_the_order_in_which_they_asked_first) {
  add("z", 0);
  add("y", 0);
  add("x", 0);
  add("w", 0);
  EXPECT_THAT(take(), ElementsAre("y 0", "z 0")) << "two at once";
  lines_.note_answer("y");
  lines_.note_answer("z");
  EXPECT_THAT(take(4000), IsEmpty()) << "they may ask for more";
  EXPECT_THAT(take(4001), ElementsAre("w 0", "x 0")) << "twice the time in which they would ask";
}

TEST_F(OrderLinesTest, with_something_to_do_make_no_room_however_silent) {
  add("a", 0);
  add("b", 0);
  take();
  add("c", 0);
  EXPECT_THAT(take(100'000), IsEmpty()) << "both are under way";
  lines_.note_answer("a");
  EXPECT_THAT(take(100'000), ElementsAre("c 0"));
}

TEST_F(OrderLinesTest, take_no_order_twice_and_none_beyond_the_window) {
  EXPECT_TRUE(add("a", 0));
  EXPECT_TRUE(add("a", 0)) << "it waits already";
  EXPECT_THAT(take(), ElementsAre("a 0"));
  EXPECT_TRUE(add("a", 0)) << "what is under way may have been lost";
  EXPECT_THAT(take(), ElementsAre("a 0"));
  for (std::uint64_t i = 1; i <= 2 * chunks_at_once - 2; ++i) EXPECT_TRUE(add("a", i)) << i;
  EXPECT_FALSE(add("a", 99)) << "two under way, thirty that wait";
  EXPECT_TRUE(add("a", 1)) << "still no second one";
  EXPECT_TRUE(add("b", 99)) << "each has a window of its own";
}

TEST_F(OrderLinesTest, of_another_attempt_take_the_place_of_those_that_wait) {
  add("a", 0, 1);
  add("a", 1, 1);
  add("a", 7, 2);
  EXPECT_THAT(take(), ElementsAre("a 7"));
}

TEST_F(OrderLinesTest, are_erased_by_who_they_are_for) {
  add("a", 0, 1);
  add("b", 0, 2);
  lines_.erase_if([](const LineHolder& holder) { return holder.attempt == AttemptId{1}; });
  EXPECT_THAT(take(), ElementsAre("b 0"));
  EXPECT_FALSE(lines_.empty());
  lines_.clear();
  EXPECT_TRUE(lines_.empty());
}

}  // namespace
}  // namespace tetfarm
