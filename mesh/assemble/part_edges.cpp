#include "mesh/assemble/part_edges.h"

#include <algorithm>

#include "mesh/assemble/part_cells.h"

namespace tetfarm {

std::vector<std::array<std::int32_t, 2>> edges_of(const NumberedPart& part) {
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(element(ElementType::tet).edges.size() * part.tets.size());
  for_each_cell(part, [&](std::int32_t, ElementType type, std::span<const std::int32_t> nodes) {
    for (const auto& [i, j] : element(type).edges) {
      edges.push_back({std::min(nodes[i], nodes[j]), std::max(nodes[i], nodes[j])});
    }
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace tetfarm
