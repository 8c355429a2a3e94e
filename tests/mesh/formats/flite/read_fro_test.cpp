#include "mesh/formats/flite/read_fro.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* nodes = "2 4 0 0 0 2\n1 0.0D+00 0 0\n2 1.5D-01 0 0\n3 0 1 0\n4 0 0 1\n";

TEST(ReadFro, surfaces_are_patches_and_exponents_may_be_fortran) {
  const SurfaceMesh mesh = read_fro(std::string(nodes) + "1 1 3 2 1\n2 1 2 4 2\n", "a.fro");
  EXPECT_EQ(mesh.vertices[1].x, 0.15);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 2, 1}, Triangle{0, 1, 3}));
  EXPECT_THAT(mesh.patch_names, ElementsAre("surface 1", "surface 2"));
}

TEST(ReadFro, names_the_line_of_what_it_does_not_understand) {
  const auto reading = [](const std::string& text) { return [=] { read_fro(text, "a.fro"); }; };
  EXPECT_THAT(reading(std::string(nodes) + "1 1 3 5 1\n2 1 2 4 2\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.fro:6: vertex 5 of 4")));
  EXPECT_THAT(reading(std::string(nodes) + "1 1 3 2 1\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.fro:7: expected a triangle's number")));
  EXPECT_THAT(reading("1 3 0\n1 0 0 0\n3 1 0 0\n2 0 1 0\n1 1 2 3 1\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.fro:3: expected number 2, found 3")));
  EXPECT_THAT(reading(std::string(nodes) + "1 1 3 2 1\n3 1 2 4 2\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.fro:7: expected number 2, found 3")));
}

}  // namespace
}  // namespace tetfarm
