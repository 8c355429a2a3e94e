#include "mesh/decompose/inertia_matrix.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "mesh/decompose/surface_topology.h"

namespace tetfarm {
namespace {

Vec3 centre_of_gravity(const WorkSamples& work) {
  Vec3 sum;
  for (const WorkSample& s : work.samples) sum += s.work * s.at;
  return work.total > 0 ? sum / work.total : sum;
}

/// Turns rows and columns p and q so that the element (p, q) vanishes; `axes` turn along.
void rotate(std::array<Vec3, 3>& m, std::array<Vec3, 3>& axes, int p, int q) {
  const double off_diagonal = m[at(p)][q];
  if (off_diagonal == 0) return;
  const double ratio = (m[at(q)][q] - m[at(p)][p]) / (2 * off_diagonal);
  const double tangent = (ratio >= 0 ? 1 : -1) / (std::fabs(ratio) + std::sqrt(ratio * ratio + 1));
  const double c = 1 / std::sqrt(tangent * tangent + 1);
  const double s = tangent * c;
  for (auto& row : m) {
    const double at_p = row[p];
    row[p] = c * at_p - s * row[q];
    row[q] = s * at_p + c * row[q];
  }
  const Vec3 row_p = m[at(p)];
  m[at(p)] = c * row_p - s * m[at(q)];
  m[at(q)] = s * row_p + c * m[at(q)];
  const Vec3 axis_p = axes[at(p)];
  axes[at(p)] = c * axis_p - s * axes[at(q)];
  axes[at(q)] = s * axis_p + c * axes[at(q)];
}

Vec3 with_positive_largest_component(const Vec3& a) {
  double largest = a.x;
  if (std::fabs(a.y) > std::fabs(largest)) largest = a.y;
  if (std::fabs(a.z) > std::fabs(largest)) largest = a.z;
  return largest < 0 ? -a : a;
}

}  // namespace

InertiaMatrix inertia_matrix(const WorkSamples& work) {
  const Vec3 cg = centre_of_gravity(work);
  double xx = 0;
  double yy = 0;
  double zz = 0;
  double xy = 0;
  double xz = 0;
  double yz = 0;
  for (const WorkSample& s : work.samples) {
    const Vec3 d = s.at - cg;
    xx += s.work * (d.y * d.y + d.z * d.z);
    yy += s.work * (d.x * d.x + d.z * d.z);
    zz += s.work * (d.x * d.x + d.y * d.y);
    xy -= s.work * d.x * d.y;
    xz -= s.work * d.x * d.z;
    yz -= s.work * d.y * d.z;
  }
  return {{Vec3{xx, xy, xz}, Vec3{xy, yy, yz}, Vec3{xz, yz, zz}}};
}

std::array<Vec3, 3> principal_axes(const InertiaMatrix& inertia) {
  std::array<Vec3, 3> m = inertia.rows;
  std::array<Vec3, 3> axes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  constexpr int sweeps = 12;  // quadratic convergence: six are enough for doubles
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&m](int i, int j) { return m[at(i)][i] < m[at(j)][j]; });
  std::array<Vec3, 3> sorted;
  for (int i = 0; i < 3; ++i) {
    sorted[at(i)] = with_positive_largest_component(normalized(axes[at(order[at(i)])]));
  }
  return sorted;
}

}  // namespace tetfarm
