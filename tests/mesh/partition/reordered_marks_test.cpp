#include "mesh/partition/reordered_marks.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(ReorderedMarks, follow_the_order_and_stay_away_where_there_were_none) {
  CellMarks marks;
  marks[CellMark::layer] = {5, 6, 7};
  marks[CellMark::pml_axes] = {1, 2, 4};
  const CellMarks result = reordered_marks(marks, {2, 0, 1});
  EXPECT_EQ(result[CellMark::layer], (std::vector<std::int32_t>{7, 5, 6}));
  EXPECT_EQ(result[CellMark::pml_axes], (std::vector<std::int32_t>{4, 1, 2}));
  EXPECT_TRUE(result[CellMark::pml_depth].empty());
}

}  // namespace
}  // namespace tetfarm
