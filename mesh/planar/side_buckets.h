/// The sides of triangles by one of their nodes each, so that equal ones are found among the few of
/// a node.
///
/// Source: counting sort. Cost: O(triangles + nodes); 4 bytes for each side and each node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

class SideBuckets {
 public:
  /// `node_of(a, b)`: in which bucket the side from node a to node b is. @pre 0 <= it < nodes
  template <class NodeOf>
  SideBuckets(std::size_t nodes, std::span<const TriangleComplex::Nodes> triangles,
              const NodeOf& node_of)
      : starts_(nodes + 1, 0), sides_(3 * triangles.size()) {
    const auto for_each = [&](const auto& take) {
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleComplex::Nodes& n = triangles[t];
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t node = node_of(n[(i + 1) % 3], n[(i + 2) % 3]);
          take(static_cast<std::size_t>(node),
               edge_handle(static_cast<std::int32_t>(t), static_cast<int>(i)));
        }
      }
    };
    for_each([&](std::size_t node, EdgeHandle /*side*/) { ++starts_[node]; });
    std::int32_t end = 0;
    for (std::int32_t& start : starts_) start = end += start;
    // Backwards from the end of each bucket: sides are in the reverse order of the triangles.
    for_each([&](std::size_t node, EdgeHandle side) {
      sides_[static_cast<std::size_t>(--starts_[node])] = side;
    });
  }

  std::size_t nodes() const { return starts_.size() - 1; }
  /// Of a node, in no order that anybody should rely on.
  std::span<const EdgeHandle> of(std::size_t node) const {
    const auto first = static_cast<std::size_t>(starts_[node]);
    return std::span<const EdgeHandle>(sides_).subspan(
        first, static_cast<std::size_t>(starts_[node + 1]) - first);
  }

 private:
  std::vector<std::int32_t> starts_;
  std::vector<EdgeHandle> sides_;
};

}  // namespace tetfarm
