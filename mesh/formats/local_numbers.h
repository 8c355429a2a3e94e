/// Numbers of a part's own for nodes that are numbered in the whole mesh.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace tetfarm {

class LocalNumbers {
 public:
  LocalNumbers() : slots_(1024, -1) {}

  /// The node's number here: 0, 1, … as they are met.
  /// Cost: constant on average, whatever the numbers; 16 to 24 bytes a node.
  std::int32_t of(std::int64_t global);
  /// The number of a node that has been met, or -1.
  std::int32_t find(std::int64_t global) const { return slots_[slot_of(global)]; }
  /// Puts the nodes into ascending order of their numbers in the whole mesh. Returns of each number
  /// that `of` gave the one from now on. Called once, at the end.
  std::vector<std::int32_t> sort();
  /// Of each local number the one in the whole mesh.
  std::vector<std::int64_t> take() { return std::move(local2global_); }

 private:
  std::size_t slot_of(std::int64_t global) const;
  void grow();

  std::vector<std::int32_t> slots_;  // open addressing; a power of two of them
  std::vector<std::int64_t> local2global_;
};

}  // namespace tetfarm
