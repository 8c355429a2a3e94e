#include "worker/element_input.h"
#include "tests/support/error_text.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Colours, are_the_second_words_of_the_lines) {
  EXPECT_THAT(colours_of("5 1 4 6\n4 0 5\n12 7\n"),
              ElementsAre(Pair(4, 0), Pair(5, 1), Pair(12, 7)));
  EXPECT_THAT(colours_of(""), ElementsAre());
  EXPECT_THAT(colours_of("4 2"), ElementsAre(Pair(4, 2))) << "without a last line end";
  for (const char* line : {"", "4", "x 1", "4 x", "4,1"}) {
    EXPECT_EQ(error_text_of([&] { colours_of("4 0\n" + std::string(line) + "\n5 1\n"); }),
              "the order of the turns has the line \"" + std::string(line) + "\"");
  }
}

TEST(LastTurn, is_that_of_the_highest_colour_whatever_the_order_of_the_sharers) {
  const Colours colours = {{4, 2}, {5, 0}, {6, 1}, {7, 3}};
  EXPECT_EQ(last_turn({4, 5, 6}, colours), 4U);
  EXPECT_EQ(last_turn({5, 6}, colours), 6U);
  EXPECT_EQ(last_turn({5}, colours), 5U);
  EXPECT_EQ(last_before({4, 5, 6, 7}, colours, 3), 4U);
  EXPECT_EQ(last_before({4, 5, 6, 7}, colours, 2), 6U) << "not one of that colour itself";
  EXPECT_EQ(last_before({4, 5, 6, 7}, colours, 0), 0U) << "the first turn is before all";
  EXPECT_EQ(error_text_of([&] { last_before({4, 9}, colours, 1); }), "sub-domain 9 has no turn");
}

}  // namespace
}  // namespace tetfarm
