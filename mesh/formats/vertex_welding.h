/// Gives equal points one number: STL repeats each vertex in every triangle that uses it, and other
/// formats for each texture, normal or patch.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// Points are equal when their coordinates are, bit by bit, but for the sign of zero. They are
/// numbered in the order of their first occurrence. An open-addressing table: the numbers of
/// `std::hash` and the order of its buckets differ between libraries. Cost: O(1) a point, 8 bytes a
/// point for the table.
class VertexWelding {
 public:
  explicit VertexWelding(std::size_t expected_points);
  /// @pre finite, fewer than 2^31 - 1 different points.
  std::int32_t add(const Vec3& point);
  std::vector<Vec3> take_points() { return std::move(points_); }

 private:
  std::size_t slot_of(const Vec3& point) const;
  void grow();

  std::vector<Vec3> points_;
  std::vector<std::int32_t> slots_;  // a point's number, or -1; the length is a power of two
};

}  // namespace tetfarm
