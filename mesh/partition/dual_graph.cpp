#include "mesh/partition/dual_graph.h"

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

WeightedGraph dual_graph(const CellFaces& cells, std::size_t tets,
                         const std::vector<std::int32_t>& beyond) {
  for (const std::int32_t tet : beyond) TF_CHECK(tet >= 0 && at(tet) < tets);
  WeightedGraph graph;
  graph.weight.assign(tets + beyond.size(), 1);
  make_rows(graph, [&](const auto& visit) {
    for (const InnerFace& face : cells.inner) visit(at(face.owner), at(face.neighbour), 1);
    for (std::size_t i = 0; i < beyond.size(); ++i) visit(at(beyond[i]), tets + i, 1);
  });
  return graph;
}

}  // namespace tetfarm
