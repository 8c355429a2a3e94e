/// The nodes of the border, to be found by place: what another wall of a narrow gap has in the way
/// of an edge that is to come.
///
/// A wall that meets the new edge of a collapse, and none of the two old ones, has a node in the
/// triangle of the three. Source: none. Cost: O(n log n) to make; a search goes over the nodes
/// between the least and the largest x of the triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

class BorderNodes {
 public:
  /// Of the mesh as it is: while it is asked nodes may go, and none come or move.
  explicit BorderNodes(const MetricMesh& mesh);

  /// Whether one that is in use, and none of the three, lies in the triangle or on its border.
  /// Exact.
  bool any_in_triangle(const MetricMesh& mesh, std::int32_t a, std::int32_t b,
                       std::int32_t c) const;

 private:
  struct Entry {
    double x = 0;
    std::int32_t node = 0;
  };
  std::vector<Entry> by_x_;
};

/// The nodes of the border, gathered when they are first asked for: few operations need them. Until
/// then, too, nodes may go, and none come or move.
class LazyBorder {
 public:
  const BorderNodes& of(const MetricMesh& mesh) {
    if (!nodes_.has_value()) nodes_.emplace(mesh);
    return *nodes_;
  }

 private:
  std::optional<BorderNodes> nodes_;
};

}  // namespace tetfarm
