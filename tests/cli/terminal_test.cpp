#include "cli/terminal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tetfarm {
namespace {

/// What the guard writes of texts that come one after the other.
std::string shown(const std::vector<std::string>& texts) {
  std::string all;
  std::string kept_back;
  for (const std::string& text : texts) {
    Guarded now = guarded(kept_back + text);
    all += now.shown;
    kept_back = now.kept_back;
  }
  return all + "|" + kept_back;
}

TEST(Terminal, is_shown_text_as_it_is) {
  EXPECT_EQ(shown({"done\n", "\tFlügel 20 €\n"}), "done\n\tFlügel 20 €\n|");
}

TEST(Terminal, is_not_steered_by_what_is_shown) {
  EXPECT_EQ(shown({"\x1b]0;title\a\x1b[2J\r\b\n"}),
            "\\u001b]0;title\\u0007\\u001b[2J\\r\\u0008\n|");
  EXPECT_EQ(shown({"\u009b2J\xff.\n"}), "\\u009b2J\\xff.\n|");
}

TEST(Terminal, shows_our_own_red) {
  const std::string red = std::string(red_begins) + "bad" + std::string(red_ends) + "\n";
  EXPECT_EQ(shown({red}), red + "|");
  EXPECT_EQ(shown({"\033[3", "1mbad\033", "[0m\n"}), red + "|");
  EXPECT_EQ(shown({"\033[3", "2mgreen\n"}), "\\u001b[32mgreen\n|");
}

TEST(Terminal, is_shown_characters_that_come_in_two_pieces) {
  EXPECT_EQ(shown({"20 \xe2\x82", "\xac\n"}), "20 €\n|");
  EXPECT_EQ(shown({"\xf0\x9f", "\x98", "\x80\n"}), "\U0001F600\n|");
  EXPECT_EQ(shown({"\xe2", "x\n"}), "\\xe2x\n|");
  EXPECT_EQ(shown({"\x80\x80\x80\x80\x80"}), "\\x80\\x80\\x80\\x80\\x80|");
}

}  // namespace
}  // namespace tetfarm
