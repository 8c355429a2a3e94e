#include "mesh/spacing/demand_tree.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/box_measures.h"

namespace tetfarm {
namespace {

constexpr std::uint32_t leaf_size = 16;
constexpr std::size_t deepest_stack = 64;
/// Of the growth across the radius of a cell: far more than what rounding may put a point of the
/// cell outside its ball.
constexpr double rounding_slack = 1e-3;
/// A node of the tree is listed as a whole when it is no larger than these shares of the cell's
/// radius and of the distance between them.
constexpr double near_share = 0.25;
constexpr double far_share = 1;

/// Whether what lies that far away, squared, is for certain out of reach, without a root. The slack
/// is far more than what rounding does to the reach and to what a demand comes to there.
bool is_beyond(double distance2, double reach) {
  constexpr double slack = 1 + 1e-9;
  return reach < 0 || distance2 > slack * (reach * reach);
}

}  // namespace

DemandTree::DemandTree(std::vector<PointDemand> demands, double growth)
    : demands_(std::move(demands)), growth_(growth), shares_of_growth_(1 / growth) {
  TF_CHECK(growth > 0);
  TF_CHECK(demands_.size() <= std::numeric_limits<std::uint32_t>::max());
  if (demands_.empty()) return;
  last_winner_ = demands_.front();
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
    const int axis = longest_axis(here.box);
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

double DemandTree::bound(const Node& node, const Vec3& point) const {
  return std::max(node.least_spacing,
                  node.least_apex + growth_ * std::sqrt(distance2_to_box(node.box, point)));
}

bool DemandTree::may_be_less(const Node& node, double distance2, double radius, double than) const {
  return node.least_spacing < than &&
         !is_beyond(distance2, radius + shares_of_growth_ * (than - node.least_apex));
}

void DemandTree::lower(const PointDemand& demand, const Vec3& point, double radius,
                       double& best) const {
  const double reach = radius + demand.plateau + shares_of_growth_ * (best - demand.spacing);
  if (is_beyond(norm2(point - demand.at), reach)) return;
  const double here = value(demand, point, radius);
  if (here >= best) return;
  best = here;
  last_winner_ = demand;
}

void DemandTree::lower_below(std::uint32_t root, const Vec3& point, double radius,
                             double& best) const {
  struct Pending {
    std::uint32_t node;
    double distance2;
  };
  std::array<Pending, deepest_stack> stack;
  std::size_t depth = 0;
  Pending now{root, distance2_to_box(nodes_[root].box, point)};
  while (true) {
    const Node& node = nodes_[now.node];
    if (may_be_less(node, now.distance2, radius, best)) {
      if (node.children != 0) {
        now = {node.children, distance2_to_box(nodes_[node.children].box, point)};
        Pending far{node.children + 1, distance2_to_box(nodes_[node.children + 1].box, point)};
        if (far.distance2 < now.distance2) std::swap(now, far);
        TF_CHECK(depth < stack.size());
        stack[depth++] = far;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) lower(demands_[i], point, radius, best);
    }
    if (depth == 0) return;
    now = stack[--depth];
  }
}

DemandsInCell::DemandsInCell(const DemandTree& tree) : tree_(tree), lists_{{}} {
  if (!tree.nodes_.empty()) nodes_.push_back({0, -HUGE_VAL});
}

void DemandsInCell::enter(const Vec3& centre, double radius, double limit) {
  if (unlisted_) add_list(*unlisted_);
  unlisted_ = {centre, radius, limit};
}

void DemandsInCell::leave() {
  if (unlisted_) return unlisted_.reset();
  TF_CHECK(lists_.size() > 1);  // every cell that is left was entered
  demands_.resize(lists_.back().demand);
  nodes_.resize(lists_.back().node);
  lists_.pop_back();
}

/// What the lowest demand exceeds nowhere in the ball.
double DemandsInCell::limit_in(const Ball& ball) {
  double limit = ball.limit;
  away_.clear();
  for (std::size_t i = lists_.back().demand; i < demands_.size(); ++i) {
    const PointDemand& demand = demands_[i].demand;
    away_.push_back(distance(demand.at, ball.centre));
    const double beyond = away_.back() + ball.radius - demand.plateau;
    limit = std::min(limit, demand.spacing + tree_.growth_ * std::max(0.0, beyond));
  }
  for (std::size_t i = lists_.back().node; i < nodes_.size(); ++i) {
    const PointDemand& one_of_them = tree_.demands_[tree_.nodes_[nodes_[i].node].begin];
    limit = std::min(limit, tree_.value(one_of_them, ball.centre, -ball.radius));
  }
  return limit;
}

void DemandsInCell::add_list(Ball ball) {
  ball.limit = limit_in(ball) + rounding_slack * tree_.growth_ * ball.radius;
  const Starts outer = lists_.back();
  const Starts inner{demands_.size(), nodes_.size(), ball.centre};
  for (std::size_t i = outer.demand; i < inner.demand; ++i) {
    const PointDemand demand = demands_[i].demand;
    const double beyond = away_[i - outer.demand] - ball.radius - demand.plateau;
    if (demand.spacing + tree_.growth_ * std::max(0.0, beyond) > ball.limit) continue;
    add(demand, ball);
  }
  for (std::size_t i = outer.node; i < inner.node; ++i) add_below(nodes_[i].node, ball);
  const auto first = [](auto& items, std::size_t start) {
    return items.begin() + static_cast<std::ptrdiff_t>(start);
  };
  std::sort(first(demands_, inner.demand), demands_.end());
  std::sort(first(nodes_, inner.node), nodes_.end());
  lists_.push_back(inner);
}

void DemandsInCell::add(const PointDemand& demand, const Ball& ball) {
  demands_.push_back({demand, tree_.value(demand, ball.centre, 0)});
}

void DemandsInCell::add_below(std::uint32_t number, const Ball& ball) {
  const DemandTree::Node& node = tree_.nodes_[number];
  const double at_centre = tree_.bound(node, ball.centre);
  if (at_centre - tree_.growth_ * ball.radius > ball.limit || node.least_spacing > ball.limit) {
    return;
  }
  const double far = distance(node.box.centre(), ball.centre);
  if (norm(node.box.size()) <= near_share * ball.radius + far_share * far) {
    nodes_.push_back({number, at_centre});
  } else if (node.children != 0) {
    add_below(node.children, ball);
    add_below(node.children + 1, ball);
  } else {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const PointDemand& demand = tree_.demands_[i];
      if (tree_.value(demand, ball.centre, ball.radius) <= ball.limit) add(demand, ball);
    }
  }
}

double DemandsInCell::lowest(const Vec3& point, double radius, double limit) const {
  if (tree_.demands_.empty()) return limit;
  double best = std::min(limit, tree_.value(tree_.last_winner_, point, radius));
  const Starts& list = lists_.back();
  // What is more than that at the centre is not less than the best here, nor is all behind it.
  const double change =
      (1 + rounding_slack) * tree_.growth_ * (distance(point, list.centre) + radius);
  for (std::size_t i = list.demand; i < demands_.size(); ++i) {
    if (demands_[i].at_centre - change > best) break;
    tree_.lower(demands_[i].demand, point, radius, best);
  }
  for (std::size_t i = list.node; i < nodes_.size(); ++i) {
    if (nodes_[i].at_centre - change > best) break;
    tree_.lower_below(nodes_[i].node, point, radius, best);
  }
  return best;
}

}  // namespace tetfarm
