/// The boundary triangles as boundary recovery asks for them: is this edge, is this face one of
/// theirs?
///
/// Cost: O(n) to make; O(degree) an answer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

class RecoverySurface {
 public:
  /// Keeps a view of the triangles. `nodes` is the number of nodes they may use.
  RecoverySurface(std::span<const Triangle> triangles, std::int32_t nodes);

  std::int32_t nodes() const { return static_cast<std::int32_t>(edge_begin_.size()) - 1; }
  const std::span<const Triangle>& triangles() const { return triangles_; }
  /// Each edge once, the lower node first, in increasing order.
  std::vector<std::array<std::int32_t, 2>> edges() const;
  bool has_edge(std::int32_t a, std::int32_t b) const;
  /// The triangle with these nodes in any order, or -1. Of two equal ones the first.
  std::int32_t find_triangle(std::int32_t a, std::int32_t b, std::int32_t c) const;

 private:
  std::span<const Triangle> triangles_;
  std::vector<std::int32_t> edge_begin_;  // of a node: its edges to higher nodes
  std::vector<std::int32_t> edge_end_node_;
  std::vector<std::int32_t> triangle_begin_;  // of a node: triangles with it as their lowest
  std::vector<std::int32_t> triangle_;
};

}  // namespace tetfarm
