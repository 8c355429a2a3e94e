#include "mesh/formats/su2/write_su2.h"

#include <sstream>

#include "tests/mesh/formats/read_back.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

TEST(WriteSu2, has_the_same_mesh_and_plain_names) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const std::string bytes = read_file(export_as(grid, folder, "su2", "a.su2"));
  FileNumbers file(bytes, true);
  ReadMesh mesh(0);
  file.skip_past("NPOIN=");
  const std::int64_t nodes = file.small();
  for (std::int64_t i = 0; i < nodes; ++i) {
    mesh.node(file.point());
    EXPECT_EQ(file.large(), i);
  }
  file.go_to(0);
  file.skip_past("NELEM=");
  for (std::int64_t i = file.small(); i > 0; --i) {
    EXPECT_EQ(file.small(), 10);
    mesh.tet(file.larges<4>());
    file.large();
  }
  for (std::int64_t patch = 0; patch < 2; ++patch) {
    file.skip_past(patch == 0 ? "MARKER_TAG= low_x\nMARKER_ELEMS="
                              : "MARKER_TAG= elsewhere\nMARKER_ELEMS=");
    for (std::int64_t i = file.small(); i > 0; --i) {
      EXPECT_EQ(file.small(), 5);
      mesh.face(file.larges<3>(), patch);
    }
  }
  EXPECT_EQ(content_of(mesh), content_of(grid));
}

TEST(WriteSu2, counts_the_elements_of_a_marker_of_whatever_type_they_are) {
  const TempFolder folder;
  const HybridGrid grid(3, 2);
  const std::string text = read_file(export_as(grid, folder, "su2", "a.su2"));
  std::istringstream lines(text);
  std::int64_t left = 0;  // of the marker's elements
  int markers = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("MARKER_")) {
      if (markers > 0) --left;
      continue;
    }
    EXPECT_EQ(left, 0) << "before " << line;
    const std::string elements = "MARKER_ELEMS=";
    if (!line.starts_with(elements)) continue;
    left = std::stoll(line.substr(elements.size()));
    EXPECT_GT(left, 0);
    ++markers;
  }
  EXPECT_EQ(left, 0);
  EXPECT_EQ(markers, 2);
}

}  // namespace
}  // namespace tetfarm
