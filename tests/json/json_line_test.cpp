#include "json/json_line.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(JsonLine, has_no_break_and_keeps_the_order_of_keys) {
  EXPECT_EQ(json_line({{"b", "two\nlines"}, {"a", 1}}), R"({"b":"two\nlines","a":1})");
}

TEST(JsonLine, has_a_sign_in_place_of_bytes_that_are_no_text) {
  EXPECT_EQ(json_line({{"name", "w\xffng \xc3\xbc"}}), "{\"name\":\"w\xef\xbf\xbdng \xc3\xbc\"}");
}

}  // namespace
}  // namespace tetfarm
