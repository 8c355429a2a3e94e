#include "report/html_table.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(HtmlTable, has_a_head_where_there_is_one_and_a_row_for_each) {
  EXPECT_EQ(html_table({"a", "<b>"}, {{"1", "2 & 3"}, {"4", ""}}),
            "<table>\n<thead><tr><th>a</th><th>&lt;b&gt;</th></tr>\n</thead>\n<tbody>\n"
            "<tr><td>1</td><td>2 &amp; 3</td></tr>\n<tr><td>4</td><td></td></tr>\n"
            "</tbody></table>\n");
  EXPECT_EQ(html_table({}, {{"only"}}),
            "<table>\n<tbody>\n<tr><td>only</td></tr>\n</tbody></table>\n");
}

}  // namespace
}  // namespace tetfarm
