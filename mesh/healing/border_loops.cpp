#include "mesh/healing/border_loops.h"

#include <map>

namespace tetfarm {
namespace {

struct NextOnBorder {
  std::int32_t vertex = 0;
  std::int32_t triangle = 0;
  bool is_only = true;
  bool is_seen = false;
};

using Border = std::map<std::int32_t, NextOnBorder>;

Border border_of(std::span<const EdgeUse> uses) {
  Border border;
  for_each_edge(uses, [&border](std::span<const EdgeUse> edge) {
    if (edge.size() != 1) return;
    // Against the triangle's own direction.
    const std::int32_t from = edge[0].forward ? edge[0].high : edge[0].low;
    const std::int32_t to = edge[0].forward ? edge[0].low : edge[0].high;
    const auto [next, is_new] = border.try_emplace(from, NextOnBorder{to, edge[0].triangle});
    if (!is_new) next->second.is_only = false;
  });
  return border;
}

}  // namespace

std::vector<BorderLoop> border_loops(std::span<const EdgeUse> uses) {
  Border border = border_of(uses);
  std::vector<BorderLoop> loops;
  for (auto& [start, first] : border) {
    if (first.is_seen) continue;
    BorderLoop loop{{}, first.triangle};
    bool is_simple = true;
    std::int32_t v = start;
    for (auto here = border.find(v); here != border.end() && !here->second.is_seen;
         here = border.find(v)) {
      here->second.is_seen = true;
      is_simple = is_simple && here->second.is_only;
      loop.vertices.push_back(v);
      v = here->second.vertex;
    }
    if (is_simple && v == start && loop.vertices.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace tetfarm
