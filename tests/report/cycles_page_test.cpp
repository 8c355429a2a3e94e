#include "report/cycles_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/html_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* attack = "<script>alert('x')</script>";

CyclesContent two_cycles() {
  CyclesContent content;
  content.name = attack;
  content.cycles = 2;
  for (const std::int64_t number : {1, 2}) {
    content.shown.push_back(
        {number, {attack, "mesh" + std::to_string(number)}, {"u", "PNG"}, attack});
  }
  content.chart = "<svg></svg>";
  content.head = {"cycle", "vertices"};
  content.rows = {{"1", "100"}, {"2", attack}};
  return content;
}

TEST(CyclesPage, shows_the_meshes_and_solutions_of_all_cycles_their_chart_and_their_table) {
  const std::string page = cycles_page(two_cycles());
  for (const char* mesh : {"mesh1", "mesh2"}) EXPECT_THAT(page, HasSubstr(base64(mesh)));
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml;base64," + base64("<svg></svg>")));
  EXPECT_THAT(page, HasSubstr("<td>100</td>"));
  EXPECT_THAT(page, HasSubstr("2 cycles of an adaptation loop. "));
}

TEST(CyclesPage, says_how_many_of_many_cycles_are_shown) {
  CyclesContent content = two_cycles();
  content.cycles = 40;
  EXPECT_THAT(cycles_page(content), HasSubstr("40 cycles of an adaptation loop, of which 2 are"));
}

TEST(CyclesPage, leaves_out_what_there_is_nothing_of) {
  CyclesContent content = two_cycles();
  content.chart.clear();
  for (ReportedCycle& cycle : content.shown) cycle.last_words.clear();
  const std::string page = cycles_page(content);
  EXPECT_THAT(page, Not(HasSubstr("Along the walls")));
  EXPECT_THAT(page, Not(HasSubstr("said last")));
}

TEST(CyclesPage, takes_no_markup_from_names_and_solvers) {
  EXPECT_THAT(cycles_page(two_cycles()), Not(HasSubstr("<script")));
}

}  // namespace
}  // namespace tetfarm
