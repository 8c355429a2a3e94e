/// The feet of nodes that layers share with what lies beside them: the sub-domains there have these
/// nodes too, and know nothing of lines.
///
/// Source: none in the thesis.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

class SharedFeet {
 public:
  /// Only nodes with numbers below this are kept: those of the surface and of the cuts, of which
  /// the top of the layers is one. The others are in chunks of layers alone, which know them.
  explicit SharedFeet(std::int64_t shared_nodes) : shared_nodes_(shared_nodes) {}

  /// Of a chunk of layers. Cost: O(nodes). Memory: 24 bytes for each node that is kept, of which
  /// the wall and the top have one each for each line.
  void add(const NumberedPart& chunk);
  /// @pre behind the last `add`. Cost: O(n log n).
  void finish();
  /// Of nodes by their numbers in the whole mesh; no_foot of those that no chunk has.
  /// @pre finish was called. Cost: O(log n) a node.
  NodeFeet of(std::span<const std::int64_t> nodes) const;

 private:
  struct Entry {
    std::int64_t node = 0;
    std::int64_t foot = 0;
    std::int32_t depth = 0;

    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  std::int64_t shared_nodes_;
  std::vector<Entry> entries_;  // ascending, once they are finished
};

}  // namespace tetfarm
