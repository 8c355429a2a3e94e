#include "mesh/formats/tetgen/write_tetgen.h"

#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

TEST(WriteTetgen, three_files_have_the_same_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const auto named = [&](const char* ending) {
    return FileNumbers(read_file(folder.path() / (std::string("a") + ending)), true);
  };
  export_as(grid, folder, "", "a.node");
  ReadMesh mesh(0);
  FileNumbers nodes = named(".node");
  const auto head = nodes.larges<4>();
  EXPECT_EQ(head, (std::array<std::int64_t, 4>{125, 3, 0, 0}));
  for (std::int64_t i = 0; i < head[0]; ++i) {
    EXPECT_EQ(nodes.large(), i);
    mesh.node(nodes.point());
  }
  FileNumbers tets = named(".ele");
  for (std::int64_t i = tets.larges<3>()[0]; i > 0; --i) {
    tets.large();
    mesh.tet(tets.larges<4>());
    EXPECT_EQ(tets.large(), 1);
  }
  FileNumbers faces = named(".face");
  for (std::int64_t i = faces.larges<2>()[0]; i > 0; --i) {
    faces.large();
    const auto corners = faces.larges<3>();
    mesh.face(corners, faces.large() - 1);
  }
  EXPECT_EQ(content_of(mesh), content_of(grid));
}

}  // namespace
}  // namespace tetfarm
