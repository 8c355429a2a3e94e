#include "mesh/inspect/vtp_triangles.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/inspect/vtp_text.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string two_triangles() {
  VtpTriangles text;
  text.legend = "<!-- height 3: tall -->\n";
  text.points = 4;
  text.coordinates = "0 0 0\n1 0 0\n0 1.5 0\n0 0 -1e-3\n";
  text.triangles = 2;
  text.corners = "0 1 2\n0 2 3\n";
  text.arrays = {{"Int64", "height", "3\n4\n"}, {"Float64", "width", "0.1\n2e5\n"}};
  return vtp_text(text);
}

std::string refusal_of(std::string text, const std::string& what, const std::string& by) {
  const std::size_t found = text.find(what);
  EXPECT_NE(found, std::string::npos);
  text.replace(found, what.size(), by);
  return error_text_of<InvalidInput>([&] { triangles_from_vtp(text, "map.vtp"); });
}

TEST(VtpTriangles, are_those_that_were_written) {
  const NumberedTriangles read = triangles_from_vtp(two_triangles(), "map.vtp");
  EXPECT_THAT(read.points,
              ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1.5, 0}, Vec3{0, 0, -1e-3}));
  EXPECT_THAT(read.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(read.arrays.at("height"), ElementsAre(3, 4));
  EXPECT_THAT(read.arrays.at("width"), ElementsAre(0.1, 2e5));
  EXPECT_EQ(read.arrays.size(), 2);
}

TEST(VtpTriangles, of_a_damaged_file_are_refused_with_what_is_wrong) {
  const std::string whole = two_triangles();
  EXPECT_THAT(refusal_of(whole, "0 2 3\n", "0 2 4\n"),
              HasSubstr("map.vtp: triangle 1 has a corner"));
  EXPECT_THAT(refusal_of(whole, "0 2 3\n", "0 -2 3\n"), HasSubstr("triangle 1 has a corner"));
  EXPECT_THAT(refusal_of(whole, "0 2 3\n", "0 1.5 3\n"), HasSubstr("triangle 1 has a corner"));
  EXPECT_THAT(refusal_of(whole, "0 2 3\n", "0 2\n"), HasSubstr("three corners"));
  EXPECT_THAT(refusal_of(whole, "1 0 0\n", "1 0\n"), HasSubstr("three coordinates"));
  EXPECT_THAT(refusal_of(whole, "1 0 0\n", "1 nan 0\n"), HasSubstr("\"Points\" is none"));
  EXPECT_THAT(refusal_of(whole, "3\n4\n", "3\n"), HasSubstr("\"height\" has 1 numbers for 2"));
  EXPECT_THAT(refusal_of(whole, "3\n4\n", "3\nfour\n"), HasSubstr("number 2 of the array"));
  EXPECT_THAT(refusal_of(whole, "format=\"ascii\"", "format=\"binary\""), HasSubstr("not text"));
  for (std::size_t end = 0; end < whole.size(); end += 7) {
    try {
      triangles_from_vtp(whole.substr(0, end), "map.vtp");
    } catch (const InvalidInput&) {
      continue;
    }
  }
}

}  // namespace
}  // namespace tetfarm
