#include "mesh/cosmetics/joint_climbing.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {
namespace {

bool has(const std::vector<std::int32_t>& list, std::int32_t item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

/// The tets of the balls, each once, in the order of the nodes.
std::vector<std::int32_t> tets_round(const std::vector<std::vector<std::int32_t>>& balls) {
  std::vector<std::int32_t> tets;
  for (const auto& ball : balls) tets.insert(tets.end(), ball.begin(), ball.end());
  std::sort(tets.begin(), tets.end());
  tets.erase(std::unique(tets.begin(), tets.end()), tets.end());
  return tets;
}

/// Gives the patch its points and corners.
void number_corners(const WorkMesh& work, NodePatch& patch) {
  std::vector<std::int32_t> numbered = patch.nodes;
  for (const std::int32_t t : patch.tets) {
    Tet tet = work.tet(t);
    for (std::int32_t& v : tet) {
      auto place = std::find(numbered.begin(), numbered.end(), v);
      if (place == numbered.end()) place = numbered.insert(numbered.end(), v);
      v = static_cast<std::int32_t>(place - numbered.begin());
    }
    patch.corners.push_back(tet);
  }
  for (const std::int32_t v : numbered) patch.points.push_back(work.point(v));
}

double dot(const TetSlope& slope, const std::vector<Vec3>& vector) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (slope.nodes[i] >= 0) sum += tetfarm::dot(slope.slopes[i], vector[at(slope.nodes[i])]);
  }
  return sum;
}

double norm2(const std::vector<Vec3>& vector) {
  double sum = 0;
  for (const Vec3& v : vector) sum += tetfarm::norm2(v);
  return sum;
}

std::vector<Vec3> dense(const TetSlope& slope, std::size_t nodes) {
  std::vector<Vec3> vector(nodes);
  for (std::size_t i = 0; i < 4; ++i) {
    if (slope.nodes[i] >= 0) vector[at(slope.nodes[i])] = slope.slopes[i];
  }
  return vector;
}

GuardedQuality guard(const NodePatch& patch, double worst) {
  double lowest2 = HUGE_VAL;
  for (const auto& [a, b, c, d] : patch.corners) {
    lowest2 = std::min(lowest2, smallest_height2(patch.points[at(a)], patch.points[at(b)],
                                                 patch.points[at(c)], patch.points[at(d)]));
  }
  return {worst, lowest2};
}

}  // namespace

double GuardedQuality::operator()(const Vec3& a, const Vec3& b, const Vec3& c,
                                  const Vec3& d) const {
  return std::min(quality(a, b, c, d), of_height(smallest_height2(a, b, c, d)));
}

MeasurePieces GuardedQuality::pieces(const Vec3& a, const Vec3& b, const Vec3& c,
                                     const Vec3& d) const {
  const TetPieces tet = pieces_of(a, b, c, d);
  MeasurePieces all;
  std::copy(tet.sines2.begin(), tet.sines2.end(), all.begin());
  for (std::size_t i = 0; i < 4; ++i) all[6 + i] = of_height(tet.heights2[i]);
  return all;
}

NodePatch patch_round(WorkMesh& work, std::int32_t t) {
  constexpr std::size_t most = 32;
  NodePatch patch;
  std::vector<std::vector<std::int32_t>> balls;
  std::vector<std::int32_t> seen;
  const auto take_inner = [&](const Tet& tet) {
    for (const std::int32_t v : tet) {
      if (patch.nodes.size() == most || !work.may_move(v) || has(seen, v)) continue;
      seen.push_back(v);
      std::vector<std::int32_t> ball = ball_of_node(work, v);
      if (!is_inner(work, ball, v)) continue;
      patch.nodes.push_back(v);
      balls.push_back(std::move(ball));
    }
  };
  take_inner(work.tet(t));
  const std::size_t own = balls.size();
  for (std::size_t i = 0; i < own; ++i) {
    const std::vector<std::int32_t> ball = balls[i];
    for (const std::int32_t beside : ball) take_inner(work.tet(beside));
  }
  patch.tets = tets_round(balls);
  number_corners(work, patch);
  return patch;
}

TetPieces pieces_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> p = {a, b, c, d};
  const double volume6 = dot(cross(b - a, c - a), d - a);
  std::array<double, 4> areas;
  for (std::size_t face = 0; face < 4; ++face) {
    const auto& [i, j, k] = tet_face_nodes[face];
    areas[face] = tetfarm::norm2(cross(p[at(j)] - p[at(i)], p[at(k)] - p[at(i)]));
  }
  TetPieces pieces;
  for (std::size_t face = 0; face < 4; ++face) {
    pieces.heights2[face] = volume6 * std::fabs(volume6) / areas[face];
  }
  // The edge of two nodes lies between the faces opposite to the other two.
  static constexpr std::array<std::array<std::size_t, 4>, 6> edges = {
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j, k, l] = edges[e];
    pieces.sines2[e] =
        volume6 * std::fabs(volume6) * tetfarm::norm2(p[j] - p[i]) / (areas[k] * areas[l]);
  }
  return pieces;
}

std::vector<Vec3> direction_up(const std::vector<TetSlope>& slopes, std::size_t nodes) {
  TF_CHECK(nodes > 0 || slopes.empty());
  if (slopes.empty()) return {};
  constexpr int most_iterations = 200;
  std::vector<Vec3> now = dense(slopes.front(), nodes);
  for (int i = 0; i < most_iterations; ++i) {
    const TetSlope* nearest = nullptr;
    double least = HUGE_VAL;
    for (const TetSlope& slope : slopes) {
      const double along = dot(slope, now);
      if (along >= least) continue;
      least = along;
      nearest = &slope;
    }
    const double length2 = norm2(now);
    const double gain = length2 - least;
    if (nearest == nullptr || gain <= 1e-2 * length2) break;
    std::vector<Vec3> towards = dense(*nearest, nodes);
    for (std::size_t v = 0; v < nodes; ++v) towards[v] -= now[v];
    const double share = std::min(1.0, gain / norm2(towards));
    for (std::size_t v = 0; v < nodes; ++v) now[v] += share * towards[v];
  }
  double longest2 = 0;
  for (const Vec3& v : now) longest2 = std::max(longest2, tetfarm::norm2(v));
  if (!(longest2 > 0)) return {};
  const double scale = 1 / std::sqrt(longest2);
  for (Vec3& v : now) v *= scale;
  return now;
}

double shortest_edge(const NodePatch& patch) {
  double shortest2 = HUGE_VAL;
  for (const Tet& tet : patch.corners) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        shortest2 = std::min(shortest2,
                             tetfarm::norm2(patch.points[at(tet[i])] - patch.points[at(tet[j])]));
      }
    }
  }
  return std::sqrt(shortest2);
}

bool move_patch(WorkMesh& work, const NodePatch& patch) {
  std::vector<Vec3>& points = work.complex.points;
  TF_CHECK(patch.points.size() >= patch.nodes.size());
  std::vector<Vec3> from;
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    Vec3& p = points[at(patch.nodes[i])];
    from.push_back(p);
    p = patch.points[i];
  }
  const bool is_valid = std::all_of(patch.tets.begin(), patch.tets.end(), [&](std::int32_t t) {
    return is_positive(work.complex, work.tet(t));
  });
  if (!is_valid) {
    for (std::size_t i = 0; i < from.size(); ++i) points[at(patch.nodes[i])] = from[i];
    return false;
  }
  ++work.changes;
  for (const std::int32_t t : patch.tets) {
    work.forget_quality_of(t);
    for (const std::int32_t v : work.tet(t)) work.node2change[at(v)] = work.changes;
  }
  return true;
}

std::vector<std::int32_t> improve_together(WorkMesh& work, std::int32_t t, double enough) {
  NodePatch patch = patch_round(work, t);
  if (patch.nodes.empty()) return {};
  const double before = worst_of(work, patch.tets);
  const double after = climb_together(patch, enough, guard(patch, before));
  if (!is_worth(before, after) || !move_patch(work, patch)) return {};
  return std::move(patch.tets);
}

}  // namespace tetfarm::cosmetics
