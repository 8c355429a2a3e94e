#include "mesh/partition/cell_columns.h"

#include <numeric>

#include "base/array_index.h"
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

/// The first of those that are joined, with shorter ways there for the next time.
std::int32_t first_of(std::vector<std::int32_t>& before, std::int32_t cell) {
  while (before[at(cell)] != cell) {
    before[at(cell)] = before[at(before[at(cell)])];
    cell = before[at(cell)];
  }
  return cell;
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
  std::vector<std::int32_t> before(is_prism.size());
  std::iota(before.begin(), before.end(), 0);
  for (const InnerFace& face : faces.inner) {
    if (face.nodes.size() != 3 || !is_prism[at(face.owner)] || !is_prism[at(face.neighbour)]) {
      continue;
    }
    const std::int32_t a = first_of(before, face.owner);
    const std::int32_t b = first_of(before, face.neighbour);
    before[at(std::max(a, b))] = std::min(a, b);
  }
  CellColumns columns;
  columns.column_of_cell.resize(before.size());
  for (std::size_t cell = 0; cell < before.size(); ++cell) {
    const auto first = at(first_of(before, static_cast<std::int32_t>(cell)));
    if (first == cell) {
      columns.column_of_cell[cell] = static_cast<std::int32_t>(columns.sizes.size());
      columns.sizes.push_back(0);
    } else {
      columns.column_of_cell[cell] = columns.column_of_cell[first];
    }
    ++columns.sizes[at(columns.column_of_cell[cell])];
  }
  return columns;
}

}  // namespace tetfarm
