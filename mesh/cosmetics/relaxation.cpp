#include "mesh/cosmetics/relaxation.h"

#include "mesh/core/tet_quality.h"

namespace tetfarm::cosmetics {

namespace {

/// A smaller gain in the sum of the radius ratios is not worth a move.
constexpr double least_gain = 1.001;

double sum_of_ratios(const Star& star, const Vec3& p) {
  double sum = 0;
  for (const auto& face : star) sum += radius_ratio(face[0], face[1], face[2], p);
  return sum;
}

/// The mean of the circumcentres of the star's tets, by volume.
Vec3 optimal_delaunay_place(const Star& star, const Vec3& p) {
  Vec3 sum;
  double volumes = 0;
  for (const auto& face : star) {
    const Vec3 u = face[0] - p;
    const Vec3 v = face[1] - p;
    const Vec3 w = face[2] - p;
    // Circumcentre times twelve times the volume: no division by a volume that may be small.
    sum += norm2(u) * cross(v, w) + norm2(v) * cross(w, u) + norm2(w) * cross(u, v);
    volumes += dot(u, cross(v, w));
  }
  return volumes != 0 ? p + sum / (2 * volumes) : p;
}

}  // namespace

std::optional<Place> find_rounder_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                        std::int32_t node) {
  const Star star = star_of(work, ball, node);
  const Vec3& here = work.point(node);
  const double worst_here = worst_at(star, here, -HUGE_VAL);
  const double before = sum_of_ratios(star, here);
  const Vec3 towards = optimal_delaunay_place(star, here) - here;
  for (const double step : {1.0, 0.5, 0.25}) {
    const Vec3 p = here + step * towards;
    const double worst = worst_at(star, p, worst_here);
    if (worst < worst_here) continue;
    if (sum_of_ratios(star, p) > before * least_gain) return Place{p, worst};
  }
  return std::nullopt;
}

std::int64_t relax_nodes(WorkMesh& work, const std::vector<bool>& chosen) {
  std::int64_t moves = 0;
  for (std::size_t v = 0; v < chosen.size(); ++v) {
    const auto node = static_cast<std::int32_t>(v);
    if (!chosen[v] || !work.may_move(node) || work.complex.node2tet[v] < 0) continue;
    const std::vector<std::int32_t> ball = ball_of_node(work, node);
    if (!is_inner(work, ball, node)) continue;
    const std::optional<Place> place = find_rounder_place(work, ball, node);
    if (place && move_node(work, ball, node, place->point)) ++moves;
  }
  return moves;
}

}  // namespace tetfarm::cosmetics
