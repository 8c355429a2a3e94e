#include "mesh/partition/reordered_marks.h"

#include "base/check.h"

namespace tetfarm {

CellMarks reordered_marks(const CellMarks& marks, const std::vector<std::size_t>& order) {
  CellMarks result;
  for (const CellMark mark : all_cell_marks) {
    if (marks[mark].empty()) continue;
    TF_CHECK(order.size() == marks[mark].size());
    result[mark].reserve(order.size());
    for (const std::size_t cell : order) result[mark].push_back(marks[mark][cell]);
  }
  return result;
}

}  // namespace tetfarm
