#include "mesh/formats/tetgen/read_tetgen.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* nodes = "# a tet\n4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";

TEST(ReadTetgen, poly_has_facets_with_marks) {
  const SurfaceMesh mesh = read_tetgen(std::string(nodes) +
                                           "4 1\n1 0 8\n3 1 3 2\n1 0 9\n3 1 2 4\n1\n3 2 3 4\n"
                                           "1 0 8 # last\n3 1 4 3\n0\n0\n",
                                       "a.poly");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_THAT(mesh.patch_names, ElementsAre("mark 8", "mark 9", "mark 0"));
  EXPECT_THAT(mesh.patch_of_triangle, ElementsAre(0, 1, 2, 0));
  EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), 1.0 / 6, 1e-15);
}

TEST(ReadTetgen, smesh_has_a_polygon_on_each_line_and_may_count_from_0) {
  const SurfaceMesh mesh = read_tetgen(
      "4 3\n0 0 0 0\n1 1 0 0\n2 1 1 0\n3 0 1 0\n2 1\n4 0 1 2 3 5\n3 2 1 0 6\n0\n", "a.smesh");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{2, 1, 0}));
  EXPECT_THAT(mesh.patch_names, ElementsAre("mark 5", "mark 6"));
}

TEST(ReadTetgen, names_the_line_of_what_it_does_not_read) {
  const auto reading = [](const std::string& text) { return [=] { read_tetgen(text, "a.poly"); }; };
  EXPECT_THAT(reading("0 3 0 0\n1 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.poly:1: the nodes are in a separate file")));
  EXPECT_THAT(
      reading(std::string(nodes) + "1 0\n1 1\n3 1 2 3\n1 0 0 0\n"),
      ThrowsMessage<InvalidInput>(HasSubstr("a.poly:8: a facet of 1 polygons and 1 holes")));
  EXPECT_THAT(reading(std::string(nodes) + "1 0\n1\n3 1 2 5\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.poly:9: vertex 5 of 4")));
  EXPECT_THAT(reading("2 3\n1 0 0 0\n3 0 0 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("not numbered consecutively")));
}

}  // namespace
}  // namespace tetfarm
