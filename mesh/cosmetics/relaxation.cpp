#include "mesh/cosmetics/relaxation.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "mesh/cosmetics/smoothing.h"

namespace tetfarm::cosmetics {

namespace {

/// A smaller share of the sum is not worth a move.
constexpr double least_gain = 1e-3;
/// How often the step is halved when it leads to a bad place.
constexpr int most_halvings = 2;

/// A face that the node sees, with what does not depend on the node's place.
struct Facing {
  std::array<Vec3, 3> corners;
  std::array<double, 3> edges2;  ///< squared: opposite to the corners
  Vec3 normal;                   ///< dot(normal, p - corner) is six times the volume
  double normal2;
  double sum_of_edges2;
};

Facing facing_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  Facing face{{a, b, c}, {norm2(c - b), norm2(a - c), norm2(b - a)}, cross(b - a, c - a), 0, 0};
  face.normal2 = norm2(face.normal);
  face.sum_of_edges2 = face.edges2[0] + face.edges2[1] + face.edges2[2];
  return face;
}

std::vector<Facing> facings_of(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                               std::int32_t node) {
  std::vector<Facing> faces;
  faces.reserve(ball.size());
  for (const std::int32_t t : ball) {
    const Tet& tet = work.tet(t);
    const auto& local = tet_face_nodes[static_cast<std::size_t>(work.local_node(t, node))];
    const auto corner = [&](std::size_t i) -> const Vec3& {
      return work.point(tet[static_cast<std::size_t>(local[i])]);
    };
    faces.push_back(facing_of(corner(2), corner(1), corner(0)));
  }
  return faces;
}

/// Whether the tet's quality at p is at least `floor`: without a division.
bool is_good_enough(const Facing& face, const Vec3& p, double floor) {
  const Vec3 pa = face.corners[0] - p;
  const Vec3 pb = face.corners[1] - p;
  const Vec3 pc = face.corners[2] - p;
  const Vec3 normal_a = cross(pb, pc);
  const Vec3 normal_b = cross(pc, pa);
  const Vec3 normal_c = face.normal - normal_a - normal_b;
  const double volume6 = -dot(face.normal, pa);
  const double a = norm2(normal_a);
  const double b = norm2(normal_b);
  const double c = norm2(normal_c);
  const double beside_p =
      std::min(std::min(norm2(pa) * a, norm2(pb) * b), norm2(pc) * c) * face.normal2;
  const double opposite =
      std::min(std::min(face.edges2[0] * b * c, face.edges2[1] * a * c), face.edges2[2] * a * b);
  const double least = std::min(beside_p, opposite);
  return volume6 > 0 && volume6 * volume6 * least >= floor * (face.normal2 * a * b * c);
}

double edges2_at(const Facing& face, const Vec3& p) {
  return face.sum_of_edges2 + norm2(p - face.corners[0]) + norm2(p - face.corners[1]) +
         norm2(p - face.corners[2]);
}

/// The sum that falls; infinite where a tet is flat or inverted.
double flatness(const std::vector<Facing>& faces, const Vec3& p) {
  double sum = 0;
  for (const Facing& face : faces) {
    const double volume6 = dot(face.normal, p - face.corners[0]);
    if (!(volume6 > 0)) return HUGE_VAL;
    const double edges2 = edges2_at(face, p);
    sum += edges2 * edges2 * edges2 / (volume6 * volume6);
  }
  return sum;
}

/// Value, gradient and Hessian (xx, xy, xz, yy, yz, zz) of the flatness at a point.
struct Expansion {
  double value = 0;
  Vec3 gradient;
  std::array<double, 6> hessian{};
};

/// @pre all tets are positive at p.
Expansion expand(const std::vector<Facing>& faces, const Vec3& p) {
  Expansion sum;
  for (const Facing& face : faces) {
    const double per_volume6 = 1 / dot(face.normal, p - face.corners[0]);
    const double edges2 = edges2_at(face, p);
    const double per_edges2 = 1 / edges2;
    const double value = edges2 * edges2 * edges2 * (per_volume6 * per_volume6);
    // With log(value) = 3 log(edges2) - 2 log(volume6).
    const Vec3 u = (6 * per_edges2) * (3 * p - face.corners[0] - face.corners[1] - face.corners[2]);
    const Vec3 w = (2 * per_volume6) * face.normal;
    const Vec3 slope = u - w;
    sum.value += value;
    sum.gradient += value * slope;
    const double third = value / 3;
    const double half = 0.5 * value;
    const double diagonal = 18 * value * per_edges2;
    const Vec3 vs = value * slope;
    const Vec3 tu = third * u;
    const Vec3 hw = half * w;
    sum.hessian[0] += vs.x * slope.x - tu.x * u.x + hw.x * w.x + diagonal;
    sum.hessian[1] += vs.x * slope.y - tu.x * u.y + hw.x * w.y;
    sum.hessian[2] += vs.x * slope.z - tu.x * u.z + hw.x * w.z;
    sum.hessian[3] += vs.y * slope.y - tu.y * u.y + hw.y * w.y + diagonal;
    sum.hessian[4] += vs.y * slope.z - tu.y * u.z + hw.y * w.z;
    sum.hessian[5] += vs.z * slope.z - tu.z * u.z + hw.z * w.z + diagonal;
  }
  return sum;
}

/// From p to where the expansion is least; zero when it has no least or is nearly there.
Vec3 newton_step(const Expansion& at) {
  const auto& h = at.hessian;
  const double xx = h[3] * h[5] - h[4] * h[4];
  const double xy = h[2] * h[4] - h[1] * h[5];
  const double xz = h[1] * h[4] - h[2] * h[3];
  const double yy = h[0] * h[5] - h[2] * h[2];
  const double yz = h[1] * h[2] - h[0] * h[4];
  const double zz = h[0] * h[3] - h[1] * h[1];
  const double determinant = h[0] * xx + h[1] * xy + h[2] * xz;
  if (!(determinant > 0)) return {};
  const Vec3& g = at.gradient;
  const Vec3 step =
      (-1 / determinant) * Vec3{xx * g.x + xy * g.y + xz * g.z, xy * g.x + yy * g.y + yz * g.z,
                                xz * g.x + yz * g.y + zz * g.z};
  return -0.5 * dot(step, g) > least_gain * at.value ? step : Vec3{};
}

}  // namespace

std::optional<Vec3> find_rounder_place(const WorkMesh& work, const std::vector<std::int32_t>& ball,
                                       std::int32_t node, double floor) {
  const std::vector<Facing> faces = facings_of(work, ball, node);
  const Vec3& here = work.point(node);
  const auto all_good = [&](const Vec3& p, double least) {
    return std::ranges::all_of(faces,
                               [&](const Facing& face) { return is_good_enough(face, p, least); });
  };
  const Expansion now = expand(faces, here);
  Vec3 step = newton_step(now);
  if (!(norm2(step) > 0)) return std::nullopt;
  for (int halving = 0; halving <= most_halvings; ++halving, step *= 0.5) {
    const Vec3 p = here + step;
    if (!(flatness(faces, p) < (1 - least_gain) * now.value)) continue;
    // Or better than what is there, by more than rounding.
    if (all_good(p, floor) || all_good(p, worst_of(work, ball) * (1 + 1e-12))) return p;
  }
  return std::nullopt;
}

std::int64_t relax_nodes(WorkMesh& work, const std::vector<bool>& chosen, double floor) {
  std::int64_t moves = 0;
  TF_CHECK(chosen.size() <= work.complex.points.size());
  for (std::size_t v = 0; v < chosen.size(); ++v) {
    const auto node = static_cast<std::int32_t>(v);
    if (!chosen[v] || !work.may_move(node) || work.complex.node2tet[v] < 0) continue;
    const std::vector<std::int32_t> ball = ball_of_node(work, node);
    if (!is_inner(work, ball, node)) continue;
    const std::optional<Vec3> place = find_rounder_place(work, ball, node, floor);
    if (place && move_node(work, ball, node, *place)) ++moves;
  }
  return moves;
}

}  // namespace tetfarm::cosmetics
