#include "cli/roff_text.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(RoffText, is_read_as_it_is) {
  EXPECT_EQ(roff_text("run a job"), "run a job");
  EXPECT_EQ(roff_text("--no-check"), "\\-\\-no\\-check") << "no hyphens, which cannot be typed";
  EXPECT_EQ(roff_text("a\\b"), "a\\eb");
  EXPECT_EQ(roff_text("'x' `y` ~/.z ^"), "\\(aqx\\(aq \\(gay\\(ga \\(ti/.z \\(ha");
  EXPECT_EQ(roff_text(".tetfarm"), "\\&.tetfarm") << "which is no request";
}

TEST(RoffText, stands_out) {
  EXPECT_EQ(roff_bold("-o"), "\\fB\\-o\\fR");
  EXPECT_EQ(roff_italic("DIR"), "\\fIDIR\\fR");
}

TEST(RoffText, of_entries_ends_with_a_full_stop) {
  EXPECT_EQ(roff_entry("\\fBx\\fR", "It is so"), ".TP\n\\fBx\\fR\nIt is so.\n");
  EXPECT_EQ(roff_entry("x", "It is so."), ".TP\nx\nIt is so.\n");
}

TEST(RoffText, keeps_lines) { EXPECT_EQ(roff_lines("a\n\n.b"), ".nf\na\n.sp\n\\&.b\n.fi\n"); }

}  // namespace
}  // namespace tetfarm
