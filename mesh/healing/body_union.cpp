#include "mesh/healing/body_union.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/arrangement/triangle_arrangement.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/healing/chain_insides.h"
#include "mesh/inspect/shell_orientation.h"
#include "mesh/inspect/shifted_ray.h"

namespace tetfarm {
namespace {

void turn(Triangle& nodes) { std::swap(nodes[1], nodes[2]); }

/// Whether each edge is used as often one way as the other.
bool is_closed_chain(const SurfaceMesh& surface) {
  bool is_closed = true;
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  for_each_edge(std::span<const EdgeUse>(uses), [&](std::span<const EdgeUse> edge) {
    const auto forward = std::ranges::count(edge, true, &EdgeUse::forward);
    is_closed = is_closed && 2 * forward == static_cast<std::ptrdiff_t>(edge.size());
  });
  return is_closed;
}

/// The shells of a surface, each made to face the way that union wants it.
class Bodies {
 public:
  explicit Bodies(const SurfaceMesh& given) : surface_(given) {}

  /// False where no winding numbers can be told.
  bool make_consistent() {
    const std::vector<EdgeUse> uses = edge_uses(surface_.triangles);
    const std::vector<char> all(surface_.triangles.size(), 1);
    ShellOrientation orientation = orient_shells(surface_, uses, all);
    if (orientation.defect) return false;
    shells_ = std::move(orientation.shells);
    shell_of_ = std::move(orientation.triangle2shell);
    for (std::size_t s = 0; s < shells_.size(); ++s) agree(shells_[s], orientation.turn);
    if (!is_closed_chain(surface_)) return false;
    volume_.resize(shells_.size());
    double sum = 0;
    for (std::size_t s = 0; s < shells_.size(); ++s) sum += volume_[s] = volume_of(shells_[s]);
    if (sum < 0) {
      for (std::size_t s = 0; s < shells_.size(); ++s) turn_shell(s);
    }
    return true;
  }

  /// Which shells share points with themselves or others beyond common corners and edges, and the
  /// first triangle of each that does; false: none.
  bool find_meeting() {
    first_meeting_.assign(shells_.size(), -1);
    tree_ = BoxTree(triangle_boxes(surface_.vertices, surface_.triangles));
    std::vector<char> meets(surface_.triangles.size(), 0);
    tree_.self_pairs([&](std::int32_t i, std::int32_t j) {
      if (meets[at(i)] != 0 && meets[at(j)] != 0) return;
      if (triangles_meet_beyond_shared(surface_.vertices, surface_.triangles[at(i)],
                                       surface_.triangles[at(j)])) {
        meets[at(i)] = meets[at(j)] = 1;
      }
    });
    for (std::size_t t = 0; t < meets.size(); ++t) {
      std::int32_t& first = first_meeting_[at(shell_of_[t])];
      if (meets[t] != 0 && first < 0) first = static_cast<std::int32_t>(t);
    }
    return std::ranges::find(meets, 1) != meets.end();
  }

  void face_outward() {
    std::vector<char> is_decided(shells_.size(), 0);
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (!meets(s)) continue;
      if (volume_[s] < 0) turn_shell(s);
      is_decided[s] = 1;
    }
    std::vector<std::size_t> by_size(shells_.size());
    std::iota(by_size.begin(), by_size.end(), std::size_t{0});
    std::ranges::stable_sort(by_size, std::greater{},
                             [&](std::size_t s) { return std::abs(volume_[s]); });
    // What lies round a shell is larger than it is.
    for (const std::size_t s : by_size) {
      if (is_decided[s] != 0) continue;
      if (volume_[s] < 0 && winding_round(s, is_decided) <= 0) turn_shell(s);
      is_decided[s] = 1;
    }
  }

  const SurfaceMesh& surface() const { return surface_; }
  std::size_t count() const { return shells_.size(); }
  const std::vector<std::int32_t>& shell(std::size_t s) const { return shells_[s]; }
  bool meets(std::size_t s) const { return first_meeting_[s] >= 0; }
  /// A corner of the first triangle that meets another, or else of the first.
  Vec3 place(std::size_t s) const {
    const std::int32_t t = meets(s) ? first_meeting_[s] : shells_[s].front();
    return vertex_at(surface_, surface_.triangles[at(t)][0]);
  }

 private:
  void agree(const std::vector<std::int32_t>& shell, const std::vector<char>& turned) {
    const auto turns =
        std::ranges::count_if(shell, [&](std::int32_t t) { return turned[at(t)] != 0; });
    // As most of them face.
    const bool is_minority = 2 * turns <= static_cast<std::ptrdiff_t>(shell.size());
    for (const std::int32_t t : shell) {
      if ((turned[at(t)] != 0) == is_minority) turn(surface_.triangles[at(t)]);
    }
  }

  void turn_shell(std::size_t s) {
    for (const std::int32_t t : shells_[s]) turn(surface_.triangles[at(t)]);
    volume_[s] = -volume_[s];
  }

  double volume_of(const std::vector<std::int32_t>& shell) const {
    std::vector<Triangle> triangles;
    for (const std::int32_t t : shell) triangles.push_back(surface_.triangles[at(t)]);
    return enclosed_volume(surface_.vertices, triangles);
  }

  /// How often the shells that are decided wind round one that meets none.
  int winding_round(std::size_t s, const std::vector<char>& is_decided) const {
    const Vec3 p = place(s);
    int winding = 0;
    tree_.query({p, {HUGE_VAL, p.y, p.z}}, [&](std::int32_t t) {
      if (is_decided[at(shell_of_[at(t)])] == 0) return;
      winding += ray_passes(p, triangle_points(surface_.vertices, surface_.triangles[at(t)]));
    });
    return winding;
  }

  SurfaceMesh surface_;
  std::vector<std::vector<std::int32_t>> shells_;
  std::vector<std::int32_t> shell_of_;
  std::vector<std::int32_t> first_meeting_;
  std::vector<double> volume_;
  BoxTree tree_;
};

/// The border of what the chain winds round.
std::optional<SurfaceMesh> border_of_union(const TriangleChain& chain, const SurfaceMesh& input,
                                           double tolerance, std::vector<TrianglePoints>& made) {
  const auto sides = insides_of(chain, tolerance);
  if (!sides) return std::nullopt;
  SurfaceMesh border{chain.vertices, {}, {}, input.patch_names, {}, {}};
  for (std::size_t t = 0; t < chain.triangles.size(); ++t) {
    const auto [is_behind_inside, is_front_inside] = (*sides)[t];
    if (is_behind_inside == is_front_inside) continue;
    Triangle nodes = chain.triangles[t].nodes;
    if (!is_behind_inside) turn(nodes);
    border.triangles.push_back(nodes);
    if (!input.patch_of_triangle.empty()) {
      border.patch_of_triangle.push_back(chain.triangles[t].patch);
    }
    if (chain.triangles[t].is_divided) made.push_back(triangle_points(border.vertices, nodes));
  }
  return border;
}

/// Leaves out vertices that no triangle has any more; of those of the input that none had, too.
void drop_unused_vertices(SurfaceMesh& surface) {
  std::vector<std::int32_t> number(surface.vertices.size(), -1);
  for (const Triangle& t : surface.triangles) {
    for (const std::int32_t n : t) number[at(n)] = 0;
  }
  std::int32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    surface.vertices[at(count)] = surface.vertices[v];
    number[v] = count++;
  }
  surface.vertices.resize(at(count));
  for (Triangle& t : surface.triangles) {
    for (std::int32_t& n : t) n = number[at(n)];
  }
}

}  // namespace

std::int64_t unite_bodies(HealingWork& work) {
  Bodies bodies(work.surface);
  if (!bodies.make_consistent()) return 0;
  if (!bodies.find_meeting()) return 0;
  bodies.face_outward();
  const auto chain = arrange_triangles(bodies.surface(), work.tolerance);
  if (!chain) return 0;
  std::vector<TrianglePoints> made;
  std::optional<SurfaceMesh> border = border_of_union(*chain, work.surface, work.tolerance, made);
  if (!border) return 0;
  std::vector<char> is_left(work.surface.vertices.size(), 0);
  for (const Triangle& t : border->triangles) {
    for (const std::int32_t n : t) {
      if (at(n) < is_left.size()) is_left[at(n)] = 1;
    }
  }
  std::int64_t changed = 0;
  for (std::size_t s = 0; s < bodies.count(); ++s) {
    const bool is_gone = std::ranges::none_of(bodies.shell(s), [&](std::int32_t t) {
      return std::ranges::any_of(bodies.surface().triangles[at(t)],
                                 [&](std::int32_t n) { return is_left[at(n)] != 0; });
    });
    if (!bodies.meets(s) && !is_gone) continue;
    HealAct act{bodies.meets(s) ? HealKind::united : HealKind::inside, bodies.place(s), {}};
    if (bodies.meets(s)) {
      act.triangles = std::exchange(made, {});
    } else {
      for (const std::int32_t t : bodies.shell(s)) {
        act.triangles.push_back(points_of(bodies.surface(), at(t)));
      }
    }
    work.acts.push_back(std::move(act));
    ++changed;
  }
  drop_unused_vertices(*border);
  work.surface = std::move(*border);
  return changed;
}

}  // namespace tetfarm
