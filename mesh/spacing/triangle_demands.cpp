#include "mesh/spacing/triangle_demands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/geometry/box_measures.h"
#include "mesh/geometry/nearest_point.h"

namespace tetfarm {
namespace {

constexpr std::uint32_t triangles_in_leaf = 4;
constexpr std::size_t deepest_path = 64;
/// Far more than what rounding does to bounds and distances, so that the least is the least in
/// whatever order the tree is walked.
constexpr double bound_slack = 1 - 1e-9;

bool is_positive(double x) { return x > 0 && std::isfinite(x); }

Vec3 middle_of(const TriangleDemand& demand) {
  return demand.corners[0] + demand.corners[1] + demand.corners[2];
}

}  // namespace

void check_triangle_demands(const std::vector<TriangleDemand>& demands) {
  for (const TriangleDemand& demand : demands) {
    if (!is_positive(demand.spacing)) {
      throw InvalidInput("the spacing at a patch is not positive", "spacing");
    }
    if (!is_positive(demand.growth)) {
      throw InvalidInput("the growth at a patch is not positive", "spacing");
    }
    for (const Vec3& corner : demand.corners) {
      if (std::isfinite(corner.x + corner.y + corner.z)) continue;
      throw InvalidInput("a corner of a patch is not finite", "spacing");
    }
  }
}

TriangleDemandTree::TriangleDemandTree(std::vector<TriangleDemand> demands)
    : demands_(std::move(demands)) {
  TF_CHECK(demands_.size() <= std::numeric_limits<std::uint32_t>::max());
  if (demands_.empty()) return;
  Node root;
  root.end = static_cast<std::uint32_t>(demands_.size());
  nodes_.push_back(root);
  for (std::size_t node = 0; node < nodes_.size(); ++node) split(node);
}

void TriangleDemandTree::split(std::size_t node) {
  Node here = nodes_[node];
  TF_CHECK(here.begin < here.end);
  here.least_spacing = HUGE_VAL;
  here.least_growth = HUGE_VAL;
  Box3 middles;
  for (std::uint32_t i = here.begin; i < here.end; ++i) {
    const TriangleDemand& demand = demands_[i];
    for (const Vec3& corner : demand.corners) here.box.add(corner);
    middles.add(middle_of(demand));
    here.least_spacing = std::min(here.least_spacing, demand.spacing);
    here.least_growth = std::min(here.least_growth, demand.growth);
    here.most_spacing = std::max(here.most_spacing, demand.spacing);
  }
  if (here.end - here.begin > triangles_in_leaf) {
    const int axis = longest_axis(middles);
    const std::uint32_t middle = here.begin + (here.end - here.begin) / 2;
    const auto first = demands_.begin();
    std::nth_element(first + here.begin, first + middle, first + here.end,
                     [axis](const TriangleDemand& a, const TriangleDemand& b) {
                       return middle_of(a)[axis] < middle_of(b)[axis];
                     });
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

double TriangleDemandTree::bound(const Node& node, const Vec3& point, double radius) const {
  const double beyond =
      std::sqrt(distance2_to_box(node.box, point)) - radius - triangle_plateau * node.most_spacing;
  return bound_slack * (node.least_spacing + node.least_growth * std::max(0.0, beyond));
}

void TriangleDemandTree::lower(std::uint32_t number, const Vec3& point, double radius,
                               double& best) const {
  ++looked_at_;
  const TriangleDemand& demand = demands_[number];
  const auto& [a, b, c] = demand.corners;
  const double away = distance(nearest_on_triangle(point, a, b, c), point);
  const double beyond = away - radius - triangle_plateau * demand.spacing;
  const double here = demand.spacing + demand.growth * std::max(0.0, beyond);
  if (here >= best) return;
  best = here;
  last_winner_ = number;
}

double TriangleDemandTree::lowest(const Vec3& point, double radius, double limit) const {
  double best = limit;
  if (empty() || bound(nodes_.front(), point, radius) >= best) return best;
  lower(last_winner_, point, radius, best);
  struct Pending {
    std::uint32_t node;
    double bound;
  };
  std::array<Pending, deepest_path> stack;
  std::size_t depth = 0;
  Pending now{0, bound(nodes_.front(), point, radius)};
  while (true) {
    ++looked_at_;
    const Node& node = nodes_[now.node];
    if (now.bound < best) {
      if (node.children != 0) {
        now = {node.children, bound(nodes_[node.children], point, radius)};
        Pending far{node.children + 1, bound(nodes_[node.children + 1], point, radius)};
        if (far.bound < now.bound) std::swap(now, far);
        TF_CHECK(depth < stack.size());
        stack[depth++] = far;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) lower(i, point, radius, best);
    }
    if (depth == 0) return best;
    now = stack[--depth];
  }
}

}  // namespace tetfarm
