#include "mesh/formats/off/read_off.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

SurfaceMesh read(const std::string& text) { return read_off(text, "a.off"); }

TEST(ReadOff, keeps_the_numbers_of_vertices_and_triangles) {
  const SurfaceMesh cube = shapes::unit_cube();
  const SurfaceMesh back = read(texts::off(cube));
  EXPECT_EQ(back.vertices, cube.vertices);
  EXPECT_EQ(back.triangles, cube.triangles);
}

TEST(ReadOff, reads_counts_beside_the_keyword_comments_colours_and_polygons) {
  const SurfaceMesh mesh = read(
      "\xef\xbb\xbf# by hand\nCOFF 4 2 # no edges\n\n0 0 0 255 0 0\n1 0 0 0 0 0 # second\n"
      "1 1 0 1 1 1\n0 1 0 0 0 0\n4 0 1 2 3 0.5 0.5 0.5\n3 2 1 0 7\n# end\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{2, 1, 0}));
}

TEST(ReadOff, names_the_line_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& text) { return [=] { read(text); }; };
  const std::string square = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  EXPECT_THAT(reading("PLY\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.off:1: expected OFF")));
  EXPECT_THAT(reading("OFF FOUR\n4 1 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("expected the number of vertices")));
  EXPECT_THAT(reading(square + "3 0 1 4\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.off:7: vertex 4 of 4")));
  EXPECT_THAT(reading(square + "3 0 1 -1\n"), ThrowsMessage<InvalidInput>(HasSubstr("vertex -1")));
  EXPECT_THAT(reading(square + "2 0 1\n"), ThrowsMessage<InvalidInput>(HasSubstr("2 vertices")));
  EXPECT_THAT(reading(square + "3 0 1\n"), ThrowsMessage<InvalidInput>(HasSubstr("found nothing")));
  EXPECT_THAT(reading(square + "3 0 1 2\n3 0 2 3\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.off:8: more text after the last face")));
  EXPECT_THAT(reading("OFF\n1 0 0\n0 0 inf\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.off:3")));
  EXPECT_THAT(reading("OFF\n1 0 0\n0 0\n0\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.off:3")));
}

TEST(ReadOff, a_binary_file_is_told_to_be_one) {
  EXPECT_THAT([] { read_off(std::string("OFF BINARY\n\0\0\0\4", 15), "a.off"); },
              ThrowsMessage<InvalidInput>(HasSubstr("a.off:1: is binary, which is not supported")));
}

TEST(ReadOff, a_count_that_the_file_cannot_hold_is_refused_at_once) {
  for (const std::string counts : {"999999999999 1 0", "4 999999999999 0", "-1 1 0", "4 -4 0"}) {
    EXPECT_THAT([&] { read("OFF\n" + counts + "\n0 0 0\n"); },
                ThrowsMessage<InvalidInput>(HasSubstr("a count of ")))
        << counts;
  }
}

}  // namespace
}  // namespace tetfarm
