#include "mesh/spacing/demand_tree.h"

#include <algorithm>
#include <utility>

namespace tetfarm {
namespace {

constexpr std::uint32_t leaf_size = 8;
constexpr std::size_t deepest_stack = 64;

int widest_axis(const Box3& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

DemandTree::DemandTree(std::vector<PointDemand> demands, double growth)
    : demands_(std::move(demands)), growth_(growth) {
  if (demands_.empty()) return;
  Node root;
  root.end = static_cast<std::uint32_t>(demands_.size());
  nodes_.push_back(root);
  for (std::size_t node = 0; node < nodes_.size(); ++node) split(node);
}

void DemandTree::split(std::size_t node) {
  Node here = nodes_[node];
  here.least_spacing = HUGE_VAL;
  here.least_apex = HUGE_VAL;
  for (std::uint32_t i = here.begin; i < here.end; ++i) {
    const PointDemand& demand = demands_[i];
    here.box.add(demand.at);
    here.least_spacing = std::min(here.least_spacing, demand.spacing);
    here.least_apex = std::min(here.least_apex, demand.spacing - growth_ * demand.plateau);
  }
  if (here.end - here.begin > leaf_size) {
    const int axis = widest_axis(here.box);
    const std::uint32_t middle = here.begin + (here.end - here.begin) / 2;
    const auto first = demands_.begin();
    std::nth_element(
        first + here.begin, first + middle, first + here.end,
        [axis](const PointDemand& a, const PointDemand& b) { return a.at[axis] < b.at[axis]; });
    here.children = static_cast<std::uint32_t>(nodes_.size());
    Node child;
    child.begin = here.begin;
    child.end = middle;
    nodes_.push_back(child);
    child.begin = middle;
    child.end = here.end;
    nodes_.push_back(child);
  }
  nodes_[node] = here;
}

double DemandTree::value(const PointDemand& demand, const Vec3& point, double radius) const {
  const double beyond = distance(demand.at, point) - radius - demand.plateau;
  return demand.spacing + growth_ * std::max(0.0, beyond);
}

double DemandTree::bound(const Node& node, const Vec3& point, double radius) const {
  Vec3 away;
  for (int axis = 0; axis < 3; ++axis) {
    away[axis] =
        std::max({0.0, node.box.low[axis] - point[axis], point[axis] - node.box.high[axis]});
  }
  return std::max(node.least_spacing, node.least_apex + growth_ * (norm(away) - radius));
}

double DemandTree::lowest(const Vec3& point, double radius, double limit) const {
  if (demands_.empty()) return limit;
  double best = std::min(limit, value(demands_[last_winner_], point, radius));
  struct Pending {
    std::uint32_t node;
    double bound;
  };
  std::array<Pending, deepest_stack> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, bound(nodes_[0], point, radius)};
  while (depth > 0) {
    const Pending pending = stack[--depth];
    if (pending.bound >= best) continue;
    const Node& node = nodes_[pending.node];
    if (node.children != 0) {
      Pending near{node.children, bound(nodes_[node.children], point, radius)};
      Pending far{node.children + 1, bound(nodes_[node.children + 1], point, radius)};
      if (far.bound < near.bound) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const double here = value(demands_[i], point, radius);
      if (here >= best) continue;
      best = here;
      last_winner_ = i;
    }
  }
  return best;
}

}  // namespace tetfarm
