#include "mesh/quality/face_check.h"

#include <gtest/gtest.h>

#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

/// The grid without the first boundary triangles of its first part.
GridSource grid_without(std::size_t triangles) {
  GridSource source(cut_grid(4));
  NumberedPart& part = source.parts[0];
  part.faces.erase(part.faces.begin(), part.faces.begin() + static_cast<long>(triangles));
  part.patch_of_face.erase(part.patch_of_face.begin(),
                           part.patch_of_face.begin() + static_cast<long>(triangles));
  return source;
}

std::size_t bad_faces(const GridSource& source, std::size_t most) {
  const TempFolder folder;
  FaceCheck check(folder.path(), std::size_t{1} << 20U);
  for (const NumberedPart& part : source.parts) check.add(part);
  return check.finish(most).size();
}

TEST(FaceCheck, names_as_many_faces_as_it_is_asked_for_and_no_more) {
  EXPECT_EQ(bad_faces(grid_without(0), 5), 0U);
  EXPECT_EQ(bad_faces(grid_without(3), 5), 3U);
  EXPECT_EQ(bad_faces(grid_without(5), 5), 5U);
  EXPECT_EQ(bad_faces(grid_without(8), 5), 5U);
}

}  // namespace
}  // namespace tetfarm
