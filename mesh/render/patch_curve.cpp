#include "mesh/render/patch_curve.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// One of the two ends of an edge.
struct EdgeEnd {
  std::int32_t node = 0;
  std::int32_t other = 0;
  std::size_t edge = 0;
};

/// The edges of some patches by their nodes.
class PatchEdges {
 public:
  PatchEdges(const PlaneMesh& mesh, std::span<const std::int32_t> patches) {
    for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
      const bool is_wanted =
          std::find(patches.begin(), patches.end(), mesh.patches[k]) != patches.end();
      const auto [a, b] = mesh.edges[k];
      if (!is_wanted || a == b) continue;
      ends_.push_back({a, b, k});
      ends_.push_back({b, a, k});
    }
    std::sort(ends_.begin(), ends_.end(), [](const EdgeEnd& s, const EdgeEnd& t) {
      return s.node != t.node ? s.node < t.node : s.edge < t.edge;
    });
    is_used_.resize(mesh.edges.size(), false);
  }

  std::vector<std::vector<std::int32_t>> lines() {
    std::vector<std::vector<std::int32_t>> lines;
    for (const bool from_ends : {true, false}) {
      for (const EdgeEnd& end : ends_) {
        if (is_used_[end.edge] || (from_ends && passes(end.node))) continue;
        lines.push_back(line_from(end));
      }
    }
    return lines;
  }

 private:
  std::span<const EdgeEnd> at(std::int32_t node) const {
    const auto first =
        std::lower_bound(ends_.begin(), ends_.end(), node,
                         [](const EdgeEnd& e, std::int32_t v) { return e.node < v; });
    auto last = first;
    while (last != ends_.end() && last->node == node) ++last;
    return {first, last};
  }
  /// Whether a line goes on at the node.
  bool passes(std::int32_t node) const { return at(node).size() == 2; }

  std::vector<std::int32_t> line_from(const EdgeEnd& start) {
    std::vector<std::int32_t> line = {start.node, start.other};
    is_used_[start.edge] = true;
    while (line.back() != start.node && passes(line.back())) {
      const std::span<const EdgeEnd> two = at(line.back());
      const EdgeEnd& next = is_used_[two.front().edge] ? two.back() : two.front();
      if (is_used_[next.edge]) break;
      is_used_[next.edge] = true;
      line.push_back(next.other);
    }
    return line;
  }

  std::vector<EdgeEnd> ends_;
  std::vector<bool> is_used_;
};

}  // namespace

std::vector<std::vector<std::int32_t>> patch_lines(const PlaneMesh& mesh,
                                                   std::span<const std::int32_t> patches) {
  TF_CHECK(mesh.edges.size() == mesh.patches.size());
  return PatchEdges(mesh, patches).lines();
}

std::vector<std::vector<Vec2>> values_over_x(const PlaneMesh& mesh, std::span<const double> values,
                                             std::span<const std::int32_t> patches) {
  TF_CHECK(values.size() == mesh.points.size());
  std::vector<std::vector<Vec2>> curves;
  for (const std::vector<std::int32_t>& line : patch_lines(mesh, patches)) {
    std::vector<Vec2>& curve = curves.emplace_back();
    for (const std::int32_t v : line) {
      const auto i = static_cast<std::size_t>(v);
      curve.push_back({mesh.points[i].x, values[i]});
    }
  }
  return curves;
}

}  // namespace tetfarm
