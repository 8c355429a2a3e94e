#include "cli/coloured_text.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(ColouredText, is_red_only_where_colours_are_wanted) {
  EXPECT_EQ(red("0.2 deg", true), "\033[31m0.2 deg\033[0m");
  EXPECT_EQ(red("0.2 deg", false), "0.2 deg");
}

}  // namespace
}  // namespace tetfarm
