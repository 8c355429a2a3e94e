#include "mesh/healing/nearly_flat_triangles.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "base/check.h"
#include "mesh/healing/new_triangles.h"

namespace tetfarm {
namespace {

constexpr int most_nearly_flat_passes = 100;
/// What is made is tested against all that was made before it in the pass.
constexpr std::size_t most_made_a_pass = 4000;

using Vertices = std::vector<std::int32_t>;

/// Of a triangle; the k-th side is opposite its k-th corner.
struct LengthsAndHeight {
  std::array<double, 3> length{};
  std::size_t longest = 0;  ///< of these
  std::size_t shortest = 0;
  double height = 0;  ///< over the longest
};

LengthsAndHeight measured(const TrianglePoints& c) {
  LengthsAndHeight sides;
  for (std::size_t k = 0; k < 3; ++k) {
    sides.length[k] = distance(c[(k + 1) % 3], c[(k + 2) % 3]);
    if (sides.length[k] > sides.length[sides.longest]) sides.longest = k;
    if (sides.length[k] < sides.length[sides.shortest]) sides.shortest = k;
  }
  const double doubled_area = norm(cross(c[1] - c[0], c[2] - c[0]));
  if (doubled_area > 0) sides.height = doubled_area / sides.length[sides.longest];
  return sides;
}

bool is_nearly_flat(const LengthsAndHeight& sides, double tolerance) {
  return sides.height <= tolerance &&
         sides.height < nearly_flat_share * sides.length[sides.longest];
}

bool holds(const Triangle& nodes, std::int32_t v) {
  return std::ranges::find(nodes, v) != nodes.end();
}

Triangle with(Triangle nodes, std::int32_t gone, std::int32_t come) {
  std::ranges::replace(nodes, gone, come);
  return nodes;
}

/// Triangles that come in place of others.
struct FlatChange {
  std::vector<std::int32_t> removed;
  std::vector<Triangle> made;
  std::vector<std::int32_t> source;  ///< of each made: the removed one whose place it takes
};

/// One pass: no triangle is touched twice.
class NearlyFlatPass {
 public:
  explicit NearlyFlatPass(HealingWork& work)
      : work_(work),
        uses_(edge_uses(work.surface.triangles)),
        near_(work.surface),
        triangles_of_(work.surface.vertices.size()),
        is_gone_(work.surface.triangles.size(), 0),
        is_touched_(work.surface.vertices.size(), 0) {
    for (std::size_t t = 0; t < is_gone_.size(); ++t) {
      for (const std::int32_t v : work_.surface.triangles[t]) {
        triangles_of_[static_cast<std::size_t>(v)].push_back(static_cast<std::int32_t>(t));
      }
    }
  }

  std::int64_t run() {
    const std::size_t count = is_gone_.size();
    std::int64_t removed = 0;
    for (std::size_t t = 0; t < count && made_.size() < most_made_a_pass; ++t) {
      if (is_gone_[t] == 0 && is_nearly_flat(sides(t), work_.tolerance)) removed += remove(t);
    }
    is_gone_.resize(work_.surface.triangles.size(), 0);
    remove_triangles(work_.surface, is_gone_);
    return removed;
  }

 private:
  LengthsAndHeight sides(std::size_t t) const { return measured(points_of(work_.surface, t)); }
  Triangle nodes(std::int32_t t) const {
    return work_.surface.triangles[static_cast<std::size_t>(t)];
  }
  bool is_gone(std::int32_t t) const { return is_gone_[static_cast<std::size_t>(t)] != 0; }
  const Vertices& ring(std::int32_t v) const { return triangles_of_[static_cast<std::size_t>(v)]; }

  /// How many went: of a short edge all that lie on it.
  std::int64_t remove(std::size_t t) {
    const LengthsAndHeight s = sides(t);
    const Triangle n = work_.surface.triangles[t];
    if (s.length[s.shortest] <= work_.tolerance) {
      const auto [low, high] = std::minmax(n[(s.shortest + 1) % 3], n[(s.shortest + 2) % 3]);
      if (collapse(high, low) || collapse(low, high)) {
        const auto on = uses_of_edge(uses_, low, high);
        for (const EdgeUse& use : on) tell(static_cast<std::size_t>(use.triangle));
        return std::ssize(on);
      }
    }
    if (!flip(t, s.longest)) return 0;
    tell(t);
    return 1;
  }

  void tell(std::size_t t) {
    const TrianglePoints points = points_of(work_.surface, t);
    work_.acts.push_back({HealKind::nearly_flat, points[measured(points).longest], {points}});
  }

  /// The longest edge goes; what lies beyond it is divided at the third vertex.
  bool flip(std::size_t t, std::size_t corner) {
    const Triangle cap = work_.surface.triangles[t];
    const std::int32_t between = cap[corner];
    FlatChange change{{static_cast<std::int32_t>(t)}, {}, {}};
    for (const EdgeUse& use : uses_of_edge(uses_, cap[(corner + 1) % 3], cap[(corner + 2) % 3])) {
      if (static_cast<std::size_t>(use.triangle) == t) continue;
      const Triangle other = nodes(use.triangle);
      const std::int32_t apex = other[0] + other[1] + other[2] - use.low - use.high;
      if (is_gone(use.triangle) || has_edge(apex, between)) return false;
      change.removed.push_back(use.triangle);
      for (const std::int32_t end : {use.low, use.high}) {
        change.made.push_back(with(other, end, between));
        change.source.push_back(use.triangle);
      }
    }
    return !change.made.empty() && is_a_gain(change) && make(change);
  }

  /// One vertex takes the place of the other.
  bool collapse(std::int32_t gone, std::int32_t kept) {
    if (is_touched(gone) || is_touched(kept) || !is_free(gone, kept)) return false;
    FlatChange change{ring(gone), {}, {}};
    for (const std::int32_t t : ring(gone)) {
      if (is_gone(t)) return false;
      if (holds(nodes(t), kept)) continue;
      change.made.push_back(with(nodes(t), gone, kept));
      change.source.push_back(t);
    }
    return make(change);
  }

  /// Whether the edge has two triangles, the ends have no other neighbours in common than these
  /// have, and no border between patches or regions is drawn away from where it runs.
  bool is_free(std::int32_t gone, std::int32_t kept) const {
    const auto on = uses_of_edge(uses_, gone, kept);
    if (on.size() != 2) return false;
    const std::set<std::int32_t> others = neighbours(kept);
    std::size_t common = 0;
    std::size_t borders = 0;
    for (const std::int32_t v : neighbours(gone)) {
      common += others.count(v);
      borders += is_border(uses_of_edge(uses_, gone, v)) ? 1 : 0;
    }
    return common == 2 && (borders == 0 || (borders == 2 && is_border(on)));
  }

  std::set<std::int32_t> neighbours(std::int32_t v) const {
    std::set<std::int32_t> found;
    for (const std::int32_t t : ring(v)) {
      for (const std::int32_t other : nodes(t)) found.insert(other);
    }
    found.erase(v);
    return found;
  }

  bool is_border(std::span<const EdgeUse> edge) const {
    TF_CHECK(!edge.empty());
    const auto patch = [this](const EdgeUse& use) {
      return patch_of(work_.surface, static_cast<std::size_t>(use.triangle));
    };
    return edge.size() != 2 || patch(edge[0]) != patch(edge[1]);
  }

  bool is_touched(std::int32_t v) const { return is_touched_[static_cast<std::size_t>(v)] != 0; }

  bool has_edge(std::int32_t a, std::int32_t b) const {
    return !uses_of_edge(uses_, a, b).empty() || new_edges_.count(std::minmax(a, b)) > 0;
  }

  double height(const Triangle& n) const {
    return measured(triangle_points(work_.surface.vertices, n)).height;
  }

  /// Whether what is made is nowhere as low as what goes was: so flips come to an end.
  bool is_a_gain(const FlatChange& change) const {
    double before = height(nodes(change.removed.front()));
    for (const std::int32_t t : change.removed) before = std::min(before, height(nodes(t)));
    return std::ranges::all_of(change.made, [&](const Triangle& n) { return height(n) > before; });
  }

  /// Whether a triangle with height looks the other way than the one whose place it takes.
  bool folds_over(const Triangle& made, const Triangle& old) const {
    const TrianglePoints c = triangle_points(work_.surface.vertices, made);
    const TrianglePoints o = triangle_points(work_.surface.vertices, old);
    if (is_nearly_flat(measured(o), work_.tolerance)) return false;
    return !(dot(cross(c[1] - c[0], c[2] - c[0]), cross(o[1] - o[0], o[2] - o[0])) > 0);
  }

  bool meets_something(const FlatChange& change) const {
    const std::vector<Vec3>& vertices = work_.surface.vertices;
    return near_.meet(change.made, is_gone_) ||
           std::ranges::any_of(change.made, [&](const Triangle& n) {
             return std::ranges::any_of(made_, [&](const Triangle& other) {
               return triangles_meet_beyond_shared(vertices, n, other);
             });
           });
  }

  /// False, with nothing changed, where something is in the way.
  bool make(const FlatChange& change) {
    TF_CHECK(change.made.size() == change.source.size());
    for (std::size_t i = 0; i < change.made.size(); ++i) {
      if (is_degenerate(triangle_points(work_.surface.vertices, change.made[i])) ||
          folds_over(change.made[i], nodes(change.source[i]))) {
        return false;
      }
    }
    for (const std::int32_t t : change.removed) is_gone_[static_cast<std::size_t>(t)] = 1;
    if (meets_something(change)) {
      for (const std::int32_t t : change.removed) is_gone_[static_cast<std::size_t>(t)] = 0;
      return false;
    }
    for (std::size_t i = 0; i < change.made.size(); ++i) add(change.made[i], change.source[i]);
    return true;
  }

  void add(const Triangle& made, std::int32_t source) {
    add_triangle(work_.surface, made, patch_of(work_.surface, static_cast<std::size_t>(source)));
    made_.push_back(made);
    for (std::size_t k = 0; k < 3; ++k) {
      is_touched_[static_cast<std::size_t>(made[k])] = 1;
      new_edges_.insert(std::minmax(made[k], made[(k + 1) % 3]));
    }
  }

  HealingWork& work_;
  std::vector<EdgeUse> uses_;  // this and what follows: as the surface was before the pass
  NearTriangles near_;
  std::vector<Vertices> triangles_of_;
  std::vector<char> is_gone_;
  std::vector<char> is_touched_;  // vertices of triangles that were made
  std::vector<Triangle> made_;
  std::set<std::pair<std::int32_t, std::int32_t>> new_edges_;
};

bool has_nearly_flat_triangle(const HealingWork& work) {
  for (std::size_t t = 0; t < work.surface.triangles.size(); ++t) {
    if (is_nearly_flat(measured(points_of(work.surface, t)), work.tolerance)) return true;
  }
  return false;
}

}  // namespace

std::int64_t remove_nearly_flat_triangles(HealingWork& work) {
  std::int64_t removed = 0;
  for (int pass = 0; pass < most_nearly_flat_passes && has_nearly_flat_triangle(work); ++pass) {
    const std::int64_t now = NearlyFlatPass(work).run();
    if (now == 0) break;
    removed += now;
  }
  return removed;
}

}  // namespace tetfarm
