#include "mesh/formats/surfaces/write_surface.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/formats/off/read_off.h"
#include "mesh/formats/off/write_off.h"
#include "mesh/formats/stl/read_stl.h"
#include "mesh/formats/stl/write_stl.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tests/base/temp_folder.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

SurfaceMesh two_patches() {
  SurfaceMesh mesh = shapes::sphere({0.1, 0.2, 1.0 / 3}, 0.7, 1);
  mesh.patch_names = {"first half", "rest"};
  mesh.patch_of_triangle.assign(mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < mesh.triangles.size() / 2; ++t) mesh.patch_of_triangle[t] = 0;
  return mesh;
}

TEST(WriteSurface, off_is_read_back_bit_by_bit) {
  const SurfaceMesh mesh = shapes::sphere({0.1, 0.2, 1.0 / 3}, 0.7, 2);
  const SurfaceMesh back = read_off(write_off(mesh), "a.off");
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(WriteSurface, stl_keeps_coordinates_and_patches) {
  const SurfaceMesh mesh = two_patches();
  const SurfaceMesh back = read_stl(write_stl(mesh), "a.stl");
  EXPECT_EQ(back.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(back.patch_names, mesh.patch_names);
  EXPECT_EQ(back.patch_of_triangle, mesh.patch_of_triangle);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(back.vertices[static_cast<std::size_t>(back.triangles[t][i])],
                mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][i])]);
    }
  }
}

TEST(WriteSurface, stl_without_patches_has_one_solid) {
  EXPECT_EQ(read_stl(write_stl(shapes::unit_cube()), "a.stl").triangles.size(), 12U);
  EXPECT_THAT(write_stl(shapes::unit_cube()), testing::StartsWith("solid surface\n"));
}

TEST(WriteSurface, takes_endings_in_upper_case_as_reading_does) {
  const TempFolder folder;
  for (const char* name : {"A.STL", "a.Off"}) {
    const std::string path = (folder.path() / name).string();
    write_surface(shapes::unit_cube(), path);
    EXPECT_EQ(read_surface(path).triangles.size(), 12U) << name;
  }
}

TEST(WriteSurface, other_endings_are_usage_errors) {
  EXPECT_THROW(write_surface(shapes::unit_cube(), "/nowhere/a.obj"), UsageError);
  EXPECT_THROW(write_surface(shapes::unit_cube(), "/nowhere/off"), UsageError);
}

}  // namespace
}  // namespace tetfarm
