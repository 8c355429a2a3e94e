#include "mesh/healing/crossing_replacement.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "base/disjoint_sets.h"
#include "mesh/geometry/triangle_distance.h"
#include "mesh/healing/border_loops.h"
#include "mesh/healing/loop_filling.h"
#include "mesh/healing/new_triangles.h"

namespace tetfarm {
namespace {

constexpr int most_rings = 2;

/// Triangles that are marked and share vertices, group by group, each sorted.
std::vector<std::vector<std::int32_t>> connected_groups(const SurfaceMesh& surface,
                                                        const std::vector<char>& is_marked) {
  DisjointSets sets(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_marked[t] == 0) continue;
    const Triangle& n = surface.triangles[t];
    sets.join(static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[1]));
    sets.join(static_cast<std::size_t>(n[0]), static_cast<std::size_t>(n[2]));
  }
  std::vector<std::int32_t> group_of_root(surface.vertices.size(), -1);
  std::vector<std::vector<std::int32_t>> groups;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_marked[t] == 0) continue;
    std::int32_t& group =
        group_of_root[sets.root(static_cast<std::size_t>(surface.triangles[t][0]))];
    if (group < 0) {
      group = static_cast<std::int32_t>(groups.size());
      groups.emplace_back();
    }
    groups[static_cast<std::size_t>(group)].push_back(static_cast<std::int32_t>(t));
  }
  return groups;
}

/// The triangles and all that share a vertex with them, sorted.
std::vector<std::int32_t> grown(const SurfaceMesh& surface,
                                const std::vector<std::int32_t>& group) {
  std::vector<char> is_of_group(surface.vertices.size(), 0);
  for (const std::int32_t t : group) {
    for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(t)]) {
      is_of_group[static_cast<std::size_t>(v)] = 1;
    }
  }
  std::vector<std::int32_t> larger;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const bool touches = std::ranges::any_of(surface.triangles[t], [&](std::int32_t v) {
      return is_of_group[static_cast<std::size_t>(v)] != 0;
    });
    if (touches) larger.push_back(static_cast<std::int32_t>(t));
  }
  return larger;
}

Vec3 middle_of(const TrianglePoints& c) { return (c[0] + c[1] + c[2]) / 3.0; }

/// Whether the corners and middles of `of` lie within `reach` of the others.
bool lies_within(const std::vector<TrianglePoints>& of, const std::vector<TrianglePoints>& others,
                 double reach) {
  const auto is_near = [&](const Vec3& p) {
    return std::ranges::any_of(others, [&](const TrianglePoints& c) {
      return distance2_to_triangle(p, c[0], c[1], c[2]) <= reach * reach;
    });
  };
  return std::ranges::all_of(of, [&](const TrianglePoints& c) {
    return is_near(c[0]) && is_near(c[1]) && is_near(c[2]) && is_near(middle_of(c));
  });
}

/// What is to come in place of some triangles.
class Replacement {
 public:
  Replacement(const HealingWork& work, std::vector<std::int32_t> group,
              const std::vector<EdgeUse>& uses, const NearTriangles& near)
      : surface_(work.surface),
        group_(std::move(group)),
        uses_(uses),
        near_(near),
        is_gone_(work.surface.triangles.size(), 0),
        reach_(work.largest_move) {
    for (const std::int32_t t : group_) is_gone_[static_cast<std::size_t>(t)] = 1;
  }

  std::optional<std::vector<Triangle>> find() const {
    const std::int32_t patch = patch_of(surface_, static_cast<std::size_t>(group_.front()));
    const bool is_one_patch = std::ranges::all_of(group_, [&](std::int32_t t) {
      return patch_of(surface_, static_cast<std::size_t>(t)) == patch;
    });
    if (!is_one_patch) return std::nullopt;
    std::vector<EdgeUse> left;
    std::ranges::copy_if(uses_, std::back_inserter(left), [&](const EdgeUse& use) {
      return is_gone_[static_cast<std::size_t>(use.triangle)] == 0;
    });
    const std::vector<BorderLoop> loops = border_loops(left);
    if (loops.size() != 1 || !borders_all(loops.front())) return std::nullopt;
    const auto made = fill_loop(
        surface_.vertices, loops.front().vertices,
        [&](std::int32_t a, std::int32_t b) { return !uses_of_edge(left, a, b).empty(); });
    if (!made || !lies_near(*made) || near_.meet(*made, is_gone_)) return std::nullopt;
    return made;
  }

 private:
  /// Whether the loop has every edge between what goes and what stays.
  bool borders_all(const BorderLoop& loop) const {
    std::vector<EdgeUse> of_group;
    std::ranges::copy_if(uses_, std::back_inserter(of_group), [&](const EdgeUse& use) {
      return is_gone_[static_cast<std::size_t>(use.triangle)] != 0;
    });
    std::size_t border = 0;
    for_each_edge(std::span<const EdgeUse>(of_group), [&](std::span<const EdgeUse> edge) {
      if (uses_of_edge(uses_, edge[0].low, edge[0].high).size() != edge.size()) ++border;
    });
    return border == loop.vertices.size();
  }

  bool lies_near(const std::vector<Triangle>& made) const {
    std::vector<TrianglePoints> before;
    std::vector<TrianglePoints> after;
    for (const std::int32_t t : group_) {
      before.push_back(points_of(surface_, static_cast<std::size_t>(t)));
    }
    for (const Triangle& t : made) after.push_back(triangle_points(surface_.vertices, t));
    return lies_within(before, after, reach_) && lies_within(after, before, reach_);
  }

  const SurfaceMesh& surface_;
  std::vector<std::int32_t> group_;
  const std::vector<EdgeUse>& uses_;
  const NearTriangles& near_;
  std::vector<char> is_gone_;
  double reach_;
};

}  // namespace

std::int64_t replace_crossings(HealingWork& work, const std::vector<char>& is_crossing) {
  SurfaceMesh& surface = work.surface;
  TF_CHECK(is_crossing.size() == surface.triangles.size());
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  const NearTriangles near(surface);
  std::vector<char> is_gone(surface.triangles.size(), 0);
  std::int64_t replaced = 0;
  for (std::vector<std::int32_t> group : connected_groups(surface, is_crossing)) {
    for (int ring = 0; ring <= most_rings; ++ring) {
      if (ring > 0) group = grown(surface, group);
      const bool is_free = std::ranges::none_of(
          group, [&](std::int32_t t) { return is_gone[static_cast<std::size_t>(t)] != 0; });
      if (!is_free) break;
      const Replacement replacement(work, group, uses, near);
      const auto made = replacement.find();
      if (!made) continue;
      const auto first = static_cast<std::size_t>(group.front());
      HealAct act{HealKind::crossing, middle_of(points_of(surface, first)), {}};
      add_triangles(surface, *made, patch_of(surface, first), act);
      for (const std::int32_t t : group) is_gone[static_cast<std::size_t>(t)] = 1;
      work.acts.push_back(std::move(act));
      ++replaced;
      break;
    }
  }
  is_gone.resize(surface.triangles.size(), 0);
  remove_triangles(surface, is_gone);
  return replaced;
}

}  // namespace tetfarm
