#include "mesh/decompose/graph_partition.h"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>

#include "base/error.h"

namespace tetfarm {
namespace {

constexpr idx_t seed = 20;
/// The heaviest group may exceed the mean by so many thousandths. The refinement that follows
/// evens the work out; here room is better spent on short interfaces.
constexpr idx_t imbalance_in_thousandths = 30;
/// Work is counted in units of which the whole graph has about this many: sums of METIS's 32-bit
/// weights stay far from their limit.
constexpr double units_of_work = 1 << 22;

/// The graph as METIS wants it: compressed rows, whole-number weights.
struct MetisGraph {
  std::vector<idx_t> first = {0};
  std::vector<idx_t> neighbour;
  std::vector<idx_t> shared;
  std::vector<idx_t> work;
  std::vector<idx_t> volume;
};

MetisGraph metis_graph_of(const SubdomainGraph& graph) {
  MetisGraph metis;
  double total = 0;
  for (const double work : graph.work) total += work;
  const double unit = total > 0 ? units_of_work / total : 0;
  for (std::size_t leaf = 0; leaf < graph.size(); ++leaf) {
    for (const Neighbour& other : graph.neighbours[leaf]) {
      metis.neighbour.push_back(other.leaf);
      metis.shared.push_back(other.triangles);
    }
    metis.first.push_back(static_cast<idx_t>(metis.neighbour.size()));
    metis.work.push_back(1 + static_cast<idx_t>(std::floor(graph.work[leaf] * unit)));
    metis.volume.push_back(std::max(1, graph.interface_nodes[leaf]));
  }
  return metis;
}

}  // namespace

std::vector<std::int32_t> partition_graph(const SubdomainGraph& graph, std::int32_t groups,
                                          PartitionMethod method) {
  std::vector<std::int32_t> leaf2group(graph.size(), 0);
  if (groups == 1) return leaf2group;
  if (static_cast<std::size_t>(groups) >= graph.size()) {
    std::iota(leaf2group.begin(), leaf2group.end(), 0);
    return leaf2group;
  }
  MetisGraph metis = metis_graph_of(graph);
  auto leaves = static_cast<idx_t>(graph.size());
  idx_t constraints = 1;
  idx_t parts = groups;
  idx_t objective_value = 0;
  std::array<idx_t, METIS_NOPTIONS> options;
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_NCUTS] = 4;
  options[METIS_OPTION_UFACTOR] = imbalance_in_thousandths;
  options[METIS_OPTION_OBJTYPE] =
      method == PartitionMethod::k_way_volume ? METIS_OBJTYPE_VOL : METIS_OBJTYPE_CUT;
  std::vector<idx_t> result(graph.size(), 0);
  const auto run =
      method == PartitionMethod::recursive ? METIS_PartGraphRecursive : METIS_PartGraphKway;
  const int outcome = run(&leaves, &constraints, metis.first.data(), metis.neighbour.data(),
                          metis.work.data(), metis.volume.data(), metis.shared.data(), &parts,
                          nullptr, nullptr, options.data(), &objective_value, result.data());
  if (outcome == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (outcome != METIS_OK) {
    throw Error(ExitCode::failed, "METIS refuses the graph, code " + std::to_string(outcome));
  }
  std::copy(result.begin(), result.end(), leaf2group.begin());
  return leaf2group;
}

}  // namespace tetfarm
