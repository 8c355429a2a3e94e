#include "mesh/cosmetics/element_homes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

using SortedTet = std::array<std::int32_t, 4>;

SortedTet sorted_tet(Tet tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

/// Where the tets lay before they were worked on.
class OldTets {
 public:
  /// @pre `now` has at least as many places for tets as `before` has tets.
  OldTets(const TetMesh& before, const std::vector<ElementHome>& homes, const TetComplex& now)
      : mesh_(before), homes_(homes), now_(now), is_in_place_(before.tets.size(), false) {
    TF_CHECK(homes.size() == before.tets.size() && now.nodes.size() >= before.tets.size());
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      is_in_place_[t] = sorted_tet(mesh_.tets[t]) == sorted_tet(now_.nodes[t]);
      if (is_in_place_[t]) continue;
      by_nodes_.emplace_back(sorted_tet(mesh_.tets[t]), static_cast<std::int32_t>(t));
    }
    std::sort(by_nodes_.begin(), by_nodes_.end());
    is_there_ = is_in_place_;
  }

  /// The home of the tet that had the same nodes: most tets are where they were. `t` is its number
  /// now.
  std::optional<ElementHome> home_of_same(std::size_t t) {
    if (t < mesh_.tets.size() && is_in_place_[t]) return homes_[t];
    const Tet& tet = now_.nodes[t];
    const SortedTet nodes = sorted_tet(tet);
    const auto found = std::lower_bound(
        by_nodes_.begin(), by_nodes_.end(), nodes,
        [](const auto& item, const SortedTet& wanted) { return item.first < wanted; });
    if (found == by_nodes_.end() || found->first != nodes) return std::nullopt;
    is_there_[at(found->second)] = true;
    return homes_[at(found->second)];
  }

  /// The home of the tet that held the point; where rounding leaves doubt, of the one that comes
  /// nearest to holding it. Only tets that are gone or have moved can have held it.
  /// @pre home_of_same was asked for every tet that there is now.
  ElementHome home_at(const Vec3& p) {
    if (tree_.size() == 0) build_tree();
    Box3 box;
    box.add(p);
    std::int32_t best = -1;
    double best_inside = -HUGE_VAL;
    tree_.query(box, [&](std::int32_t i) {
      const std::int32_t t = changed_[at(i)];
      const double inside = how_far_inside(t, p);
      if (inside > best_inside || (inside == best_inside && t < best)) {
        best = t;
        best_inside = inside;
      }
    });
    TF_CHECK(best >= 0 || !changed_.empty());
    return homes_[at(best < 0 ? changed_.front() : best)];
  }

 private:
  bool has_changed(std::size_t t) const {
    if (!is_there_[t]) return true;
    const Tet& tet = mesh_.tets[t];
    return std::any_of(tet.begin(), tet.end(), [this](std::int32_t v) {
      return !(mesh_.nodes[at(v)] == now_.points[at(v)]);
    });
  }

  void build_tree() {
    std::vector<Box3> boxes;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      if (!has_changed(t)) continue;
      changed_.push_back(static_cast<std::int32_t>(t));
      Box3& box = boxes.emplace_back();
      for (const std::int32_t v : mesh_.tets[t]) box.add(mesh_.nodes[at(v)]);
    }
    tree_ = BoxTree(boxes);
  }

  /// The smallest barycentric coordinate of p, times the volume: negative outside.
  double how_far_inside(std::int32_t t, const Vec3& p) const {
    const Tet& tet = mesh_.tets[at(t)];
    double least = HUGE_VAL;
    for (std::size_t face = 0; face < 4; ++face) {
      const auto node = [&](std::size_t i) {
        return mesh_.nodes[at(tet[at(tet_face_nodes[face][i])])];
      };
      least = std::min(least, orient3d(node(0), node(2), node(1), p));
    }
    return least;
  }

  const TetMesh& mesh_;
  const std::vector<ElementHome>& homes_;
  const TetComplex& now_;
  std::vector<bool> is_in_place_;  ///< its nodes are those of the tet with its number now
  std::vector<bool> is_there_;     ///< there is a tet with its nodes now, in whatever place
  std::vector<std::pair<SortedTet, std::int32_t>> by_nodes_;
  std::vector<std::int32_t> changed_;
  BoxTree tree_;
};

Vec3 centroid_of(const TetComplex& complex, const Tet& tet) {
  Vec3 sum;
  for (const std::int32_t v : tet) sum += complex.points[at(v)];
  return 0.25 * sum;
}

}  // namespace

std::vector<ElementHome> find_homes(const TetMesh& before,
                                    const std::vector<ElementHome>& homes_before,
                                    const TetComplex& now) {
  OldTets old(before, homes_before, now);
  std::vector<std::optional<ElementHome>> same;
  for (std::size_t t = 0; t < now.nodes.size(); ++t) {
    if (now.nodes[t][0] >= 0) same.push_back(old.home_of_same(t));
  }
  std::vector<ElementHome> homes;
  for (const Tet& tet : now.nodes) {
    if (tet[0] < 0) continue;
    const std::optional<ElementHome>& known = same[homes.size()];
    homes.push_back(known ? *known : old.home_at(centroid_of(now, tet)));
  }
  TF_CHECK(homes.size() == now.live_tets());
  return homes;
}

}  // namespace tetfarm
