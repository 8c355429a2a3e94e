#include "mesh/assemble/shared_feet.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {

void SharedFeet::add(const NumberedPart& chunk) {
  const NodeFeet& feet = chunk.feet;
  TF_CHECK(feet.foot.size() == chunk.local2global.size());
  TF_CHECK(feet.depth.size() == chunk.local2global.size());
  for (std::size_t v = 0; v < feet.foot.size(); ++v) {
    if (feet.foot[v] == no_foot || chunk.local2global[v] >= shared_nodes_) continue;
    entries_.push_back({chunk.local2global[v], feet.foot[v], feet.depth[v]});
  }
}

void SharedFeet::finish() {
  std::sort(entries_.begin(), entries_.end());
  const auto is_same = [](const Entry& a, const Entry& b) { return a.node == b.node; };
  entries_.erase(std::unique(entries_.begin(), entries_.end(), is_same), entries_.end());
}

NodeFeet SharedFeet::of(std::span<const std::int64_t> nodes) const {
  NodeFeet feet;
  for (const std::int64_t node : nodes) {
    const auto found = std::lower_bound(
        entries_.begin(), entries_.end(), node,
        [](const Entry& entry, std::int64_t number) { return entry.node < number; });
    const bool is_there = found != entries_.end() && found->node == node;
    feet.add(is_there ? found->foot : no_foot, is_there ? found->depth : no_foot);
  }
  return feet;
}

}  // namespace tetfarm
