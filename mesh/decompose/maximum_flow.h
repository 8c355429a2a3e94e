/// Maximum flow and minimum cut in a sparse graph with integer capacities.
///
/// Source: E. Dinic, "Algorithm for solution of a problem of maximum flow in networks" (1970).
#pragma once

#include <cstdint>
#include <vector>

namespace tetfarm {

class FlowNetwork {
 public:
  explicit FlowNetwork(std::int32_t nodes);

  /// Two arcs, one each way, with these capacities.
  void add_edge(std::int32_t a, std::int32_t b, std::int64_t a_to_b, std::int64_t b_to_a);

  /// Which nodes are on the source's side of the minimum cut nearest to the source.
  /// Cost: O(phases * arcs) in practice; few phases where paths are short.
  std::vector<bool> source_side_of_minimum_cut(std::int32_t source, std::int32_t sink);

 private:
  struct Arc {
    std::int32_t to = 0;
    std::int32_t next = -1;  // of the same node; the reverse of arc a is a ^ 1
    std::int64_t capacity = 0;
  };

  bool find_levels(std::int32_t source, std::int32_t sink);
  bool augment(std::int32_t source, std::int32_t sink);

  std::vector<std::int32_t> first_;
  std::vector<Arc> arcs_;
  std::vector<std::int32_t> level_;
  std::vector<std::int32_t> current_;
};

}  // namespace tetfarm
