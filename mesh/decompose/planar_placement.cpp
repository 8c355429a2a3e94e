#include "mesh/decompose/planar_placement.h"

#include <algorithm>
#include <cmath>

#include "mesh/decompose/inertia_matrix.h"
#include "mesh/decompose/invalid_zones.h"

namespace tetfarm {
namespace {

/// How far the share of the work may leave the wanted one, relative to the smaller side.
constexpr double farthest_quantile = 0.44;
constexpr double imbalance_weight = 3;
constexpr double area_weight = 0.3;
constexpr double largest_area_penalty = 1;
constexpr double zone_weight = 0.2;

std::vector<Vec3> cutting_directions(const WorkSamples& work) {
  std::vector<Vec3> directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& axis : principal_axes(inertia_matrix(work))) {
    constexpr double nearly_equal = 0.99;
    const bool is_new = std::none_of(directions.begin(), directions.end(), [&](const Vec3& d) {
      return std::fabs(dot(d, axis)) > nearly_equal;
    });
    if (is_new) directions.push_back(axis);
  }
  return directions;
}

/// The work along a direction: every sample is spread evenly over the width of its cell.
struct WorkStep {
  double at = 0;
  double density = 0;       // change of work per length
  double area_density = 0;  // change of area / h^2, times elements_per_h3
};

std::vector<WorkStep> work_along(const WorkSamples& work, const Vec3& direction) {
  std::vector<WorkStep> steps;
  steps.reserve(2 * work.samples.size());
  for (const WorkSample& s : work.samples) {
    const double width = std::fabs(direction.x) * s.cell.x + std::fabs(direction.y) * s.cell.y +
                         std::fabs(direction.z) * s.cell.z;
    const double at = dot(s.at, direction);
    const double density = s.work / width;
    steps.push_back({at - 0.5 * width, density, density * s.spacing});
    steps.push_back({at + 0.5 * width, -density, -density * s.spacing});
  }
  std::sort(steps.begin(), steps.end(), [](const WorkStep& a, const WorkStep& b) {
    return a.at != b.at ? a.at < b.at : a.density < b.density;
  });
  return steps;
}

struct Position {
  double share = 0;   // of the work below
  double offset = 0;  // along the direction
  double area = 0;    // of the plane inside the sub-domain, in h^2 times elements_per_h3
};

/// Where along the direction the wanted shares (ascending) of the work lie below.
std::vector<Position> positions_of_shares(const std::vector<WorkStep>& steps, double total,
                                          const std::vector<double>& shares) {
  std::vector<Position> positions;
  double work = 0;
  double density = 0;
  double area = 0;
  for (std::size_t i = 0; i + 1 < steps.size() && positions.size() < shares.size(); ++i) {
    density += steps[i].density;
    area += steps[i].area_density;
    const double length = steps[i + 1].at - steps[i].at;
    while (positions.size() < shares.size()) {
      const double missing = shares[positions.size()] * total - work;
      if (missing > density * length) break;
      positions.push_back(
          {shares[positions.size()], steps[i].at + (density > 0 ? missing / density : 0), area});
    }
    work += density * length;
  }
  return positions;
}

std::vector<double> shares_to_try(double left_share, int each_side) {
  std::vector<double> shares;
  const double room = farthest_quantile * std::min(left_share, 1 - left_share);
  for (int i = -each_side; i <= each_side; ++i) {
    const double step = static_cast<double>(i) / each_side;
    shares.push_back(left_share + room * step * std::fabs(step));
  }
  return shares;
}

double imbalance(double share, double wanted) {
  return std::fabs(share - wanted) / std::min(wanted, 1 - wanted);
}

}  // namespace

std::vector<PlaneCandidate> place_planes(const Subdomain& subdomain,
                                         const SurfaceTopology& topology, const WorkSamples& work,
                                         double left_share, int most) {
  const std::vector<Vec3> directions = cutting_directions(work);
  const int each_side = std::max(1, most / static_cast<int>(directions.size()) / 2);
  const std::vector<double> shares = shares_to_try(left_share, each_side);
  std::vector<std::vector<Position>> positions;
  double smallest_area = HUGE_VAL;
  for (const Vec3& direction : directions) {
    positions.push_back(positions_of_shares(work_along(work, direction), work.total, shares));
    for (const Position& p : positions.back()) {
      if (p.share == left_share) smallest_area = std::min(smallest_area, p.area);
    }
  }
  const double bounding_area = norm2(bounding_box(subdomain.vertices).size());
  std::vector<PlaneCandidate> candidates;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    std::vector<double> offsets;
    for (const Position& p : positions[d]) offsets.push_back(p.offset);
    const auto zone_area = area_in_invalid_zones(subdomain, topology, directions[d], offsets);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const CutPlane plane = make_cut_plane(directions[d], offsets[i]);
      const double relative_area = positions[d][i].area / smallest_area;
      candidates.push_back(
          {plane, positions[d][i].share,
           imbalance_weight * imbalance(positions[d][i].share, left_share) +
               std::min(largest_area_penalty, area_weight * std::max(0.0, relative_area - 1)) +
               zone_weight * std::min(1.0, zone_area[i] / bounding_area)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.penalty < b.penalty; });
  if (candidates.size() > static_cast<std::size_t>(most)) {
    candidates.resize(static_cast<std::size_t>(most));
  }
  return candidates;
}

}  // namespace tetfarm
