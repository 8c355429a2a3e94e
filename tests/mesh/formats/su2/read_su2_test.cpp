#include "mesh/formats/su2/read_su2.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

SurfaceMesh read(const std::string& text) { return read_su2(text, "a.su2"); }

constexpr const char* tet =
    "% a tet\nNDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 5\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\n"
    "7 7 7 4\nNMARK= 2\nMARKER_TAG= low z\n";

TEST(ReadSu2, markers_are_patches_and_points_inside_are_dropped) {
  const SurfaceMesh mesh = read(
      "NDIME=3\nNELEM = 1\n10 0 1 2 3 0\nNPOIN= 5 5\n0 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 3\n"
      "7 7 7 4\nNMARK= 2\nMARKER_TAG= floor\nMARKER_ELEMS= 1\n5 0 2 1\n"
      "MARKER_TAG= rest\nMARKER_ELEMS= 3\n5 0 1 3\n5 1 2 3 9\n5 0 3 2\n");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_THAT(mesh.patch_names, ElementsAre("floor", "rest"));
  EXPECT_THAT(mesh.patch_of_triangle, ElementsAre(0, 1, 1, 1));
  EXPECT_NEAR(enclosed_volume(mesh.vertices, mesh.triangles), 1.0 / 6, 1e-15);
}

TEST(ReadSu2, a_surface_alone_is_its_elements) {
  const SurfaceMesh mesh =
      read("NDIME= 3\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0 0\n1 0 0\n0 1 0\nNMARK= 0\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ReadSu2, names_the_line_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& text) { return [=] { read(text); }; };
  EXPECT_THAT(reading("NDIME= 2\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.su2:1: ")));
  EXPECT_THAT(
      reading(std::string(tet) + "MARKER_ELEMS= 1\n10 0 1 2 3\n"),
      ThrowsMessage<InvalidInput>(HasSubstr("a.su2:14: an element of a marker has the type 10")));
  EXPECT_THAT(reading(std::string(tet) + "MARKER_ELEMS= 1\n5 0 1 5\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("vertex 5 of 5")));
  EXPECT_THAT(reading("NPOIN= 1000000\n0 0 0\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a count of 1000000")));
}

}  // namespace
}  // namespace tetfarm
