#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace tetfarm {
namespace {

TEST(Utf8, reads_characters_of_one_to_four_bytes) {
  EXPECT_EQ(code_point_at("a", 0).value, U'a');
  EXPECT_EQ(code_point_at("xé", 1).value, U'é');
  EXPECT_EQ(code_point_at("€", 0).bytes, 3U);
  EXPECT_EQ(code_point_at("\U0001F600", 0).value, U'\U0001F600');
  EXPECT_TRUE(is_utf8("Flügel € \U0001F600"));
  EXPECT_TRUE(is_utf8(""));
}

TEST(Utf8, takes_no_overlong_form_surrogate_or_half_character) {
  for (const char* text :
       {"\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
        "\xF8\x88\x80\x80\x80", "\x80", "\xC3", "\xE2\x82", "\xE2(\xA1", "\xFF"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
    EXPECT_EQ(code_point_at(text, 0).bytes, 0U) << text;
  }
}

TEST(Utf8, knows_what_steers_a_terminal_or_a_line) {
  for (const char32_t c : {U'\0', U'\n', U'\x1b', U'\x7f', U'\u0080', U'\u009b', U'\u2028',
                           U'\u202e', U'\u2066', U'\u200f'}) {
    EXPECT_TRUE(is_control(c)) << static_cast<unsigned>(c);
  }
  for (const char32_t c : {U' ', U'~', U'\u00a0', U'é', U'€', U'\u2026'}) {
    EXPECT_FALSE(is_control(c)) << static_cast<unsigned>(c);
  }
}

TEST(Utf8, is_cut_between_characters) {
  EXPECT_EQ(cut_utf8("abc", 3), "abc");
  EXPECT_EQ(cut_utf8("abc", 2), "ab");
  EXPECT_EQ(cut_utf8("aé", 2), "a");
  EXPECT_EQ(cut_utf8("€", 2), "");
  EXPECT_EQ(cut_utf8("x\U0001F600y", 4), "x");
  EXPECT_EQ(cut_utf8(std::string(10, '\x80'), 6).size(), 6U) << "no UTF-8: cut anywhere";
}

TEST(Utf8, reads_the_first_and_the_last_character_of_each_length) {
  struct Case {
    std::string text;
    char32_t value;
  };
  for (const Case& one : std::initializer_list<Case>{{std::string(1, '\0'), 0},
                                                     {"\x7f", 0x7F},
                                                     {"\xC2\x80", 0x80},
                                                     {"\xDF\xBF", 0x7FF},
                                                     {"\xE0\xA0\x80", 0x800},
                                                     {"\xED\x9F\xBF", 0xD7FF},
                                                     {"\xEE\x80\x80", 0xE000},
                                                     {"\xEF\xBF\xBF", 0xFFFF},
                                                     {"\xF0\x90\x80\x80", 0x10000},
                                                     {"\xF4\x8F\xBF\xBF", 0x10FFFF}}) {
    EXPECT_EQ(code_point_at(one.text, 0).value, one.value) << static_cast<unsigned>(one.value);
    EXPECT_EQ(code_point_at(one.text, 0).bytes, one.text.size())
        << static_cast<unsigned>(one.value);
    EXPECT_TRUE(is_utf8(one.text + one.text));
  }
  for (const char* text : {"\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xED\xBF\xBF",
                           "\xC2\xC0", "\xE1\x80\xC0", "\xF1\x80\x80", "\xF5\x80\x80\x80"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
    EXPECT_FALSE(is_utf8(std::string("ab") + text)) << text;
  }
}

TEST(Utf8, has_control_characters_in_these_ranges_and_no_others) {
  std::string ranges;
  char32_t first = 0;
  for (char32_t c = 0; c <= 0x3000; ++c) {
    const bool begins = is_control(c) && (c == 0 || !is_control(c - 1));
    if (begins) first = c;
    if (!is_control(c) || is_control(c + 1)) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%X-%X ", static_cast<unsigned>(first),
                  static_cast<unsigned>(c));
    ranges += text;
  }
  EXPECT_EQ(ranges, "0-1F 7F-9F 61C-61C 200E-200F 2028-202E 2066-2069 ");
}

}  // namespace
}  // namespace tetfarm
