#include "base/printable_text.h"

#include <gtest/gtest.h>

#include "base/utf8.h"

namespace tetfarm {
namespace {

TEST(PrintableText, keeps_what_people_write) {
  for (const char* text : {"", "wing", "C:\\new", "Flügel, 20 € …", "\U0001F600", "a\\u001b"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(PrintableText, shows_control_characters_instead_of_obeying_them) {
  EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\rd");
  EXPECT_EQ(printable("\x1b[2J"), "\\u001b[2J");
  EXPECT_EQ(printable("\x7f"), "\\u007f");
  EXPECT_EQ(printable("\u009b31m"), "\\u009b31m") << "one character that begins a sequence";
  EXPECT_EQ(printable("\u202egnp.exe"), "\\u202egnp.exe");
  EXPECT_EQ(printable(std::string(1, '\0')), "\\u0000");
}

TEST(PrintableText, shows_bytes_that_are_no_utf8) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("a\xc3"), "a\\xc3");
  EXPECT_EQ(printable("\x9b"), "\\x9b");
}

TEST(PrintableText, keeps_lines_where_there_may_be_some) {
  EXPECT_EQ(printable("a\n\tb\r\x1b", Lines::kept), "a\n\tb\\r\\u001b");
}

TEST(PrintableText, is_always_utf8_and_harmless_whatever_the_bytes) {
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string text = {static_cast<char>(first), static_cast<char>(second), 'z'};
      const std::string shown = printable(text);
      ASSERT_TRUE(is_utf8(shown));
      for (std::size_t at = 0; at < shown.size(); at += code_point_at(shown, at).bytes) {
        ASSERT_FALSE(is_control(code_point_at(shown, at).value));
      }
      ASSERT_EQ(printable(shown), shown);
    }
  }
}

TEST(PrintableText, has_a_form_for_each_byte_that_is_not_plain) {
  std::string ascii;
  for (int c = ' '; c <= '~'; ++c) ascii += static_cast<char>(c);
  EXPECT_EQ(printable(ascii), ascii);
  EXPECT_EQ(printable("\x01\x1f\x7f"), "\\u0001\\u001f\\u007f");
  EXPECT_EQ(printable("x\x80\xa0\xffy"), "x\\x80\\xa0\\xffy");
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");
  EXPECT_EQ(printable("a\nb", Lines::kept), "a\nb");
  EXPECT_EQ(printable("a\r\nb", Lines::kept), "a\\r\nb");
  EXPECT_EQ(printable("\u2028"), "\\u2028");
}

}  // namespace
}  // namespace tetfarm
