#include "mesh/formats/pvtu/write_pvtu.h"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace tetfarm
