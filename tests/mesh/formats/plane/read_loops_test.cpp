#include "mesh/formats/plane/read_loops.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

const std::string lednicer =
    "An airfoil\n"   // line 1
    "   4.    3.\n"  // 2
    "\n"             // 3
    "0.0  0.0\n"     // 4
    "0.2  0.1\n"     // 5
    "0.6  0.08\n"    // 6
    "1.0  0.001\n"   // 7
    "\n"             // 8
    "0.0  0.0\n"     // 9
    "0.5 -0.05\n"    // 10
    "1.0 -0.001\n";  // 11

std::vector<PlaneLoop> loops_of_text(const std::string& text) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a.dat", text);
  return read_loops(folder.path() / "a.dat");
}

std::string refusal_of_loops(const std::string& text) {
  return error_text_of<InvalidInput>([&] { loops_of_text(text); });
}

std::string with_change(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(ReadLoops, joins_the_sides_of_an_airfoil_in_lednicers_form) {
  const std::vector<PlaneLoop> loops = loops_of_text(lednicer);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_THAT(loops[0].points, ElementsAre(Vec2{1, 0.001}, Vec2{0.6, 0.08}, Vec2{0.2, 0.1},
                                           Vec2{0, 0}, Vec2{0.5, -0.05}, Vec2{1, -0.001}));
  EXPECT_THAT(loops[0].where, EndsWith("a.dat:4"));
}

TEST(ReadLoops, closes_an_airfoil_with_a_sharp_trailing_edge_once) {
  std::string sharp = with_change(lednicer, "1.0  0.001", "1 0");
  sharp = with_change(sharp, "1.0 -0.001", "1 0");
  EXPECT_THAT(
      loops_of_text(sharp).at(0).points,
      ElementsAre(Vec2{1, 0}, Vec2{0.6, 0.08}, Vec2{0.2, 0.1}, Vec2{0, 0}, Vec2{0.5, -0.05}));
}

TEST(ReadLoops, takes_two_whole_numbers_for_a_point_where_the_next_line_is_one) {
  const std::vector<PlaneLoop> loops = loops_of_text("2 2\n3 2\n3 3\n\n5 2\n6 2\n6 3\n");
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].points.size(), 3U);
}

TEST(ReadLoops, refuses_sides_with_other_numbers_of_points) {
  EXPECT_THAT(refusal_of_loops(with_change(lednicer, "0.6  0.08\n", "")),
              HasSubstr("a.dat:4: the sides have 4 and 3 points, as the file says, but it has 6"));
  EXPECT_THAT(refusal_of_loops(lednicer + "0.2 0.2\n"), HasSubstr("but it has 8"));
  EXPECT_THAT(refusal_of_loops("a title\n3 3\n\n"), HasSubstr("a.dat:3: the sides have 3 and 3"));
}

TEST(ReadLoops, names_the_line_of_what_is_no_point_in_an_airfoil) {
  EXPECT_THAT(refusal_of_loops(with_change(lednicer, "0.5 -0.05", "0.5 x")),
              HasSubstr("a.dat:10: a point is two numbers"));
  EXPECT_THAT(refusal_of_loops(with_change(lednicer, "0.6  0.08", "0.2 0.1")),
              HasSubstr("a.dat:6: the point is that of the line before"));
}

TEST(ReadLoops, refuses_one_number_of_points_that_no_file_has) {
  EXPECT_THAT(refusal_of_loops("2000000 3\n\n0 0\n1 0\n0 1\n"),
              HasSubstr("a loop has at least three points"));
}

}  // namespace
}  // namespace tetfarm
