#include "mesh/assimilation/graph_partition.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/graph/metis_partition.h"

namespace tetfarm {
namespace {

/// The heaviest group may exceed the mean by so many thousandths. The refinement that follows
/// evens the work out; here room is better spent on short interfaces.
constexpr std::int32_t imbalance_in_thousandths = 30;
/// Work is counted in units of which the whole graph has about this many: sums of METIS's 32-bit
/// weights stay far from their limit.
constexpr double units_of_work = 1 << 22;

WeightedGraph weighted_graph_of(const SubdomainGraph& graph) {
  WeightedGraph weighted;
  double total = 0;
  for (const double work : graph.work) total += work;
  const double unit = total > 0 ? units_of_work / total : 0;
  for (std::size_t leaf = 0; leaf < graph.size(); ++leaf) {
    for (const Neighbour& other : graph.neighbours[leaf]) {
      weighted.neighbour.push_back(other.leaf);
      weighted.edge_weight.push_back(other.triangles);
    }
    weighted.first.push_back(static_cast<std::int32_t>(weighted.neighbour.size()));
    weighted.weight.push_back(1 + static_cast<std::int32_t>(std::floor(graph.work[leaf] * unit)));
  }
  TF_CHECK(weighted.first.size() == graph.size() + 1);
  return weighted;
}

MetisOptions::Method metis_method(PartitionMethod method) {
  switch (method) {
    case PartitionMethod::recursive:
      return MetisOptions::Method::recursive;
    case PartitionMethod::k_way:
      return MetisOptions::Method::k_way;
    case PartitionMethod::k_way_volume:
      break;
  }
  return MetisOptions::Method::k_way_volume;
}

}  // namespace

std::vector<std::int32_t> partition_graph(const SubdomainGraph& graph, std::int32_t groups,
                                          PartitionMethod method) {
  TF_CHECK(groups >= 1);
  MetisOptions options;
  options.method = metis_method(method);
  options.imbalance_in_thousandths = imbalance_in_thousandths;
  options.trials = 4;
  for (const std::int32_t nodes : graph.interface_nodes) {
    options.volume.push_back(std::max(1, nodes));
  }
  return metis_partition(weighted_graph_of(graph), groups, options);
}

}  // namespace tetfarm
