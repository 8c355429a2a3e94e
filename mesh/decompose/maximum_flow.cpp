#include "mesh/decompose/maximum_flow.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {
std::size_t idx(std::int32_t i) { return static_cast<std::size_t>(i); }
}  // namespace

FlowNetwork::FlowNetwork(std::int32_t nodes) : first_(idx(nodes), -1), level_(idx(nodes)) {}

void FlowNetwork::add_edge(std::int32_t a, std::int32_t b, std::int64_t a_to_b,
                           std::int64_t b_to_a) {
  TF_CHECK(a_to_b >= 0 && b_to_a >= 0 && a != b);
  arcs_.push_back({b, first_[idx(a)], a_to_b});
  first_[idx(a)] = static_cast<std::int32_t>(arcs_.size()) - 1;
  arcs_.push_back({a, first_[idx(b)], b_to_a});
  first_[idx(b)] = static_cast<std::int32_t>(arcs_.size()) - 1;
}

bool FlowNetwork::find_levels(std::int32_t source, std::int32_t sink) {
  TF_CHECK(source != sink);
  std::fill(level_.begin(), level_.end(), -1);
  level_[idx(source)] = 0;
  std::vector<std::int32_t> queue = {source};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (std::int32_t a = first_[idx(queue[i])]; a >= 0; a = arcs_[idx(a)].next) {
      const Arc& arc = arcs_[idx(a)];
      if (arc.capacity == 0 || level_[idx(arc.to)] >= 0) continue;
      level_[idx(arc.to)] = level_[idx(queue[i])] + 1;
      queue.push_back(arc.to);
    }
  }
  return level_[idx(sink)] >= 0;
}

/// One path from source to sink through ascending levels, filled; false when there is none left.
bool FlowNetwork::augment(std::int32_t source, std::int32_t sink) {
  std::vector<std::int32_t> path;
  std::int32_t at = source;
  while (at != sink) {
    std::int32_t& a = current_[idx(at)];
    while (a >= 0 &&
           (arcs_[idx(a)].capacity == 0 || level_[idx(arcs_[idx(a)].to)] != level_[idx(at)] + 1)) {
      a = arcs_[idx(a)].next;
    }
    if (a >= 0) {
      path.push_back(a);
      at = arcs_[idx(a)].to;
      continue;
    }
    if (path.empty()) return false;
    at = arcs_[idx(path.back() ^ 1)].to;
    current_[idx(at)] = arcs_[idx(path.back())].next;
    path.pop_back();
  }
  std::int64_t flow = arcs_[idx(path.front())].capacity;
  for (const std::int32_t a : path) flow = std::min(flow, arcs_[idx(a)].capacity);
  TF_CHECK(flow > 0);
  for (const std::int32_t a : path) {
    arcs_[idx(a)].capacity -= flow;
    arcs_[idx(a ^ 1)].capacity += flow;
  }
  return true;
}

std::vector<bool> FlowNetwork::source_side_of_minimum_cut(std::int32_t source, std::int32_t sink) {
  while (find_levels(source, sink)) {
    current_ = first_;
    while (augment(source, sink)) {
    }
  }
  std::vector<bool> is_source_side;
  is_source_side.reserve(level_.size());
  for (const std::int32_t level : level_) is_source_side.push_back(level >= 0);
  return is_source_side;
}

}  // namespace tetfarm
