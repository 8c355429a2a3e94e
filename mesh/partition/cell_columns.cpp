#include "mesh/partition/cell_columns.h"

#include <numeric>

#include "base/array_index.h"
#include "base/disjoint_sets.h"
#include "mesh/assemble/part_cells.h"

namespace tetfarm {
namespace {

std::vector<bool> prisms_among(const NumberedPart& part) {
  std::vector<bool> is_prism(part.tets.size(), false);
  for_each_block_cell(part.blocks,
                      [&](ElementType type, std::span<const std::int32_t>, std::int32_t) {
                        is_prism.push_back(type == ElementType::prism);
                      });
  return is_prism;
}

}  // namespace

CellColumns single_cells(std::size_t cells) {
  CellColumns columns;
  columns.column_of_cell.resize(cells);
  std::iota(columns.column_of_cell.begin(), columns.column_of_cell.end(), 0);
  columns.sizes.assign(cells, 1);
  return columns;
}

CellColumns columns_of_prisms(const NumberedPart& part, const CellFaces& faces) {
  const std::vector<bool> is_prism = prisms_among(part);
  DisjointSets joined(is_prism.size());
  for (const InnerFace& face : faces.inner) {
    if (face.nodes.size() == 3 && is_prism[at(face.owner)] && is_prism[at(face.neighbour)]) {
      joined.join(at(face.owner), at(face.neighbour));
    }
  }
  CellColumns columns;
  columns.sizes.resize(at(joined.number(columns.column_of_cell)));
  for (const std::int32_t column : columns.column_of_cell) ++columns.sizes[at(column)];
  return columns;
}

}  // namespace tetfarm
