#include "mesh/spacing/demand_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tetfarm {
namespace {

constexpr std::uint32_t leaf_size = 8;
constexpr std::size_t deepest_stack = 64;
/// Of the growth across the radius of a cell: far more than what rounding may put a point of the
/// cell outside its ball.
constexpr double rounding_slack = 1e-3;
/// A node of the tree is listed as a whole when it is no larger than these shares of the cell's
/// radius and of the distance between them.
constexpr double near_share = 0.25;
constexpr double far_share = 1;

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

double DemandTree::lowest_below(std::uint32_t root, const Vec3& point, double radius,
                                double limit) const {
  double best = std::min(limit, value(demands_[last_winner_], point, radius));
  struct Pending {
    std::uint32_t node;
    double bound;
  };
  std::array<Pending, deepest_stack> stack;
  std::size_t depth = 0;
  stack[depth++] = {root, bound(nodes_[root], point, radius)};
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

DemandsInCell::DemandsInCell(const DemandTree& tree) : tree_(tree), lists_{{}} {
  if (!tree.nodes_.empty()) nodes_.push_back(0);
}

void DemandsInCell::enter(const Vec3& centre, double radius, double limit) {
  if (unlisted_) add_list(*unlisted_);
  unlisted_ = {centre, radius, limit};
}

void DemandsInCell::leave() {
  if (unlisted_) return unlisted_.reset();
  demands_.resize(lists_.back().demand);
  nodes_.resize(lists_.back().node);
  lists_.pop_back();
}

/// What the lowest demand exceeds nowhere in the ball.
double DemandsInCell::limit_in(const Ball& ball) {
  double limit = ball.limit;
  away_.clear();
  for (std::size_t i = lists_.back().demand; i < demands_.size(); ++i) {
    const PointDemand& demand = demands_[i];
    away_.push_back(distance(demand.at, ball.centre));
    const double beyond = away_.back() + ball.radius - demand.plateau;
    limit = std::min(limit, demand.spacing + tree_.growth_ * std::max(0.0, beyond));
  }
  for (std::size_t i = lists_.back().node; i < nodes_.size(); ++i) {
    const PointDemand& one_of_them = tree_.demands_[tree_.nodes_[nodes_[i]].begin];
    limit = std::min(limit, tree_.value(one_of_them, ball.centre, -ball.radius));
  }
  return limit;
}

void DemandsInCell::add_list(Ball ball) {
  ball.limit = limit_in(ball) + rounding_slack * tree_.growth_ * ball.radius;
  const Starts outer = lists_.back();
  const Starts inner{demands_.size(), nodes_.size()};
  for (std::size_t i = outer.demand; i < inner.demand; ++i) {
    const PointDemand demand = demands_[i];
    const double beyond = away_[i - outer.demand] - ball.radius - demand.plateau;
    if (demand.spacing + tree_.growth_ * std::max(0.0, beyond) > ball.limit) continue;
    demands_.push_back(demand);
  }
  for (std::size_t i = outer.node; i < inner.node; ++i) add_below(nodes_[i], ball);
  lists_.push_back(inner);
}

void DemandsInCell::add_below(std::uint32_t number, const Ball& ball) {
  const DemandTree::Node& node = tree_.nodes_[number];
  if (tree_.bound(node, ball.centre, ball.radius) > ball.limit) return;
  const double far = distance(node.box.centre(), ball.centre);
  if (norm(node.box.size()) <= near_share * ball.radius + far_share * far) {
    nodes_.push_back(number);
  } else if (node.children != 0) {
    add_below(node.children, ball);
    add_below(node.children + 1, ball);
  } else {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const PointDemand& demand = tree_.demands_[i];
      if (tree_.value(demand, ball.centre, ball.radius) <= ball.limit) demands_.push_back(demand);
    }
  }
}

double DemandsInCell::lowest(const Vec3& point, double radius, double limit) const {
  for (std::size_t i = lists_.back().demand; i < demands_.size(); ++i) {
    limit = std::min(limit, tree_.value(demands_[i], point, radius));
  }
  for (std::size_t i = lists_.back().node; i < nodes_.size(); ++i) {
    limit = tree_.lowest_below(nodes_[i], point, radius, limit);
  }
  return limit;
}

}  // namespace tetfarm
