#include "mesh/cosmetics/altitude_improvement.h"

#include <algorithm>
#include <optional>
#include <queue>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/cosmetics/joint_climbing.h"
#include "mesh/cosmetics/quality.h"
#include "mesh/cosmetics/small_polyhedron_reconnection.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {
namespace {

/// Below 1 while a tet is too low. Where its quality nears the floor it counts as low too, at the
/// floor itself as low as the lowest was at first: no rise of the smallest measure goes below it.
struct HeightMeasure {
  static constexpr double slope = 20;
  double wanted2 = 0;
  double floor = 0;
  double lowest_at_first = 0;

  double operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return std::min(smallest_height2(a, b, c, d) / wanted2,
                    lowest_at_first + slope * (quality(a, b, c, d) - floor));
  }
  MeasurePieces pieces(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    const TetPieces tet = pieces_of(a, b, c, d);
    MeasurePieces all;
    for (std::size_t i = 0; i < 6; ++i) all[i] = lowest_at_first + slope * (tet.sines2[i] - floor);
    for (std::size_t i = 0; i < 4; ++i) all[6 + i] = tet.heights2[i] / wanted2;
    return all;
  }
  double operator()(const StarFace& face, const Vec3& p) const {
    return (*this)(face[0], face[1], face[2], p);
  }
};

/// The height that is wanted at a point, squared.
double wanted2_at(const Vec3& p, const HeightOptions& options) {
  double wanted = options.wanted_length;
  if (options.wanted_spacings > 0) {
    wanted = std::max(wanted, options.wanted_spacings * options.spacing(p));
  }
  TF_CHECK(wanted > 0);
  return wanted * wanted;
}

struct LowTet {
  double key = 0;  ///< the height squared, or what it is of the wanted one
  std::int32_t tet = -1;

  /// The lowest comes first out of a priority queue.
  friend bool operator<(const LowTet& a, const LowTet& b) {
    return a.key != b.key ? a.key > b.key : a.tet > b.tet;
  }
};

struct AltitudeImprover {
  WorkMesh& work;
  const HeightOptions& options;
  std::priority_queue<LowTet> queue;
  /// Number of changes when no better place was found for a node.
  std::vector<std::int64_t> node2settled;

  double height2_of(std::int32_t t) const {
    const auto& [a, b, c, d] = work.tet(t);
    return smallest_height2(work.point(a), work.point(b), work.point(c), work.point(d));
  }
  double share2_of(std::int32_t t) const {
    const auto& [a, b, c, d] = work.tet(t);
    const Vec3 centre = 0.25 * (work.point(a) + work.point(b) + work.point(c) + work.point(d));
    return height2_of(t) / wanted2_at(centre, options);
  }
  void queue_if_low(std::int32_t t) {
    const double share2 = share2_of(t);
    if (share2 < 1) queue.push({share2, t});
  }
};

std::optional<Place> find_higher_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                       std::int32_t node, const HeightOptions& options) {
  const Star star = star_of(work, ball, node);
  const Vec3& here = work.point(node);
  HeightMeasure measure{wanted2_at(here, options), 0, HUGE_VAL};
  const double worst = worst_at(star, here, -HUGE_VAL);
  measure.lowest_at_first = worst_at(star, here, -HUGE_VAL, measure);
  measure.floor = std::min(options.floor, worst);
  if (!(measure.lowest_at_first < 1)) return std::nullopt;
  const Place best = climb(star, here, 1, measure);
  if (!is_worth(measure.lowest_at_first, best.worst)) return std::nullopt;
  return best;
}

/// Moves the nodes of the tet; true when one of them moved.
bool raise(AltitudeImprover& improver, const LowTet& low) {
  WorkMesh& work = improver.work;
  bool moved = false;
  for (const std::int32_t node : Tet(work.tet(low.tet))) {
    std::int64_t& settled = improver.node2settled[at(node)];
    if (!work.may_move(node) || settled >= work.node2change[at(node)]) continue;
    const std::vector<std::int32_t> ball = ball_of_node(work, node);
    const auto place = is_inner(work, ball, node)
                           ? find_higher_place(work, ball, node, improver.options)
                           : std::nullopt;
    if (!place || !move_node(work, ball, node, place->point)) {
      settled = work.changes;
      continue;
    }
    for (const std::int32_t t : ball) improver.queue_if_low(t);
    moved = true;
  }
  return moved;
}

/// Moves the nodes round the tet together; the tets that were changed, or none.
std::vector<std::int32_t> raise_together(AltitudeImprover& improver, std::int32_t tet) {
  WorkMesh& work = improver.work;
  NodePatch patch = patch_round(work, tet);
  if (patch.nodes.empty()) return {};
  const Vec3& here = work.point(patch.nodes.front());
  HeightMeasure measure{wanted2_at(here, improver.options), 0, HUGE_VAL};
  measure.lowest_at_first = worst_in(patch, -HUGE_VAL, measure);
  measure.floor = std::min(improver.options.floor, worst_of(work, patch.tets));
  const double after = climb_together(patch, 1, measure);
  if (!is_worth(measure.lowest_at_first, after) || !move_patch(work, patch)) return {};
  return std::move(patch.tets);
}

/// Fills a cavity round the tet with other tets of the same nodes; those, or none.
std::vector<std::int32_t> reconnect_higher(AltitudeImprover& improver, std::int32_t tet) {
  WorkMesh& work = improver.work;
  const double wanted2 = wanted2_at(work.point(work.tet(tet)[0]), improver.options);
  ReconnectionOptions options;
  options.enough = 1;
  options.measure = HeightMeasure{wanted2, std::min(improver.options.floor, work.quality_of(tet)),
                                  improver.height2_of(tet) / wanted2};
  const auto found = find_reconnection(work, tet, options);
  return found ? replace_tets(work, *found) : std::vector<std::int32_t>{};
}

/// The squared height counts 1/2 where it is what it was, and so does that share of the worst
/// quality which is to be kept: no rise sells more.
struct TradeMeasure {
  /// Of 3, 6 and 12 the one with the largest gains.
  static constexpr double slope = 6;
  double lowest2_at_first = 0;
  double worst_at_first = 0;
  double share_kept = 1;

  double operator()(const StarFace& face, const Vec3& p) const {
    const double share = quality(face[0], face[1], face[2], p) / worst_at_first;
    return std::min(0.5 * height2(face, p) / lowest2_at_first, 0.5 + slope * (share - share_kept));
  }
  /// The cube of the angle times the height, both of what they were, squared.
  double gain(double worst, double lowest2) const {
    const double share = std::max(0.0, worst / worst_at_first);
    return share * share * share * lowest2 / lowest2_at_first;
  }
  static double height2(const StarFace& face, const Vec3& p) {
    return smallest_height2(face[0], face[1], face[2], p);
  }
};

/// A higher place for the node at some of the smallest angle round it, where the cube of that angle
/// times the smallest height gets larger: this ends, however often a place is asked for.
std::optional<Place> find_traded_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                       std::int32_t node, const HeightOptions& options) {
  const Star star = star_of(work, ball, node);
  const Vec3& here = work.point(node);
  const auto lowest2_at = [&star](const Vec3& p) {
    return worst_at(star, p, -HUGE_VAL, TradeMeasure::height2);
  };
  TradeMeasure measure{lowest2_at(here), worst_at(star, here, -HUGE_VAL)};
  const bool is_for_sale = measure.worst_at_first < options.traded_quality &&
                           measure.lowest2_at_first < wanted2_at(here, options);
  if (!is_for_sale) return std::nullopt;
  std::optional<Place> best;
  double best_gain = 1.01;
  for (const double share_kept : {0.97, 0.94, 0.91}) {
    measure.share_kept = share_kept;
    const Place place = climb(star, here, 1, measure);
    const double worst = worst_at(star, place.point, -HUGE_VAL);
    const double gain = measure.gain(worst, lowest2_at(place.point));
    if (gain <= best_gain) continue;
    best_gain = gain;
    best = place;
  }
  return best;
}

/// Buys height with angle at a node of the tet; the tets that were changed, or none.
std::vector<std::int32_t> trade_angle_for_height(AltitudeImprover& improver, std::int32_t tet) {
  WorkMesh& work = improver.work;
  for (const std::int32_t node : Tet(work.tet(tet))) {
    if (!work.may_move(node)) continue;
    std::vector<std::int32_t> ball = ball_of_node(work, node);
    if (!is_inner(work, ball, node)) continue;
    bool moved = false;
    while (const auto place = find_traded_place(work, ball, node, improver.options)) {
      if (!move_node(work, ball, node, place->point)) break;
      moved = true;
    }
    if (moved) return ball;
  }
  return {};
}

/// What no node could raise by itself is raised by neighbours together or by other tets of the same
/// nodes, or else for some of the angle, lowest first whatever is wanted there.
void raise_lowest_together(AltitudeImprover& improver) {
  std::priority_queue<LowTet> queue;
  const auto queue_if_low = [&](std::int32_t t) {
    if (improver.share2_of(t) < 1) queue.push({improver.height2_of(t), t});
  };
  const auto tets = static_cast<std::int32_t>(improver.work.complex.nodes.size());
  for (std::int32_t t = 0; t < tets; ++t) {
    if (improver.work.complex.is_live(t)) queue_if_low(t);
  }
  std::int64_t failures = 0;
  while (!queue.empty() && failures < improver.options.most_joint_failures) {
    const LowTet low = queue.top();
    queue.pop();
    const bool is_current =
        improver.work.complex.is_live(low.tet) && improver.height2_of(low.tet) == low.key;
    if (!is_current) continue;
    std::vector<std::int32_t> changed = raise_together(improver, low.tet);
    if (changed.empty()) changed = reconnect_higher(improver, low.tet);
    if (changed.empty()) changed = trade_angle_for_height(improver, low.tet);
    if (changed.empty()) ++failures;
    for (const std::int32_t t : changed) queue_if_low(t);
  }
}

}  // namespace

double smallest_height2(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const Vec3 normal_b = cross(ad, ac);
  const Vec3 normal_c = cross(ab, ad);
  const Vec3 normal_d = cross(ac, ab);
  const double volume6 = -dot(normal_d, ad);
  if (!(volume6 > 0)) return 0;
  const double largest = std::max(std::max(norm2(normal_b + normal_c + normal_d), norm2(normal_b)),
                                  std::max(norm2(normal_c), norm2(normal_d)));
  return volume6 * volume6 / largest;
}

std::int64_t improve_altitudes(WorkMesh& work, const HeightOptions& options) {
  AltitudeImprover improver{
      work, options, {}, std::vector<std::int64_t>(work.node2change.size(), -1)};
  for (std::size_t t = 0; t < work.complex.nodes.size(); ++t) {
    const auto tet = static_cast<std::int32_t>(t);
    if (!work.complex.is_live(tet)) continue;
    if (options.is_high_at_first && options.is_high_at_first(tet) && work.is_untouched(tet)) {
      continue;
    }
    improver.queue_if_low(tet);
  }
  const std::int64_t before = work.changes;
  std::int64_t stuck = 0;
  while (!improver.queue.empty() && stuck < options.most_stuck) {
    const LowTet low = improver.queue.top();
    improver.queue.pop();
    if (improver.share2_of(low.tet) != low.key) continue;
    if (!raise(improver, low)) ++stuck;
  }
  if (options.most_joint_failures > 0) raise_lowest_together(improver);
  return work.changes - before;
}

}  // namespace tetfarm::cosmetics
