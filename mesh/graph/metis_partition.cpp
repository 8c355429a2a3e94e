#include "mesh/graph/metis_partition.h"

#include <metis.h>

#include <array>
#include <new>
#include <numeric>
#include <type_traits>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

static_assert(std::is_same_v<idx_t, std::int32_t>, "the graph is handed over as it is");

/// METIS does not write to what it is given.
idx_t* given(const std::vector<std::int32_t>& numbers) {
  return numbers.empty() ? nullptr : const_cast<idx_t*>(numbers.data());
}

std::array<idx_t, METIS_NOPTIONS> metis_options(const MetisOptions& options) {
  std::array<idx_t, METIS_NOPTIONS> values;
  METIS_SetDefaultOptions(values.data());
  values[METIS_OPTION_SEED] = options.seed;
  values[METIS_OPTION_NCUTS] = options.trials;
  values[METIS_OPTION_UFACTOR] = options.imbalance_in_thousandths;
  values[METIS_OPTION_CONTIG] = options.contiguous ? 1 : 0;
  values[METIS_OPTION_OBJTYPE] =
      options.method == MetisOptions::Method::k_way_volume ? METIS_OBJTYPE_VOL : METIS_OBJTYPE_CUT;
  return values;
}

}  // namespace

std::vector<std::int32_t> metis_partition(const WeightedGraph& graph, std::int32_t parts,
                                          const MetisOptions& options) {
  TF_CHECK(parts >= 1 && graph.first.size() == graph.size() + 1);
  TF_CHECK(options.volume.empty() || options.volume.size() == graph.size());
  std::vector<std::int32_t> result(graph.size(), 0);
  if (parts == 1) return result;
  if (static_cast<std::size_t>(parts) >= graph.size()) {
    std::iota(result.begin(), result.end(), 0);
    return result;
  }
  auto nodes = static_cast<idx_t>(graph.size());
  idx_t constraints = 1;
  idx_t wanted = parts;
  idx_t objective_value = 0;
  std::array<idx_t, METIS_NOPTIONS> values = metis_options(options);
  const auto run = options.method == MetisOptions::Method::recursive ? METIS_PartGraphRecursive
                                                                     : METIS_PartGraphKway;
  const int outcome =
      run(&nodes, &constraints, given(graph.first), given(graph.neighbour), given(graph.weight),
          given(options.volume), given(graph.edge_weight), &wanted, nullptr, nullptr, values.data(),
          &objective_value, result.data());
  if (outcome == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (outcome != METIS_OK) {
    throw Error(ExitCode::failed, "METIS refuses the graph, code " + std::to_string(outcome));
  }
  return result;
}

}  // namespace tetfarm
