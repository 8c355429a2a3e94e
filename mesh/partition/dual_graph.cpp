#include "mesh/partition/dual_graph.h"

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

}  // namespace tetfarm
