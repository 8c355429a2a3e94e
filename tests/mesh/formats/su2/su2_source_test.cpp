#include "mesh/formats/su2/su2_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

const std::string one_tet =
    "% one tet\nNDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\n"
    "NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 4\n5 1 2 3\n5 0 3 2\n5 0 1 3\n5 0 2 1\n";

TEST(Su2Source, reads_comments_blanks_and_sections_in_any_order) {
  EXPECT_EQ(refusal_of("a.su2", one_tet), "");
  const std::size_t points = one_tet.find("NPOIN");
  const std::size_t marks = one_tet.find("NMARK");
  EXPECT_EQ(
      refusal_of("a.su2", "NDIME = 3 % here\n\n" + one_tet.substr(marks) +
                              one_tet.substr(points, marks - points) + "NELEM =1\n10 0 1 2 3\n"),
      "");
}

TEST(Su2Source, names_the_line_of_what_is_wrong) {
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "10 0 1", "12 0 1")), HasSubstr("a.su2:4: "));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "0 0 1 3", "0 x 1 3")), HasSubstr("a.su2:9: "));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "5 1 2 3", "7 1 2 3 0")), HasSubstr(":13: "));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "NDIME= 3", "NDIME= 2")), HasSubstr(":2: "));
}

TEST(Su2Source, refuses_counts_that_the_file_cannot_hold_and_nodes_that_are_not_there) {
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "NELEM= 1", "NELEM= 99999999999")),
              HasSubstr("a count of 99999999999"));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "NPOIN= 4", "NPOIN= -4")), HasSubstr(":5: "));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "10 0 1 2 3", "10 0 1 2 4")),
              HasSubstr("tet 0 has node 4 of 4"));
  EXPECT_THAT(refusal_of("a.su2", changed(one_tet, "5 0 2 1", "5 0 2 9")),
              HasSubstr("boundary triangle 3 has node 9"));
  EXPECT_THAT(refusal_of("a.su2", "NDIME= 3\n"), HasSubstr("no tets"));
}

}  // namespace
}  // namespace tetfarm
