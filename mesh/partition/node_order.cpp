#include "mesh/partition/node_order.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/part_edges.h"

namespace tetfarm {
namespace {

using Edge = std::array<std::int32_t, 2>;

class CuthillMcKee {
 public:
  CuthillMcKee(const std::vector<Edge>& edges, std::size_t nodes)
      : first_(nodes + 1),
        neighbours_(2 * edges.size()),
        mark_(nodes, 0),
        is_placed_(nodes, false) {
    for (const Edge& edge : edges) {
      for (const std::int32_t v : edge) ++first_[at(v) + 1];
    }
    for (std::size_t v = 0; v < nodes; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [a, b] : edges) {
      neighbours_[next[at(a)]++] = b;
      neighbours_[next[at(b)]++] = a;
    }
    for (std::size_t v = 0; v < nodes; ++v) {
      std::sort(neighbours_.begin() + static_cast<long>(first_[v]),
                neighbours_.begin() + static_cast<long>(first_[v + 1]),
                [this](std::int32_t a, std::int32_t b) { return comes_first(a, b); });
    }
  }

  std::vector<std::int32_t> order() {
    std::vector<std::int32_t> order;
    for (std::size_t v = 0; v < is_placed_.size(); ++v) {
      if (is_placed_[v]) continue;
      const std::vector<std::int32_t> piece =
          search(peripheral_node(static_cast<std::int32_t>(v))).nodes;
      for (const std::int32_t node : piece) is_placed_[at(node)] = true;
      order.insert(order.end(), piece.rbegin(), piece.rend());
    }
    TF_CHECK(order.size() == is_placed_.size());  // each node once
    return order;
  }

 private:
  /// What is reached from a node, in breadth-first order.
  struct Search {
    std::vector<std::int32_t> nodes;
    std::size_t levels = 0;
    std::size_t first_of_last = 0;  ///< the farthest nodes begin there
  };

  std::size_t degree(std::int32_t v) const { return first_[at(v) + 1] - first_[at(v)]; }
  bool comes_first(std::int32_t a, std::int32_t b) const {
    return degree(a) != degree(b) ? degree(a) < degree(b) : a < b;
  }

  Search search(std::int32_t root) {
    ++round_;
    Search found;
    found.nodes = {root};
    mark_[at(root)] = round_;
    for (std::size_t begin = 0; begin < found.nodes.size(); ++found.levels) {
      const std::size_t end = found.nodes.size();
      found.first_of_last = begin;
      for (; begin < end; ++begin) {
        const std::size_t v = at(found.nodes[begin]);
        for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
          const std::int32_t neighbour = neighbours_[i];
          if (mark_[at(neighbour)] == round_) continue;
          mark_[at(neighbour)] = round_;
          found.nodes.push_back(neighbour);
        }
      }
    }
    return found;
  }

  /// Far from some other node of its piece: begins at `node`, goes to the far end as long as that
  /// makes the way longer.
  std::int32_t peripheral_node(std::int32_t node) {
    Search here = search(node);
    while (true) {
      const auto last = here.nodes.begin() + static_cast<long>(here.first_of_last);
      const std::int32_t far =
          *std::min_element(last, here.nodes.end(),
                            [this](std::int32_t a, std::int32_t b) { return comes_first(a, b); });
      Search there = search(far);
      if (there.levels <= here.levels) return far;
      here = std::move(there);
    }
  }

  std::vector<std::size_t> first_;
  std::vector<std::int32_t> neighbours_;
  std::vector<std::int32_t> mark_;
  std::vector<bool> is_placed_;
  std::int32_t round_ = 0;
};

}  // namespace

std::vector<std::int32_t> reverse_cuthill_mckee(const NumberedPart& part) {
  return CuthillMcKee(edges_of(part), part.nodes.size()).order();
}

void NumberSpans::add(const NumberSpans& other) {
  edges += other.edges;
  bandwidth = std::max(bandwidth, other.bandwidth);
  sum += other.sum;
}

NumberSpans number_spans(const NumberedPart& part) {
  NumberSpans spans;
  for (const auto& [a, b] : edges_of(part)) {
    ++spans.edges;
    spans.bandwidth = std::max<std::int64_t>(spans.bandwidth, b - a);
    spans.sum += b - a;
  }
  return spans;
}

}  // namespace tetfarm
