#include "mesh/layers/placed_column.h"

#include <gtest/gtest.h>

#include "mesh/core/elements.h"
#include "tests/mesh/layers/layered_bodies.h"

namespace tetfarm {
namespace {

TEST(PlacedColumn, has_the_points_of_its_lines_and_cells_between_them) {
  const test::LayeredBody body(test::cube_in_box(3), test::request_of({test::body_patch}, 0.02, 4));
  const auto numbers = lines_of(body.plan, body.surface, body.plan.wall.front());
  std::array<const LayerLine*, 3> lines{};
  for (std::size_t k = 0; k < 3; ++k) lines[k] = &body.plan.lines[at(numbers[k])];
  const PlacedColumn placed = placed_column(lines);
  EXPECT_EQ(placed.layers, 4);
  int prisms = 0;
  for (int layer = 1; layer <= placed.layers; ++layer) {
    for (const LayerCell& cell : cells_of_layer(placed.column, layer)) {
      const std::array<Vec3, 6> p = corners_of(placed, cell);
      EXPECT_EQ(cell.type, ElementType::prism);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(p[k], point_of(*lines[at(cell.nodes[k].corner)], layer - 1));
        EXPECT_EQ(p[k + 3], point_of(*lines[at(cell.nodes[k + 3].corner)], layer));
      }
      EXPECT_GT(element_volume(cell.type, p), 0);
      ++prisms;
    }
  }
  EXPECT_EQ(prisms, 4);
}

}  // namespace
}  // namespace tetfarm
