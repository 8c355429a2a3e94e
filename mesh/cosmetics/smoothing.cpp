#include "mesh/cosmetics/smoothing.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

struct TetQuality {
  double operator()(const StarFace& face, const Vec3& p) const {
    return quality(face[0], face[1], face[2], p);
  }
  double operator()(const StarFace& face, const StarFace& other, const Vec3& p) const {
    return quality_over_two(face, other, p);
  }
};

/// The mean of the nodes of the star; each counts as often as it has faces.
Vec3 mean_of(const Star& star) {
  Vec3 sum;
  TF_CHECK(!star.empty());
  for (const StarFace& face : star) sum += face[0] + face[1] + face[2];
  return sum / (3.0 * static_cast<double>(star.size()));
}

}  // namespace

double worst_at(const Star& star, const Vec3& p, double least) {
  return worst_at(star, p, least, TetQuality{});
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
  return climb(star, start, enough, TetQuality{});
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
  if (!is_worth(before, best.worst, work.gain)) return std::nullopt;
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
    work.forget_quality_of(t);
    for (const std::int32_t v : work.tet(t)) work.node2change[at(v)] = work.changes;
  }
  return true;
}

}  // namespace tetfarm::cosmetics
