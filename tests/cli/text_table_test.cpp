#include "cli/text_table.h"

#include <gtest/gtest.h>

#include <string>

namespace tetfarm {
namespace {

TEST(TextTable, has_columns_as_wide_as_their_longest_text_and_no_blanks_at_ends) {
  EXPECT_EQ(table_text({"A", "LONG", "LAST"}, {{"1", "2", ""}, {"four", "", "x y"}, {"5"}}),
            "A     LONG  LAST\n"
            "1     2\n"
            "four        x y\n"
            "5\n");
  EXPECT_EQ(table_text({"A"}, {}), "");
}

TEST(TextTable, cells_are_printable_and_no_longer_than_a_line) {
  EXPECT_EQ(table_text({"A", "B"}, {{"a\nb", "\x1b"}}), "A     B\na\\nb  \\u001b\n");
  const std::string cut = table_text({"A"}, {{std::string(161, 'x')}});
  EXPECT_EQ(cut, "A\n" + std::string(160, 'x') + "…\n");
}

TEST(TextTable, a_harmless_text_is_cut_at_a_character_and_one_that_fits_is_whole) {
  EXPECT_EQ(harmless("12345", 5), "12345");
  EXPECT_EQ(harmless("123456", 5), "12345…");
  EXPECT_EQ(harmless("1234ü6", 5), "1234…");
  EXPECT_EQ(harmless("a\tb"), "a\\tb");
}

}  // namespace
}  // namespace tetfarm
