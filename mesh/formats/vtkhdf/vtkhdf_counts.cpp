#include "mesh/formats/vtkhdf/vtkhdf_counts.h"

#include "mesh/assemble/part_cells.h"

namespace tetfarm {

VtkhdfCounts vtkhdf_counts(const NumberedPart& part) {
  return {std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces),
          counts_of(part.blocks)};
}

std::int64_t cells_of(const VtkhdfCounts& part) {
  std::int64_t cells = part.tets + part.faces;
  for_each_block(part.others, [&](ElementType, std::int64_t count) { cells += count; });
  return cells;
}

std::int64_t ids_of(const VtkhdfCounts& part) {
  std::int64_t ids = 4 * part.tets + 3 * part.faces;
  for_each_block(part.others, [&](ElementType type, std::int64_t count) {
    ids += static_cast<std::int64_t>(nodes_of(type)) * count;
  });
  return ids;
}

std::vector<VtkhdfBefore> before_each(std::span<const VtkhdfCounts> parts) {
  std::vector<VtkhdfBefore> all(1);
  for (const VtkhdfCounts& part : parts) {
    const VtkhdfBefore& last = all.back();
    all.push_back(
        {last.points + part.points, last.cells + cells_of(part), last.ids + ids_of(part)});
  }
  return all;
}

}  // namespace tetfarm
