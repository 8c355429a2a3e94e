#include "mesh/layers/side_triangles.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LayerLine line_of(std::int32_t foot, int stop, bool in_tets) {
  LayerLine line;
  line.foot = foot;
  line.stop = line.vertices = stop;
  line.first_vertex = 10 * foot;
  line.in_tets = in_tets;
  return line;
}

constexpr SideNode from(int level) { return {0, level}; }
constexpr SideNode to(int level) { return {1, level}; }

TEST(SideTriangles, are_one_for_each_layer_that_only_one_line_has) {
  const LayerLine two = line_of(1, 2, false);
  const LayerLine four = line_of(2, 4, false);
  EXPECT_EQ(quads_of({two, four}), 2);
  EXPECT_EQ(quads_of({two, four, 1}), 1);
  EXPECT_THAT(triangles_of({two, two}), IsEmpty());
  EXPECT_THAT(triangles_of({two, four}), ElementsAre(SideTriangle{from(2), to(2), to(3)},
                                                     SideTriangle{from(2), to(3), to(4)}));
  EXPECT_THAT(triangles_of({four, two}), ElementsAre(SideTriangle{from(2), to(2), from(3)},
                                                     SideTriangle{from(3), to(2), from(4)}));
}

TEST(SideTriangles, of_lines_in_tets_have_the_diagonal_from_the_first_line_upwards) {
  const LayerLine first = line_of(1, 2, true);
  const LayerLine second = line_of(2, 1, true);
  EXPECT_EQ(quads_of({first, second}), 0);
  EXPECT_THAT(triangles_of({first, second}), ElementsAre(SideTriangle{from(0), to(0), to(1)},
                                                         SideTriangle{from(0), to(1), from(1)},
                                                         SideTriangle{from(1), to(1), from(2)}));
  EXPECT_THAT(triangles_of({second, first}), ElementsAre(SideTriangle{from(0), to(0), from(1)},
                                                         SideTriangle{to(0), to(1), from(1)},
                                                         SideTriangle{from(1), to(1), to(2)}));
  EXPECT_THAT(triangles_of({first, first, 1}), ElementsAre(SideTriangle{from(1), to(1), from(2)},
                                                           SideTriangle{to(1), to(2), from(2)}));
}

TEST(SideTriangles, of_an_early_line_have_the_diagonal_to_it) {
  LayerLine early = line_of(1, 2, false);
  early.early = true;
  LayerLine other = line_of(2, 1, false);
  EXPECT_TRUE(is_divided({early, other}));
  EXPECT_EQ(quads_of({early, other}), 0);
  for (const bool in_tets : {false, true}) {
    early.in_tets = other.in_tets = in_tets;
    EXPECT_THAT(triangles_of({early, other}), ElementsAre(SideTriangle{from(0), to(0), from(1)},
                                                          SideTriangle{to(0), to(1), from(1)},
                                                          SideTriangle{from(1), to(1), from(2)}));
    EXPECT_THAT(triangles_of({other, early}), ElementsAre(SideTriangle{from(0), to(0), to(1)},
                                                          SideTriangle{from(0), to(1), from(1)},
                                                          SideTriangle{from(1), to(1), to(2)}));
  }
  other.early = true;
  other.in_tets = false;
  EXPECT_FALSE(is_divided({early, other}));
}

TEST(SideTriangles, are_quads_where_only_one_line_is_in_tets) {
  const LayerLine in_tets = line_of(1, 2, true);
  const LayerLine other = line_of(2, 2, false);
  EXPECT_EQ(quads_of({in_tets, other}), 2);
  EXPECT_THAT(triangles_of({in_tets, other}), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
