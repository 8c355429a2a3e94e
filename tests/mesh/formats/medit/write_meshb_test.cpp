#include "mesh/formats/medit/write_meshb.h"

#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

/// The keyword and the place that follows it; the count after both is read.
std::int64_t expect_list(FileNumbers& file, std::int64_t keyword, std::int64_t bytes_each) {
  EXPECT_EQ(file.small(), keyword);
  const std::int64_t next = file.large();
  const std::int64_t count = file.large();
  EXPECT_EQ(next, file.place() + count * bytes_each);
  return count;
}

TEST(WriteMeshb, lists_have_the_same_mesh_and_say_where_the_next_begins) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  FileNumbers file(read_file(export_as(grid, folder, "", "a.meshb")), false);
  EXPECT_EQ(file.small(), 1);
  EXPECT_EQ(file.small(), 4);
  EXPECT_EQ(file.small(), 3);
  const std::int64_t next = file.large();
  EXPECT_EQ(next, file.place() + 4);
  EXPECT_EQ(file.small(), 3);
  ReadMesh mesh(1);
  for (std::int64_t i = expect_list(file, 4, 32); i > 0; --i) {
    mesh.node(file.point());
    EXPECT_EQ(file.large(), 0);
  }
  for (std::int64_t i = expect_list(file, 6, 32); i > 0; --i) {
    const auto corners = file.larges<3>();
    mesh.face(corners, file.large() - 1);
  }
  for (std::int64_t i = expect_list(file, 8, 40); i > 0; --i) {
    mesh.tet(file.larges<4>());
    EXPECT_EQ(file.large(), 1);
  }
  EXPECT_EQ(file.small(), 54);
  EXPECT_EQ(content_of(mesh), content_of(grid));
}

}  // namespace
}  // namespace tetfarm
