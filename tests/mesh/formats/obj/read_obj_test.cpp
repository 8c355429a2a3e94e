#include "mesh/formats/obj/read_obj.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/formats/surface_texts.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

SurfaceMesh read(const std::string& text) { return read_obj(text, "a.obj"); }

TEST(ReadObj, keeps_the_numbers_of_vertices_and_triangles) {
  const SurfaceMesh cube = shapes::unit_cube();
  const SurfaceMesh back = read(texts::obj(cube));
  EXPECT_EQ(back.vertices, cube.vertices);
  EXPECT_EQ(back.triangles, cube.triangles);
}

TEST(ReadObj, reads_negative_numbers_and_numbers_with_texture_and_normal) {
  EXPECT_THAT(
      read(square + "f -4 -3 -2\nf 1/1 3/2 4/3\nf 1//7 2//8 3//9\nf 1/1/1 -2/-2/-2 4/4/4\n")
          .triangles,
      ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(ReadObj, cuts_polygons_into_fans) {
  EXPECT_THAT(read(square + "v -1 0.5 0\nf 1 2 3 4 5\n").triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
}

TEST(ReadObj, joins_lines_that_end_in_a_backslash_and_passes_over_comments) {
  EXPECT_THAT(
      read("# cube\nmtllib a.mtl\n" + square + "vn 0 0 1\nvt 0 0\ns off\nf 1 2 \\\n 3 # x\n")
          .triangles,
      ElementsAre(Triangle{0, 1, 2}));
}

TEST(ReadObj, passes_over_the_colour_of_a_vertex) {
  EXPECT_EQ(read("v 0 0 0 1 0.5 0.5\n" + square + "f 1 2 3\n").vertices.size(), 5U);
}

TEST(ReadObj, takes_the_names_of_which_the_file_has_most) {
  const std::string a = "f 1 2 3\n";
  const std::string groups = square + "o body\ng wing\nusemtl red\n" + a + "g tail\n" + a;
  EXPECT_THAT(read(groups).patch_names, ElementsAre("wing", "tail"));
  EXPECT_THAT(read(groups).patch_of_triangle, ElementsAre(0, 1));
  // Those that name most win also where the last face has no name of theirs.
  EXPECT_THAT(read(groups + "g\n" + a).patch_of_triangle, ElementsAre(0, 1, 2));
  const std::string materials =
      square + "o body\nusemtl red\n" + a + "usemtl blue\n" + a + "usemtl red\n" + a;
  EXPECT_THAT(read(materials).patch_names, ElementsAre("red", "blue"));
  EXPECT_THAT(read(materials).patch_of_triangle, ElementsAre(0, 1, 0));
  EXPECT_THAT(read(square + "o pipe\n" + a).patch_names, ElementsAre("pipe"));
  EXPECT_THAT(read(square + a).patch_names, ElementsAre("surface"));
}

TEST(ReadObj, names_the_line_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& text) { return [=] { read(square + text); }; };
  EXPECT_THAT(reading("f 1 2 9999999999\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.obj:5: vertex 9999999999 of the 4 so far")));
  EXPECT_THAT(reading("f 1 2 99999999999999999999\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.obj:5: expected a vertex number")));
  EXPECT_THAT(reading("f 1 2 0\n"), ThrowsMessage<InvalidInput>(HasSubstr("vertex 0")));
  EXPECT_THAT(reading("f 1 2 -5\n"), ThrowsMessage<InvalidInput>(HasSubstr("vertex -5")));
  EXPECT_THAT(reading("f 1 2 5\nv 0 0 1\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.obj:5")));
  EXPECT_THAT(reading("f 1 2\n"), ThrowsMessage<InvalidInput>(HasSubstr("a face with 2 vertices")));
  EXPECT_THAT(reading("f 1 2 x\n"), ThrowsMessage<InvalidInput>(HasSubstr("found \"x\"")));
  EXPECT_THAT(reading("v 1 2\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.obj:5: expected a coor")));
  EXPECT_THAT(reading("v 1 2 nan\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.obj:5")));
  EXPECT_THAT(reading("\n\nhello world\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.obj:7: unknown OBJ statement \"hello\"")));
}

}  // namespace
}  // namespace tetfarm
