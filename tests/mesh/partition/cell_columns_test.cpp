#include "mesh/partition/cell_columns.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/partition/dual_graph.h"
#include "mesh/partition/partitioned_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"
#include "tests/support/prism_stacks.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

/// The columns of each part, as the squares' halves that they stand on, with the parts that have
/// some of them.
std::map<std::pair<double, double>, std::set<std::size_t>> parts_by_column(const MeshSource& mesh) {
  std::map<std::pair<double, double>, std::set<std::size_t>> parts;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    const ElementBlock& prisms = part.blocks[ElementType::prism];
    for (std::size_t p = 0; p < prisms.size(); ++p) {
      double x = 0;
      double y = 0;
      for (const std::int32_t v : prisms.element(ElementType::prism, p)) {
        x += part.nodes[static_cast<std::size_t>(v)].x;
        y += part.nodes[static_cast<std::size_t>(v)].y;
      }
      parts[{x, y}].insert(i);
    }
  }
  return parts;
}

std::size_t divided_columns(std::int32_t parts, bool keeps_columns) {
  const test::PrismStacks stacks(3, 40);
  const TempFolder folder;
  PartitionOptions options;
  options.parts = parts;
  options.keeps_columns = keeps_columns;
  const PartitionedMesh mesh(stacks, options, folder.path());
  const auto found = parts_by_column(mesh);
  EXPECT_EQ(found.size(), 18);
  return static_cast<std::size_t>(std::count_if(
      found.begin(), found.end(), [](const auto& column) { return column.second.size() > 1; }));
}

TEST(CellColumns, are_the_prisms_that_stand_on_one_another) {
  const NumberedPart part = test::PrismStacks(3, 5).part(0);
  const CellColumns columns = columns_of_prisms(part, cell_faces(part));
  EXPECT_EQ(columns.sizes.size(), 18);
  EXPECT_THAT(columns.sizes, Each(5));
  EXPECT_FALSE(columns.are_single_cells());
  EXPECT_TRUE(single_cells(7).are_single_cells());
}

TEST(CellColumns, have_edges_as_heavy_as_the_faces_between_them) {
  const NumberedPart part = test::PrismStacks(1, 5).part(0);
  const CellFaces faces = cell_faces(part);
  const WeightedGraph graph = dual_graph(faces, columns_of_prisms(part, faces), {1});
  ASSERT_EQ(graph.size(), 3) << "two columns, and one cell beyond";
  EXPECT_THAT(graph.weight, testing::ElementsAre(5, 5, 1));
  EXPECT_THAT(graph.neighbour, testing::ElementsAre(1, 0, 2, 1));
  EXPECT_THAT(graph.edge_weight, testing::ElementsAre(5, 5, 1, 1));
}

TEST(CellColumns, are_whole_in_any_number_of_parts) {
  for (const std::int32_t parts : {2, 3, 5, 7, 16}) EXPECT_EQ(divided_columns(parts, true), 0);
}

TEST(CellColumns, are_divided_where_they_may_be) { EXPECT_GT(divided_columns(7, false), 0); }

TEST(CellColumns, that_are_fewer_than_parts_are_refused_with_the_option_that_divides_them) {
  EXPECT_THAT(error_text_of<UsageError>([] { divided_columns(19, true); }),
              HasSubstr("--keep-columns no"));
}

}  // namespace
}  // namespace tetfarm
