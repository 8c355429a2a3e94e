#include "mesh/quality/cut_nodes.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Calls visit(node, region) for each node of each region of the part, once.
template <class Visit>
void for_each_use(const MeshSource& source, std::size_t i, const Visit& visit) {
  const NumberedPart outline = source.counted_part(i).part;
  if (outline.region_of_tet.empty()) {
    for (const std::int64_t node : outline.local2global) visit(node, outline.region);
    return;
  }
  const NumberedPart part = source.part(i);
  std::vector<std::size_t> last_range(part.nodes.size(), 0);
  std::size_t number = 0;
  for (const TetRange& range : ranges_of(part)) {
    ++number;
    for (std::size_t t = range.first; t < range.last; ++t) {
      for (const std::int32_t v : part.tets[t]) {
        std::size_t& last = last_range[static_cast<std::size_t>(v)];
        if (last != number) visit(part.local2global[static_cast<std::size_t>(v)], range.region);
        last = number;
      }
    }
  }
}

}  // namespace

std::vector<TetRange> ranges_of(const NumberedPart& part) {
  std::vector<TetRange> ranges;
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    const std::int32_t region = part.region_of(t);
    if (ranges.empty() || ranges.back().region != region) ranges.push_back({t, t, region});
    ranges.back().last = t + 1;
  }
  return ranges;
}

CutNodes::CutNodes(const MeshSource& source) {
  if (!source.knows_subdomains()) return;
  std::vector<bool> is_met;
  std::vector<bool> has_several;
  for (std::size_t i = 0; i < source.size(); ++i) {
    for_each_use(source, i, [&](std::int64_t node, std::int32_t) {
      const auto at = static_cast<std::size_t>(node);
      if (at >= is_met.size()) {
        is_met.resize(std::max(at + 1, 2 * is_met.size()), false);
        has_several.resize(is_met.size(), false);
      }
      if (is_met[at]) has_several[at] = true;
      is_met[at] = true;
    });
  }
  std::vector<Use> uses;
  for (std::size_t i = 0; i < source.size(); ++i) {
    for_each_use(source, i, [&](std::int64_t node, std::int32_t region) {
      if (has_several[static_cast<std::size_t>(node)]) uses.emplace_back(node, region);
    });
  }
  std::sort(uses.begin(), uses.end());
  for (std::size_t i = 1; i < uses.size(); ++i) {
    const bool is_known = !on_cuts_.empty() && on_cuts_.back() == uses[i];
    if (uses[i] == uses[i - 1] && !is_known) on_cuts_.push_back(uses[i]);
  }
}

std::vector<bool> CutNodes::of(const NumberedPart& part, std::int32_t region) const {
  TF_CHECK(region >= 1);
  std::vector<bool> is_on_cut;
  is_on_cut.reserve(part.local2global.size());
  for (const std::int64_t node : part.local2global) {
    is_on_cut.push_back(std::binary_search(on_cuts_.begin(), on_cuts_.end(), Use{node, region}));
  }
  return is_on_cut;
}

}  // namespace tetfarm
