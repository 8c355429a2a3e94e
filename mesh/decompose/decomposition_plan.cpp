#include "mesh/decompose/decomposition_plan.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/work_estimate.h"

namespace tetfarm {
namespace {

/// Triangles of the size of the spacing h on an area of h^2: 4 / sqrt(3).
constexpr double triangles_per_h2 = 2.31;
constexpr std::uint64_t deepest = std::uint64_t{1} << 61U;

/// Some triangles of the boundary, at one place.
struct Facets {
  Vec3 at;
  double triangles = 0;
};

struct Part {
  TreePath path;
  std::int64_t parts = 1;
  std::vector<WorkSample> work;
  std::vector<Facets> boundary;
};

double elements_of(const Part& part) {
  double sum = 0;
  for (const WorkSample& sample : part.work) sum += sample.work;
  return sum;
}

double triangles_of(const Part& part) {
  double sum = 0;
  for (const Facets& facets : part.boundary) sum += facets.triangles;
  return sum;
}

struct Plane {
  int axis = 0;
  double offset = -HUGE_VAL;
  double triangles = HUGE_VAL;  ///< of the cut
};

/// The triangles that the plane would have in the cube that a sample stands for.
double triangles_in(const WorkSample& sample, int axis, double offset) {
  if (std::fabs(sample.at[axis] - offset) > 0.5 * sample.width) return 0;
  const double area_in_h2 =
      sample.work / sample.width * sample.spacing / SpacingField::elements_per_h3;
  return triangles_per_h2 * area_in_h2;
}

/// Halfway between two samples, where the work below is nearest to what is wanted: nodes of a
/// lattice lie in layers, and a plane in one would meet three cubes at a place instead of two.
Plane plane_at_share(const std::vector<WorkSample>& work, int axis, double wanted) {
  std::vector<std::pair<double, double>> along;
  for (const WorkSample& sample : work) along.emplace_back(sample.at[axis], sample.work);
  std::sort(along.begin(), along.end());
  Plane plane{axis, -HUGE_VAL, HUGE_VAL};
  double below = 0;
  double least_miss = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    below += along[i].second;
    const double miss = std::fabs(below - wanted);
    if (along[i].first == along[i + 1].first || miss >= least_miss) continue;
    least_miss = miss;
    plane.offset = 0.5 * (along[i].first + along[i + 1].first);
  }
  if (least_miss == HUGE_VAL) return plane;
  plane.triangles = 0;
  for (const WorkSample& sample : work) plane.triangles += triangles_in(sample, axis, plane.offset);
  return plane;
}

/// The smallest of the cuts orthogonal to the axes that leave the wanted work below; where no two
/// samples lie apart, one with everything on its right.
Plane smallest_plane(const std::vector<WorkSample>& work, double wanted) {
  Plane smallest;
  for (int axis = 0; axis < 3; ++axis) {
    const Plane plane = plane_at_share(work, axis, wanted);
    if (plane.triangles < smallest.triangles) smallest = plane;
  }
  return smallest;
}

/// Both sides get the triangles of the cut.
std::pair<Part, Part> divided(const Part& part, const Plane& plane) {
  Part left;
  Part right;
  left.path = part.path.left();
  right.path = part.path.right();
  for (const WorkSample& sample : part.work) {
    (sample.at[plane.axis] < plane.offset ? left : right).work.push_back(sample);
    const double triangles = triangles_in(sample, plane.axis, plane.offset);
    if (triangles <= 0) continue;
    Facets cut{sample.at, triangles};
    cut.at[plane.axis] = plane.offset;
    left.boundary.push_back(cut);
    right.boundary.push_back(cut);
  }
  for (const Facets& facets : part.boundary) {
    (facets.at[plane.axis] < plane.offset ? left : right).boundary.push_back(facets);
  }
  return {std::move(left), std::move(right)};
}

void plan(const Part& part, const DecideParts& decide, std::vector<PlannedSubdomain>& tree) {
  const double elements = elements_of(part);
  const double triangles = triangles_of(part);
  PlannedSubdomain& here = tree.emplace_back();
  here = {part.path, std::max<std::int64_t>(1, decide(elements, triangles, part.parts)), elements,
          triangles};
  if (part.work.size() < 2 || part.path.heap >= deepest) here.parts = 1;
  if (here.parts == 1) return;
  const std::int64_t left_parts = here.parts / 2;
  const std::int64_t right_parts = here.parts - left_parts;
  const double share = static_cast<double>(left_parts) / static_cast<double>(here.parts);
  TF_CHECK(left_parts >= 1 && right_parts >= 1);
  auto [left, right] = divided(part, smallest_plane(part.work, share * elements));
  if (left.work.empty() || right.work.empty()) {
    here.parts = 1;
    return;
  }
  left.parts = left_parts;
  right.parts = right_parts;
  plan(left, decide, tree);
  plan(right, decide, tree);
}

/// Some hundreds for each leaf, of one region after the other.
std::vector<WorkSample> samples_of(const Subdomain& root, const SpacingField& spacing,
                                   std::int64_t parts) {
  constexpr std::size_t of_a_leaf = 400;
  constexpr std::size_t most = 1'000'000;
  const std::size_t wanted =
      std::clamp(of_a_leaf * static_cast<std::size_t>(parts), samples_for_placing, most);
  if (root.region > 0) return sample_work(root, spacing, wanted).samples;
  std::vector<WorkSample> samples;
  for (const std::int32_t region : regions_of(root)) {
    const Subdomain part = part_of_regions(root, {region}, root.path);
    const std::vector<WorkSample> of_part = sample_work(part, spacing, wanted).samples;
    samples.insert(samples.end(), of_part.begin(), of_part.end());
  }
  return samples;
}

}  // namespace

std::vector<PlannedSubdomain> plan_decomposition(const Subdomain& root, const SpacingField& spacing,
                                                 std::int64_t parts, const DecideParts& decide) {
  TF_CHECK(parts >= 1);
  Part whole;
  whole.path = root.path;
  whole.parts = parts;
  whole.work = samples_of(root, spacing, parts);
  for (const auto& [a, b, c] : root.triangles) {
    const auto at = [&root](std::int32_t v) { return root.vertices[static_cast<std::size_t>(v)]; };
    whole.boundary.push_back({(1.0 / 3) * (at(a) + at(b) + at(c)), 1});
  }
  std::vector<PlannedSubdomain> tree;
  plan(whole, decide, tree);
  return tree;
}

}  // namespace tetfarm
