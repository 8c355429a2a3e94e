#include "base/hex_text.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(HexText, has_two_digits_a_byte_the_high_half_first) {
  EXPECT_EQ(hex_of_bytes(std::string_view("\x00\x0f\xa5\xff", 4)), "000fa5ff");
  EXPECT_EQ(hex_of_bytes(""), "");
}

}  // namespace
}  // namespace tetfarm
