#include "mesh/partition/dual_graph.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

WeightedGraph dual_graph(const CellFaces& faces, std::size_t cells,
                         const std::vector<std::int32_t>& beyond) {
  for (const std::int32_t cell : beyond) TF_CHECK(cell >= 0 && at(cell) < cells);
  WeightedGraph graph;
  graph.weight.assign(cells + beyond.size(), 1);
  make_rows(graph, [&](const auto& visit) {
    for (const InnerFace& face : faces.inner) visit(at(face.owner), at(face.neighbour), 1);
    for (std::size_t i = 0; i < beyond.size(); ++i) visit(at(beyond[i]), cells + i, 1);
  });
  return graph;
}

WeightedGraph dual_graph(const CellFaces& faces, const CellColumns& columns,
                         const std::vector<std::int32_t>& beyond) {
  const std::size_t count = columns.sizes.size();
  if (columns.are_single_cells()) return dual_graph(faces, count, beyond);
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (const InnerFace& face : faces.inner) {
    const auto [a, b] = std::minmax(columns.column_of_cell[at(face.owner)],
                                    columns.column_of_cell[at(face.neighbour)]);
    if (a != b) pairs.emplace_back(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  for (const std::int32_t column : beyond) TF_CHECK(column >= 0 && at(column) < count);
  WeightedGraph graph;
  graph.weight = columns.sizes;
  graph.weight.resize(count + beyond.size(), 1);
  make_rows(graph, [&](const auto& visit) {
    for (std::size_t i = 0; i < pairs.size();) {
      std::size_t end = i + 1;
      while (end < pairs.size() && pairs[end] == pairs[i]) ++end;
      visit(at(pairs[i].first), at(pairs[i].second), static_cast<std::int32_t>(end - i));
      i = end;
    }
    for (std::size_t i = 0; i < beyond.size(); ++i) visit(at(beyond[i]), count + i, 1);
  });
  return graph;
}

}  // namespace tetfarm
