#include "mesh/arrangement/snap_rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/array_index.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

constexpr int most_passes = 100;

class SnapRounding {
 public:
  SnapRounding(std::vector<Vec3>& points, const std::vector<SnapEdge>& edges, int axis,
               double distance)
      : points_(points), axis_(axis), distance_(distance) {
    for (const SnapEdge& edge : edges) {
      chains_.push_back({edge[0], edge[1]});
      nodes_.push_back(edge[0]);
      nodes_.push_back(edge[1]);
    }
    std::ranges::sort(nodes_);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  }

  bool run() {
    for (int pass = 0; pass < most_passes; ++pass) {
      gather_pieces();
      if (!lead_through_nodes() && !divide_at_crossings()) return true;
    }
    return false;
  }

  std::vector<std::vector<std::int32_t>> chains() && { return std::move(chains_); }

 private:
  struct Piece {
    std::int32_t from;
    std::int32_t to;
    std::size_t chain;
    std::size_t place;  ///< of `from` in the chain
  };

  Vec2 seen(std::int32_t node) const {
    const Vec3& p = points_[at(node)];
    return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]};
  }

  Box3 box_of(std::int32_t a, std::int32_t b) const {
    Box3 box;
    for (const std::int32_t node : {a, b}) {
      const Vec2 p = seen(node);
      box.add(Vec3{p.x - distance_, p.y - distance_, 0});
      box.add(Vec3{p.x + distance_, p.y + distance_, 0});
    }
    return box;
  }

  void gather_pieces() {
    pieces_.clear();
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      for (std::size_t i = 1; i < chains_[c].size(); ++i) {
        pieces_.push_back({chains_[c][i - 1], chains_[c][i], c, i - 1});
      }
    }
  }

  /// The share of a piece at which a node is near its inside.
  std::optional<double> place_near(const Piece& piece, std::int32_t node) const {
    const Vec2 a = seen(piece.from);
    const Vec2 b = seen(piece.to);
    const Vec2 p = seen(node);
    const Vec2 along{b.x - a.x, b.y - a.y};
    const double length2 = along.x * along.x + along.y * along.y;
    if (!(length2 > 0)) return std::nullopt;
    const double share = ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / length2;
    if (!(share > 0 && share < 1)) return std::nullopt;
    const double off = (p.x - a.x) * along.y - (p.y - a.y) * along.x;
    if (off * off > distance_ * distance_ * length2) return std::nullopt;
    return share;
  }

  bool lead_through_nodes() {
    std::vector<Box3> boxes;
    for (const std::int32_t node : nodes_) {
      const Vec2 p = seen(node);
      Box3 box;
      box.add(Vec3{p.x, p.y, 0});
      boxes.push_back(box);
    }
    const BoxTree tree(boxes);
    using OnPiece = std::pair<double, std::int32_t>;
    std::vector<std::vector<OnPiece>> on(pieces_.size());
    bool found = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      const std::vector<std::int32_t>& chain = chains_[piece.chain];
      tree.query(box_of(piece.from, piece.to), [&](std::int32_t n) {
        const std::int32_t node = nodes_[at(n)];
        if (std::ranges::find(chain, node) != chain.end()) return;
        if (const auto share = place_near(piece, node)) on[i].emplace_back(*share, node);
      });
      std::ranges::sort(on[i]);
      found = found || !on[i].empty();
    }
    if (!found) return false;
    for (std::size_t i = pieces_.size(); i-- > 0;) {
      std::vector<std::int32_t>& chain = chains_[pieces_[i].chain];
      auto place = chain.begin() + static_cast<std::ptrdiff_t>(pieces_[i].place) + 1;
      for (const auto& [share, node] : on[i]) {
        if (std::ranges::find(chain, node) != chain.end()) continue;
        place = chain.insert(place, node) + 1;
      }
    }
    return true;
  }

  bool do_cross(const Piece& p, const Piece& q) const {
    if (p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to) return false;
    const Vec2 a = seen(p.from);
    const Vec2 b = seen(p.to);
    const Vec2 c = seen(q.from);
    const Vec2 d = seen(q.to);
    const auto differ = [](double x, double y) { return (x > 0 && y < 0) || (x < 0 && y > 0); };
    return differ(orient2d(a, b, c), orient2d(a, b, d)) &&
           differ(orient2d(c, d, a), orient2d(c, d, b));
  }

  /// Each piece once in a pass.
  bool divide_at_crossings() {
    std::vector<Box3> boxes;
    for (const Piece& piece : pieces_) boxes.push_back(box_of(piece.from, piece.to));
    const BoxTree tree(boxes);
    std::vector<SnapEdge> crossing;
    tree.self_pairs([&](std::int32_t i, std::int32_t j) {
      if (do_cross(pieces_[at(i)], pieces_[at(j)])) crossing.push_back({i, j});
    });
    std::ranges::sort(crossing);
    std::vector<std::int32_t> node_in(pieces_.size(), -1);
    for (const auto& [i, j] : crossing) {
      if (node_in[at(i)] >= 0 || node_in[at(j)] >= 0) continue;
      node_in[at(i)] = node_in[at(j)] = add_crossing(pieces_[at(i)], pieces_[at(j)]);
    }
    for (std::size_t i = pieces_.size(); i-- > 0;) {
      if (node_in[i] < 0) continue;
      std::vector<std::int32_t>& chain = chains_[pieces_[i].chain];
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(pieces_[i].place) + 1, node_in[i]);
    }
    return !crossing.empty();
  }

  std::int32_t add_crossing(const Piece& p, const Piece& q) {
    const Vec2 a = seen(p.from);
    const Vec2 b = seen(p.to);
    const Vec2 c = seen(q.from);
    const Vec2 d = seen(q.to);
    const double at_a = orient2d(c, d, a);
    const double at_c = orient2d(a, b, c);
    const double share = at_a / (at_a - orient2d(c, d, b));
    const double other = at_c / (at_c - orient2d(a, b, d));
    const auto between = [&](std::int32_t from, std::int32_t to, double s) {
      return points_[at(from)] + s * (points_[at(to)] - points_[at(from)]);
    };
    points_.push_back(0.5 * (between(p.from, p.to, share) + between(q.from, q.to, other)));
    nodes_.push_back(static_cast<std::int32_t>(points_.size()) - 1);
    return nodes_.back();
  }

  std::vector<Vec3>& points_;
  int axis_;
  double distance_;
  std::vector<std::int32_t> nodes_;
  std::vector<std::vector<std::int32_t>> chains_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::optional<std::vector<std::vector<std::int32_t>>> snap_round(std::vector<Vec3>& points,
                                                                 const std::vector<SnapEdge>& edges,
                                                                 int axis, double distance) {
  SnapRounding rounding(points, edges, axis, distance);
  if (!rounding.run()) return std::nullopt;
  return std::move(rounding).chains();
}

}  // namespace tetfarm
