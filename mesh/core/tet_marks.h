/// A set of tets that is emptied at once: what a walk over a TetComplex has seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/array_index.h"

namespace tetfarm {

/// Holds numbers below those that there is room for. Cost: none but for make_room.
class TetMarks {
 public:
  explicit TetMarks(std::size_t tets = 0) : tet2mark_(tets, 0) {}

  /// For tets that the complex has got since.
  void make_room(std::size_t tets) {
    if (tets > tet2mark_.size()) tet2mark_.resize(tets, 0);
  }
  void clear() { ++mark_; }
  void add(std::int32_t tet) { tet2mark_[at(tet)] = mark_; }
  bool has(std::int32_t tet) const { return tet2mark_[at(tet)] == mark_; }

 private:
  std::vector<std::uint32_t> tet2mark_;
  std::uint32_t mark_ = 1;
};

}  // namespace tetfarm
