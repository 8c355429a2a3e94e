#include "cli/markdown_roff.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(MarkdownRoff, has_headings_and_paragraphs_without_the_title) {
  EXPECT_EQ(roff_of_markdown("# Title\n\nOne line\nand another.\n\nMore.\n\n## All keys\nText.\n"
                             "### Part\nText.\n"),
            "One line and another.\n.PP\nMore.\n.SH ALL KEYS\nText.\n.SS Part\nText.\n");
}

TEST(MarkdownRoff, keeps_the_words_of_links_and_marks_code_and_emphasis) {
  EXPECT_EQ(
      roff_of_markdown("See [the `room`](service.md#room), `--size` and *isotropic*: 2 * 3.\n"),
      "See the \\fBroom\\fR, \\fB\\-\\-size\\fR and \\fIisotropic\\fR: 2 * 3.\n");
  EXPECT_EQ(roff_of_markdown("An array [x, y] (of two)\n"), "An array [x, y] (of two)\n");
  EXPECT_EQ(roff_of_markdown("`[x, y]` and a lone ` mark\n"),
            "\\fB[x, y]\\fR and a lone \\(ga mark\n");
}

TEST(MarkdownRoff, keeps_fenced_lines_as_they_are) {
  EXPECT_EQ(roff_of_markdown("With\n```toml\n[spacing]\n\n.5 `x`\n```\nmore\n"),
            "With\n.PP\n.nf\n[spacing]\n.sp\n\\&.5 \\(gax\\(ga\n.fi\n.PP\nmore\n");
}

TEST(MarkdownRoff, makes_entries_of_rows) {
  EXPECT_EQ(roff_of_markdown("| key | default | unit | meaning |\n|---|---|---|---|\n"
                             "| `a.b` | 0.3 | none | by how much |\n"
                             "| `c` | must be given | length | `x\\|y`. Done |\n"),
            ".TP\n\\fBa.b\\fR\nby how much. Default: 0.3.\n"
            ".TP\n\\fBc\\fR\n\\fBx|y\\fR\\&. Done. Must be given. Unit: length.\n");
}

TEST(MarkdownRoff, takes_a_section_out_of_a_page) {
  const std::string_view page = "# T\n\n## One\nfirst\n### Part\nof it\n\n## Two\nsecond\n";
  EXPECT_EQ(markdown_section(page, "One"), "first\n### Part\nof it\n");
  EXPECT_EQ(markdown_section(page, "Two"), "second\n");
}

}  // namespace
}  // namespace tetfarm
