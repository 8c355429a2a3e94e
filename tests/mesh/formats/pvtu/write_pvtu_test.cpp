#include "mesh/formats/pvtu/write_pvtu.h"

#include <gmock/gmock.h>

#include "tests/mesh/formats/marked_grid.h"
#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

/// An array of a piece, by its name, at the place that its description tells.
FileNumbers array(const std::string& bytes, const std::string& name) {
  FileNumbers numbers(bytes, false);
  FileNumbers text(bytes, true);
  text.skip_past("Name=\"" + name + "\"");
  text.skip_past("offset=\"");
  const std::string offset = bytes.substr(static_cast<std::size_t>(text.place()), 20);
  numbers.skip_past("<AppendedData encoding=\"raw\">\n_");
  numbers.go_to(numbers.place() + std::stoll(offset));
  return numbers;
}

TEST(WritePvtu, pieces_together_are_the_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const std::string pieces = read_file(export_as(grid, folder, "", "a.pvtu"));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string piece = "a/a_" + std::to_string(i) + ".vtu";
    EXPECT_THAT(pieces, testing::HasSubstr("<Piece Source=\"" + piece + "\"/>"));
    const std::string bytes = read_file(folder.path() / piece);
    const NumberedPart& part = grid.parts[i];
    FileNumbers points = array(bytes, "Points");
    EXPECT_EQ(points.large(), std::ssize(part.nodes) * 24);
    for (const Vec3& p : part.nodes) ASSERT_EQ(points.point(), p);
    FileNumbers numbers = array(bytes, "GlobalNodeId");
    EXPECT_EQ(numbers.large(), std::ssize(part.nodes) * 8);
    for (const std::int64_t number : part.local2global) ASSERT_EQ(numbers.large(), number);
    FileNumbers nodes = array(bytes, "connectivity");
    EXPECT_EQ(nodes.large(), std::ssize(part.tets) * 32 + std::ssize(part.faces) * 24);
    for (const Tet& tet : part.tets) {
      for (const std::int32_t v : tet) ASSERT_EQ(nodes.large(), v);
    }
    FileNumbers patches = array(bytes, "patch");
    patches.large();
    for (std::size_t t = 0; t < part.tets.size(); ++t) ASSERT_EQ(patches.small(), -1);
    for (const std::int32_t patch : part.patch_of_face) ASSERT_EQ(patches.small(), patch);
  }
}

TEST(WritePvtu, marks_of_cells_are_an_array_of_their_own_which_boundary_faces_have_0_in) {
  const TempFolder folder;
  const MarkedGrid grid;
  const std::string pieces = read_file(export_as(grid, folder, "", "a.pvtu"));
  EXPECT_THAT(pieces, testing::HasSubstr(
                          R"(<PDataArray type="Int32" Name="layer" NumberOfComponents="1"/>)"));
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const NumberedPart& part = grid.parts[i];
    FileNumbers marks =
        array(read_file(folder.path() / ("a/a_" + std::to_string(i) + ".vtu")), "layer");
    EXPECT_EQ(marks.large(), (cells_of(part) + boundary_faces_of(part)) * 4);
    for (std::int64_t c = 0; c < cells_of(part); ++c) ASSERT_EQ(marks.small(), c + 1);
    for (std::int64_t f = 0; f < boundary_faces_of(part); ++f) ASSERT_EQ(marks.small(), 0);
  }
}

TEST(WritePvtu, feet_of_nodes_are_two_arrays_which_meshes_without_them_have_not) {
  const TempFolder folder;
  const MarkedGrid grid;
  const std::string pieces = read_file(export_as(grid, folder, "", "a.pvtu"));
  EXPECT_THAT(pieces, testing::HasSubstr(
                          R"(<PDataArray type="Int64" Name="foot" NumberOfComponents="1"/>)"));
  EXPECT_THAT(pieces, testing::HasSubstr(
                          R"(<PDataArray type="Int32" Name="depth" NumberOfComponents="1"/>)"));
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const NodeFeet& feet = grid.parts[i].feet;
    const std::string bytes = read_file(folder.path() / ("a/a_" + std::to_string(i) + ".vtu"));
    FileNumbers foot = array(bytes, "foot");
    FileNumbers depth = array(bytes, "depth");
    EXPECT_EQ(foot.large(), std::ssize(feet.foot) * 8);
    EXPECT_EQ(depth.large(), std::ssize(feet.depth) * 4);
    for (std::size_t v = 0; v < feet.foot.size(); ++v) {
      ASSERT_EQ(foot.large(), feet.foot[v]);
      ASSERT_EQ(depth.small(), feet.depth[v]);
    }
  }
  const std::string without = read_file(export_as(HybridGrid(2, 1), folder, "", "b.pvtu"));
  EXPECT_THAT(without, testing::Not(testing::HasSubstr("foot")));
}

}  // namespace
}  // namespace tetfarm
