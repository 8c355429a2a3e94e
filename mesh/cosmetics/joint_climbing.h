/// Joint climbing: moves neighbouring nodes at once so that the smallest of a measure over all
/// their tets gets larger, where no node can do so by itself.
///
/// Source: none in the thesis; the ascent of L. A. Freitag, M. Jones and P. Plassmann (1999, see
/// climbing.h) in the coordinates of several nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

/// Inner nodes that may move together, and every tet that holds one of them.
struct NodePatch {
  std::vector<std::int32_t> nodes;
  std::vector<std::int32_t> tets;
  /// The places of all nodes of the tets: those of `nodes` first, in their order.
  std::vector<Vec3> points;
  /// The tets in numbers of `points`.
  std::vector<Tet> corners;

  bool moves(std::int32_t local) const { return local < std::ssize(nodes); }
};

/// The inner nodes of tet t and the inner nodes next to them, 32 at most; no nodes when t has none.
/// Cost: that of some 40 balls of nodes.
NodePatch patch_round(WorkMesh& work, std::int32_t t);

/// A tet's six sines of dihedral angles, squared and with the sign of its volume, and its four
/// heights, squared: smooth where the smallest of them are not.
struct TetPieces {
  std::array<double, 6> sines2;
  std::array<double, 4> heights2;
};
TetPieces pieces_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// As many as a measure may have of a tet; those that it does not look at are infinite.
using MeasurePieces = std::array<double, 10>;

/// What is to become larger: the smallest of ten smooth numbers for a tet, each at most about 1.
template <typename T>
concept TetMeasure = requires(const T& measure, const Vec3& p) {
  { measure(p, p, p, p) } -> std::convertible_to<double>;
  { measure.pieces(p, p, p, p) } -> std::same_as<MeasurePieces>;
};

/// The quality, as long as no tet gets lower than a height: that counts as the worst quality at
/// first, and no rise of the smallest measure above it leaves a lower tet.
struct GuardedQuality {
  static constexpr double slope = 0.2;
  double worst_at_first = 0;
  double least_height2 = 0;

  double of_height(double height2) const {
    return worst_at_first + slope * (height2 / least_height2 - 1);
  }
  double operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const;
  MeasurePieces pieces(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const;
};

/// The slope of a piece of a tet's measure at the corners that move; the others have the node -1.
struct TetSlope {
  std::array<std::int32_t, 4> nodes = {-1, -1, -1, -1};
  std::array<Vec3, 4> slopes;
};

/// The shortest vector in the convex hull of the slopes (Gilbert's iteration), scaled to a length
/// of 1 at the node that moves most; no nodes where it vanishes.
std::vector<Vec3> direction_up(const std::vector<TetSlope>& slopes, std::size_t nodes);

/// The shortest edge of the patch.
double shortest_edge(const NodePatch& patch);

template <TetMeasure M>
double measure_of(const NodePatch& patch, const Tet& tet, const M& measure) {
  const auto at = [&patch](std::int32_t v) { return patch.points[static_cast<std::size_t>(v)]; };
  return measure(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3]));
}

/// The smallest measure of the patch; any value below `least` once it is below.
template <TetMeasure M>
double worst_in(const NodePatch& patch, double least, const M& measure) {
  double worst = HUGE_VAL;
  for (const Tet& tet : patch.corners) {
    worst = std::min<double>(worst, measure_of(patch, tet, measure));
    if (worst < least) break;
  }
  return worst;
}

/// Adds the slopes of the pieces of a tet that are below.
template <TetMeasure M>
void add_slopes(NodePatch& patch, const Tet& tet, double below, double step, const M& measure,
                std::vector<TetSlope>& slopes) {
  const auto pieces = [&] {
    const auto at = [&patch](std::int32_t v) { return patch.points[static_cast<std::size_t>(v)]; };
    return measure.pieces(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3]));
  };
  const MeasurePieces here = pieces();
  std::array<TetSlope, 10> of_piece;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!patch.moves(tet[i])) continue;
    Vec3& p = patch.points[static_cast<std::size_t>(tet[i])];
    const Vec3 at_rest = p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] += step;
      const MeasurePieces there = pieces();
      p = at_rest;
      for (std::size_t k = 0; k < here.size(); ++k) {
        of_piece[k].nodes[i] = tet[i];
        of_piece[k].slopes[i][axis] = (there[k] - here[k]) / step;
      }
    }
  }
  for (std::size_t k = 0; k < here.size(); ++k) {
    if (here[k] <= below) slopes.push_back(of_piece[k]);
  }
}

/// The slopes of all pieces that are nearly the worst, within that share of it.
template <TetMeasure M>
std::vector<TetSlope> active_slopes(NodePatch& patch, double worst, double within, double step,
                                    const M& measure) {
  constexpr std::size_t most_active = 48;
  const double below = worst + within * std::max(std::fabs(worst), 0.05);
  std::vector<TetSlope> slopes;
  for (const Tet& tet : patch.corners) {
    if (measure_of(patch, tet, measure) > below) continue;
    add_slopes(patch, tet, below, step, measure, slopes);
    if (slopes.size() >= most_active) break;
  }
  return slopes;
}

/// Moves the points of the patch along the direction as far as the worst gets larger; that worst,
/// or nothing. The step is that of the node that moves most, and is halved until it helps.
template <TetMeasure M>
std::optional<double> step_up(NodePatch& patch, const std::vector<Vec3>& up, double before,
                              double& step, const M& measure) {
  constexpr int most_halvings = 6;
  const std::vector<Vec3> from(patch.points.begin(), patch.points.begin() + std::ssize(up));
  for (int halving = 0; halving < most_halvings; ++halving) {
    for (std::size_t i = 0; i < up.size(); ++i) patch.points[i] = from[i] + step * up[i];
    const double worst = worst_in(patch, before, measure);
    if (worst > before) return worst;
    step *= 0.5;
  }
  std::copy(from.begin(), from.end(), patch.points.begin());
  return std::nullopt;
}

/// Climbs until the worst is `enough`, or no more progress is made; the worst then. The points of
/// the patch are where they came to. First all pieces within a tenth of the worst are heeded; fewer
/// leave a direction more often, for a shorter way.
/// Cost: at most some 200 measures a tet, of which a patch has 40 to 300.
template <TetMeasure M>
double climb_together(NodePatch& patch, double enough, const M& measure) {
  constexpr int most_climbs = 40;
  constexpr double narrowest = 2e-3;
  const double length = shortest_edge(patch);
  double worst = worst_in(patch, -HUGE_VAL, measure);
  double within = 0.1;
  double step = 0.1 * length;
  for (int i = 0; i < most_climbs && worst < enough && within > narrowest; ++i) {
    const auto slopes = active_slopes(patch, worst, within, 1e-6 * length, measure);
    const std::vector<Vec3> up = direction_up(slopes, patch.nodes.size());
    const auto now = up.empty() ? std::nullopt : step_up(patch, up, worst, step, measure);
    if (!now || *now <= worst + 1e-3 * std::fabs(worst)) {
      within *= 0.3;
      step = std::max(step, 0.01 * length);
    }
    if (!now) continue;
    worst = *now;
    step *= 2;
  }
  return worst;
}

/// Moves the nodes of the patch to its points unless a tet would not be exactly positive; false
/// then.
bool move_patch(WorkMesh& work, const NodePatch& patch);

/// Moves the nodes round tet t together so that the worst quality round them rises by the margin,
/// to `enough` at most; the tets that were changed, or none.
std::vector<std::int32_t> improve_together(WorkMesh& work, std::int32_t t, double enough);

}  // namespace tetfarm::cosmetics
