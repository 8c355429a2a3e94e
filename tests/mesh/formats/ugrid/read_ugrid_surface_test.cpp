#include "mesh/formats/ugrid/read_ugrid_surface.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/mesh/formats/turned_bytes.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

template <class Integer, class Real>
std::string binary(const SurfaceMesh& mesh, bool is_big) {
  std::string bytes;
  const auto integer = [&](std::size_t value) {
    texts::append_number(bytes, static_cast<Integer>(value), is_big);
  };
  for (const std::size_t count :
       {mesh.vertices.size(), mesh.triangles.size(), 0UL, 1UL, 0UL, 0UL, 0UL}) {
    integer(count);
  }
  for (const Vec3& p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z}) {
      texts::append_number(bytes, static_cast<Real>(x), is_big);
    }
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) integer(static_cast<std::size_t>(v) + 1);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) integer(i < 2 ? 7 : 3);
  for (const std::size_t v : {1UL, 2UL, 3UL, 4UL}) integer(v);  // a tet, passed over
  return bytes;
}

void expect_cube(const std::string& bytes, const std::string& name) {
  const SurfaceMesh cube = shapes::unit_cube();
  const SurfaceMesh back = read_ugrid_surface(bytes, name);
  EXPECT_EQ(back.vertices, cube.vertices) << name;
  EXPECT_EQ(back.triangles, cube.triangles) << name;
  EXPECT_THAT(back.patch_names, ElementsAre("patch 7", "patch 3")) << name;
  EXPECT_EQ(back.patch_of_triangle[1], 0) << name;
  EXPECT_EQ(back.patch_of_triangle[2], 1) << name;
}

TEST(ReadUgridSurface, every_form_gives_the_same_surface) {
  const SurfaceMesh cube = shapes::unit_cube();
  expect_cube(binary<std::int32_t, double>(cube, false), "a.lb8.ugrid");
  expect_cube(binary<std::int32_t, double>(cube, true), "a.b8.ugrid");
  expect_cube(binary<std::int64_t, double>(cube, false), "a.lb8l.ugrid");
  expect_cube(binary<std::int64_t, double>(cube, true), "a.B8L.UGRID");
  expect_cube(binary<std::int32_t, float>(cube, false), "a.lb4.ugrid");
  expect_cube(binary<std::int32_t, float>(cube, true), "a.b4.ugrid.gz");
}

TEST(ReadUgridSurface, text_drops_nodes_inside) {
  const SurfaceMesh mesh =
      read_ugrid_surface("5 1 0 0 0 0 0\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n8 8 8\n1 3 4\n2\n", "a.ugrid");
  EXPECT_EQ(mesh.vertices.size(), 3u);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ReadUgridSurface, names_the_byte_of_what_is_wrong) {
  const auto reading = [](const std::string& bytes) {
    return [=] { read_ugrid_surface(bytes, "a.lb8.ugrid"); };
  };
  std::string bytes = binary<std::int32_t, double>(shapes::unit_cube(), false);
  EXPECT_THAT(reading(bytes.substr(0, 100)),
              ThrowsMessage<InvalidInput>(HasSubstr("a.lb8.ugrid: byte ")));
  bytes[28 + 8 * 24] = 99;
  EXPECT_THAT(reading(bytes),
              ThrowsMessage<InvalidInput>(HasSubstr("byte 220: vertex 99 of 8 (counted from 1)")));
}

TEST(ReadUgridSurface, reads_quadrangles_of_binary_files_behind_the_triangles) {
  for (const bool is_big : {false, true}) {
    std::string bytes;
    for (const std::int32_t number : {4, 1, 1, 0, 0, 0, 0}) {
      texts::append_number(bytes, number, is_big);
    }
    for (const double x : {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0}) {
      texts::append_number(bytes, x, is_big);
    }
    for (const std::int32_t number : {1, 2, 3, 4, 3, 2, 1, 7, 9}) {
      texts::append_number(bytes, number, is_big);
    }
    const SurfaceMesh mesh = read_ugrid_surface(bytes, is_big ? "a.b8.ugrid" : "a.lb8.ugrid");
    EXPECT_THAT(mesh.triangles,
                ElementsAre(Triangle{0, 1, 2}, Triangle{3, 2, 1}, Triangle{3, 1, 0}));
    EXPECT_THAT(mesh.patch_names, ElementsAre("patch 7", "patch 9"));
    EXPECT_THAT(mesh.patch_of_triangle, ElementsAre(0, 1, 1));
  }
}

}  // namespace
}  // namespace tetfarm
