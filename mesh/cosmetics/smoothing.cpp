#include "mesh/cosmetics/smoothing.h"

#include <algorithm>
#include <span>

#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

constexpr int most_climbs = 8;
constexpr int most_halvings = 5;
constexpr std::size_t most_active = 12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double goodness_at(const std::array<Vec3, 3>& face, const Vec3& p) {
  return goodness(face[0], face[1], face[2], p);
}

/// The mean of the nodes of the star; each counts as often as it has faces.
Vec3 mean_of(const Star& star) {
  Vec3 sum;
  for (const auto& face : star) sum += face[0] + face[1] + face[2];
  return sum / (3.0 * static_cast<double>(star.size()));
}

double shortest_distance2(const Star& star, const Vec3& p) {
  double shortest = HUGE_VAL;
  for (const auto& face : star) {
    for (const Vec3& corner : face) shortest = std::min(shortest, norm2(corner - p));
  }
  return shortest;
}

Vec3 gradient(const std::array<Vec3, 3>& face, const Vec3& p, double here, double step) {
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 q = p;
    q[axis] += step;
    slope[axis] = (goodness_at(face, q) - here) / step;
  }
  return slope;
}

/// The shortest vector in the convex hull (Gilbert's iteration), close enough for a direction.
Vec3 shortest_in_hull(std::span<const Vec3> vectors) {
  Vec3 now = vectors[0];
  for (int i = 0; i < 24; ++i) {
    const auto nearest =
        std::min_element(vectors.begin(), vectors.end(),
                         [&](const Vec3& a, const Vec3& b) { return dot(a, now) < dot(b, now); });
    const Vec3 towards = *nearest - now;
    const double gain = -dot(now, towards);
    if (gain <= 1e-3 * norm2(now)) break;
    now += std::min(1.0, gain / norm2(towards)) * towards;
  }
  return now;
}

/// A direction in which all tets that are nearly the worst get better; zero when there is none.
Vec3 direction_up(const Star& star, const Vec3& p, double worst, double length) {
  const double below = worst + 0.1 * std::max(std::fabs(worst), 0.05);
  std::array<Vec3, most_active> gradients;
  std::size_t active = 0;
  for (const auto& face : star) {
    const double here = goodness_at(face, p);
    if (here > below) continue;
    gradients[active++] = gradient(face, p, here, 1e-6 * length);
    if (active == most_active) break;
  }
  return shortest_in_hull(std::span(gradients.data(), active));
}

}  // namespace

double worst_at(const Star& star, const Vec3& p, double least) {
  double worst = 1;
  for (const auto& face : star) {
    worst = std::min(worst, goodness_at(face, p));
    if (worst < least) break;
  }
  return worst;
}

Star star_of(const WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node) {
  Star star;
  star.reserve(ball.size());
  for (const std::int32_t t : ball) {
    const auto& local = tet_face_nodes[at(work.local_node(t, node))];
    const Tet& tet = work.tet(t);
    star.push_back({work.point(tet[at(local[2])]), work.point(tet[at(local[1])]),
                    work.point(tet[at(local[0])])});
  }
  return star;
}

Place climb(const Star& star, const Vec3& start, double enough) {
  Place place{start, worst_at(star, start, -HUGE_VAL)};
  double length = std::sqrt(shortest_distance2(star, start));
  if (!(length > 0)) return place;
  double step = 0.25 * length;
  for (int i = 0; i < most_climbs && place.worst < enough; ++i) {
    const Vec3 up = normalized(direction_up(star, place.point, place.worst, length));
    if (!(norm2(up) > 0)) break;
    const double before = place.worst;
    for (int halving = 0; halving < most_halvings; ++halving) {
      const Vec3 p = place.point + step * up;
      const double worst = worst_at(star, p, before);
      if (worst > before) {
        place = {p, worst};
        break;
      }
      step *= 0.5;
    }
    if (place.worst <= before + 1e-3 * std::fabs(before)) break;
    step *= 1.5;
  }
  return place;
}

std::optional<Place> find_move(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                               std::int32_t node, double enough) {
  const Star star = star_of(work, ball, node);
  const Vec3& here = work.point(node);
  const double before = worst_at(star, here, -HUGE_VAL);
  const Vec3 mean = mean_of(star);
  Place best{here, before};
  for (const Vec3& p : {mean, 0.5 * (mean + here)}) {
    const double worst = worst_at(star, p, best.worst);
    if (worst > best.worst) best = {p, worst};
  }
  if (best.worst < enough) best = climb(star, best.point, enough);
  if (!is_worth(before, best.worst)) return std::nullopt;
  return best;
}

bool move_node(WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node,
               const Vec3& to) {
  const Vec3 from = work.point(node);
  work.complex.points[at(node)] = to;
  const bool valid = std::all_of(ball.begin(), ball.end(), [&](std::int32_t t) {
    return is_positive(work.complex, work.tet(t));
  });
  if (!valid) {
    work.complex.points[at(node)] = from;
    return false;
  }
  ++work.changes;
  for (const std::int32_t t : ball) {
    work.forget_goodness_of(t);
    for (const std::int32_t v : work.tet(t)) work.node2change[at(v)] = work.changes;
  }
  return true;
}

}  // namespace tetfarm::cosmetics
