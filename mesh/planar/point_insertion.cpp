#include "mesh/planar/point_insertion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/planar/restricted_cavity.h"

namespace tetfarm {
namespace {

double distance2(const Vec2& a, const Vec2& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

double cross(const Vec2& o, const Vec2& a, const Vec2& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

constexpr double inverse_sqrt3 = 0.57735026918962576;
/// A triangle is small enough when circumradius / spacing is below this (0.577 is the regular one).
constexpr double largest_radius = 0.77;
/// New points keep this much of the spacing from all nodes…
constexpr double node_clearance = 0.65;
/// …and this much of the spacing, or of the edge, whichever is less, from boundary edges.
constexpr double edge_clearance = 0.5;
/// On a boundary edge much longer than the spacing no apex is lower than this much of the edge:
/// such an edge cannot be split, and a flatter triangle would be worse than one that is too large.
constexpr double least_height = 0.2;
/// A boundary node's spacing is at most this much of the mean of its edges, so that short edges fan
/// out gently to the spacing instead of ending in needles…
constexpr double over_mean_edge = 1.2;
/// …by this factor from layer to layer.
constexpr double layer_growth = 1.35;
/// The distance wanted grows by no more than this from the edge that a candidate stands on.
constexpr double growth = 1.5;

class PointInsertion {
 public:
  PointInsertion(TriangleComplex& complex, const PlanarSpacing& spacing)
      : complex_(complex), spacing_(spacing) {
    for (const Vec2& p : complex.points) spacing_at_.push_back(spacing(p));
    limit_by_edges();
  }

  bool run(std::int64_t max_triangles) {
    state_.resize(complex_.triangles.size());
    for (std::int32_t t = 0; t < complex_.size(); ++t) state_[at(t)] = judge(t);
    for (std::int32_t t = 0; t < complex_.size(); ++t)
      if (state_[at(t)] == State::large && is_at_front(t)) enqueue(t);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const Waiting w = queue_[head];
      const bool is_stale =
          complex_.nodes(w.triangle) != w.nodes || state_[at(w.triangle)] != State::large;
      if (!is_stale) advance(w.triangle);
      if (complex_.size() > max_triangles) return false;
      drop_done_entries(head);
    }
    return true;
  }

 private:
  enum class State : std::uint8_t { large, fitting, full };
  struct Waiting {
    std::int32_t triangle;
    TriangleComplex::Nodes nodes;
  };

  void limit_by_edges() {
    std::vector<double> length(complex_.points.size(), 0);
    std::vector<int> count(complex_.points.size(), 0);
    for (std::int32_t t = 0; t < complex_.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (!complex_.is_constrained(t, i)) continue;
        const std::int32_t a = complex_.node(t, next(i));
        const std::int32_t b = complex_.node(t, previous(i));
        const double edge = std::sqrt(distance2(complex_.point(a), complex_.point(b)));
        for (const std::int32_t v : {a, b}) {
          length[at(v)] += edge;
          ++count[at(v)];
        }
      }
    }
    for (std::size_t v = 0; v < length.size(); ++v)
      if (count[v] > 0)
        spacing_at_[v] = std::min(spacing_at_[v], over_mean_edge * length[v] / count[v]);
  }

  State judge(std::int32_t t) const {
    const auto& [a, b, c] = complex_.nodes(t);
    const Vec2& pa = complex_.point(a);
    const Vec2& pb = complex_.point(b);
    const Vec2& pc = complex_.point(c);
    const double area2 = cross(pa, pb, pc);
    const double radius2 =
        distance2(pa, pb) * distance2(pb, pc) * distance2(pc, pa) / (4 * area2 * area2);
    const double mean = (spacing_at_[at(a)] + spacing_at_[at(b)] + spacing_at_[at(c)]) / 3;
    const auto is_small = [&](double h) {
      return radius2 <= largest_radius * largest_radius * h * h;
    };
    if (!is_small(mean)) return State::large;
    const Vec2 centre{(pa.x + pb.x + pc.x) / 3, (pa.y + pb.y + pc.y) / 3};
    return is_small(spacing_(centre)) ? State::fitting : State::large;
  }

  bool is_front_edge(std::int32_t t, int i) const {
    return complex_.is_constrained(t, i) ||
           state_[at(triangle_of(complex_.neighbour(t, i)))] != State::large;
  }
  bool is_at_front(std::int32_t t) const {
    return is_front_edge(t, 0) || is_front_edge(t, 1) || is_front_edge(t, 2);
  }

  void enqueue(std::int32_t t) { queue_.push_back({t, complex_.nodes(t)}); }

  void drop_done_entries(std::size_t& head) {
    constexpr std::size_t block = 1U << 16U;
    if (head < block || 2 * head < queue_.size()) return;
    queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(head));
    head = 0;
  }

  /// Tries the front edges of the triangle, shortest first, until one gives a point.
  void advance(std::int32_t t) {
    std::array<std::pair<double, int>, 3> edges;
    int count = 0;
    for (int i = 0; i < 3; ++i)
      if (is_front_edge(t, i))
        edges[static_cast<std::size_t>(count++)] = {
            distance2(complex_.point(complex_.node(t, next(i))),
                      complex_.point(complex_.node(t, previous(i)))),
            i};
    std::sort(edges.begin(), edges.begin() + count);
    for (int k = 0; k < count; ++k) {
      const int i = edges[static_cast<std::size_t>(k)].second;
      const std::optional<Vec2> p = candidate(t, i);
      const double near = (spacing_at_[at(complex_.node(t, next(i)))] +
                           spacing_at_[at(complex_.node(t, previous(i)))]) /
                          2;
      if (p && insert(t, *p, near)) return;
    }
    if (insert_on_longest_edge(t)) return;
    state_[at(t)] = State::full;
    wake_neighbours(t, false);
  }

  /// The apex over the edge that makes a regular triangle of the spacing, but no farther than the
  /// circumcentre: so that no other node is nearer to it than the edge's.
  std::optional<Vec2> candidate(std::int32_t t, int i) const {
    const std::int32_t a = complex_.node(t, next(i));
    const std::int32_t b = complex_.node(t, previous(i));
    const Vec2& pa = complex_.point(a);
    const Vec2& pb = complex_.point(b);
    const Vec2& pc = complex_.point(complex_.node(t, i));
    const double length = std::sqrt(distance2(pa, pb));
    const double half = length / 2;
    const double h = std::min((spacing_at_[at(a)] + spacing_at_[at(b)]) / 2, growth * length);
    const double radius = std::max(h * inverse_sqrt3, half);
    const double wanted = radius + std::sqrt(std::max(0.0, radius * radius - half * half));
    const double dot = (pa.x - pc.x) * (pb.x - pc.x) + (pa.y - pc.y) * (pb.y - pc.y);
    const double to_centre = half * dot / cross(pa, pb, pc);
    const double height = std::min(wanted, to_centre);
    if (!(height > 0.5 * half)) return std::nullopt;
    const double scale = height / length;
    return Vec2{(pa.x + pb.x) / 2 - scale * (pb.y - pa.y),
                (pa.y + pb.y) / 2 + scale * (pb.x - pa.x)};
  }

  bool has_room(const Vec2& p, double h) const {
    for (const Cavity::RimEdge& edge : cavity_.rim) {
      const Vec2& from = complex_.point(edge.from);
      const Vec2& to = complex_.point(edge.to);
      if (distance2(p, from) < node_clearance * node_clearance * h * h) return false;
      if (!edge.is_constrained) continue;
      const double length2 = distance2(from, to);
      const double height = cross(from, to, p);
      const double wanted2 = std::max(edge_clearance * edge_clearance * std::min(h * h, length2),
                                      least_height * least_height * length2);
      if (height * height < wanted2 * length2) return false;
    }
    return true;
  }

  /// For what no front edge can fill: large obtuse triangles on long boundary edges.
  bool insert_on_longest_edge(std::int32_t t) {
    double longest2 = 0;
    int edge = -1;
    for (int i = 0; i < 3; ++i) {
      if (complex_.is_constrained(t, i)) continue;
      const double length2 = distance2(complex_.point(complex_.node(t, next(i))),
                                       complex_.point(complex_.node(t, previous(i))));
      if (length2 > longest2) {
        longest2 = length2;
        edge = i;
      }
    }
    if (edge < 0) return false;
    const std::int32_t a = complex_.node(t, next(edge));
    const std::int32_t b = complex_.node(t, previous(edge));
    const double near = (spacing_at_[at(a)] + spacing_at_[at(b)]) / 2;
    if (longest2 < 4 * node_clearance * node_clearance * near * near) return false;
    const Vec2& pa = complex_.point(a);
    const Vec2& pb = complex_.point(b);
    return insert(t, {(pa.x + pb.x) / 2, (pa.y + pb.y) / 2}, near);
  }

  /// `near`: the spacing of the nodes that the point was placed from.
  bool insert(std::int32_t t, const Vec2& p, double near) {
    const std::optional<std::int32_t> holder = locate(complex_, t, p);
    if (!holder || !find_cavity(complex_, *holder, p, cavity_)) return false;
    const double h = std::min(spacing_(p), layer_growth * near);
    if (!(h > 0)) return false;
    double clear = h;
    for (const std::int32_t v : complex_.nodes(t)) clear = std::min(clear, spacing_at_[at(v)]);
    if (!has_room(p, clear)) return false;
    fill_cavity(complex_, p, cavity_);
    TF_CHECK(spacing_at_.size() + 1 == complex_.points.size());
    spacing_at_.push_back(h);
    state_.resize(complex_.triangles.size(), State::large);
    for (const std::int32_t fresh : cavity_.triangles) state_[at(fresh)] = judge(fresh);
    for (const std::int32_t fresh : cavity_.triangles) {
      if (state_[at(fresh)] == State::fitting) {
        wake_neighbours(fresh, true);
      } else if (is_at_front(fresh)) {
        enqueue(fresh);
      }
    }
    return true;
  }

  /// Puts the large triangles next to t on the queue; `again`: those given up before, too.
  void wake_neighbours(std::int32_t t, bool again) {
    for (int i = 0; i < 3; ++i) {
      if (complex_.is_constrained(t, i)) continue;
      const std::int32_t u = triangle_of(complex_.neighbour(t, i));
      State& state = state_[at(u)];
      if (again && state == State::full) state = State::large;
      if (state == State::large) enqueue(u);
    }
  }

  TriangleComplex& complex_;
  const PlanarSpacing& spacing_;
  std::vector<double> spacing_at_;
  std::vector<State> state_;
  std::vector<Waiting> queue_;
  Cavity cavity_;
};

/// Area over spacing squared, by cutting the triangle in four until it is small or deep.
double area_per_h2(const Vec2& a, const Vec2& b, const Vec2& c, const PlanarSpacing& spacing,
                   int depth) {
  const double area = std::abs(cross(a, b, c)) / 2;
  const Vec2 centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  const double h = spacing(centre);
  if (depth == 0 || area < 4 * h * h) return area / (h * h);
  const auto middle = [](const Vec2& p, const Vec2& q) {
    return Vec2{(p.x + q.x) / 2, (p.y + q.y) / 2};
  };
  const Vec2 ab = middle(a, b);
  const Vec2 bc = middle(b, c);
  const Vec2 ca = middle(c, a);
  return area_per_h2(a, ab, ca, spacing, depth - 1) + area_per_h2(ab, b, bc, spacing, depth - 1) +
         area_per_h2(ca, bc, c, spacing, depth - 1) + area_per_h2(ab, bc, ca, spacing, depth - 1);
}

}  // namespace

bool insert_points(TriangleComplex& complex, const PlanarSpacing& spacing,
                   std::int64_t max_triangles) {
  return PointInsertion(complex, spacing).run(max_triangles);
}

double estimated_triangles(const TriangleComplex& complex, const PlanarSpacing& spacing) {
  constexpr double regular_area = 0.43301270189221932;
  constexpr std::size_t samples = 8192;
  int depth = 0;
  while (depth < 4 && complex.triangles.size() << (2 * depth + 2) <= samples) ++depth;
  double sum = 0;
  for (const auto& [a, b, c] : complex.triangles)
    sum += area_per_h2(complex.point(a), complex.point(b), complex.point(c), spacing, depth);
  return sum / regular_area;
}

}  // namespace tetfarm
