#include "mesh/healing/write_acts_vtp.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "mesh/inspect/vtp_triangles.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(WriteActsVtp, has_each_triangle_with_its_act) {
  const TrianglePoints one = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const TrianglePoints two = {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{0, 1, 0.1}};
  const TempFolder folder;
  const std::string path = (folder.path() / "acts.vtp").string();
  write_acts_vtp(
      {{HealKind::joined, {}, {}}, {HealKind::hole, {}, {one, two}}, {HealKind::flat, {}, {one}}},
      path);
  const std::string text = read_file(path);
  EXPECT_THAT(text, ::testing::HasSubstr("<!-- kind 6: hole -->"));
  const NumberedTriangles read = triangles_from_vtp(text, path);
  EXPECT_EQ(read.arrays.at("kind"), (std::vector<double>{6, 6, 3}));
  EXPECT_EQ(read.arrays.at("act"), (std::vector<double>{1, 1, 2}));
  EXPECT_EQ(read.points.at(5), two[2]);
}

}  // namespace
}  // namespace tetfarm
