#include "mesh/decompose/work_estimate.h"

#include <algorithm>

#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/decompose/shadow_grid.h"
#include "mesh/decompose/surface_contact.h"
#include "mesh/decompose/surface_topology.h"
#include "mesh/geometry/predicates.h"
#include "mesh/spacing/octree_build.h"

namespace tetfarm {
namespace {

constexpr double elements_per_node = 6;
constexpr double elements_per_triangle = 1.3;
constexpr std::size_t samples_for_counting = 40000;
/// As the volume mesher has it (mesh/volume/point_insertion.h), in mean edges of the lattice's
/// tets.
constexpr double face_clearance = 0.5;
constexpr double node_clearance = 0.6;

/// A lattice node, and how often the ray that goes from it along -x enters the surface more than it
/// leaves it: 1 inside, 0 outside.
struct Probe {
  Vec3 at;
  double cell_edge = 0;
  int depth = 0;
  bool is_clear = true;
};

/// Whether the ray that goes up z from p, in the (y, z) projection, crosses the edge ab, and which
/// way: the half-open rule, and the same sign for both uses of an edge, so that triangles tile the
/// projection.
int upward_crossing(const Vec3& a, const Vec3& b, double y, double z) {
  const bool a_is_right = a.y > y;
  if (a_is_right == (b.y > y)) return 0;
  const Vec3& left = a_is_right ? b : a;
  const Vec3& right = a_is_right ? a : b;
  const bool is_below_edge = orient2d({left.y, left.z}, {right.y, right.z}, {y, z}) < 0;
  if (!is_below_edge) return 0;
  return a_is_right ? 1 : -1;
}

struct Corners {
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
};

/// Counts the triangle where it lies below the probe along x.
void cross_ray(const Corners& t, Probe& probe) {
  const double y = probe.at.y;
  const double z = probe.at.z;
  const int turns = upward_crossing(t.a, t.b, y, z) + upward_crossing(t.b, t.c, y, z) +
                    upward_crossing(t.c, t.a, y, z);
  if (turns == 0) return;
  const double low = std::min({t.a.x, t.b.x, t.c.x});
  const double high = std::max({t.a.x, t.b.x, t.c.x});
  const Vec3 normal = cross(t.b - t.a, t.c - t.a);
  const double x = t.a.x - (normal.y * (y - t.a.y) + normal.z * (z - t.a.z)) / normal.x;
  // A nearly vertical triangle may give anything, even a NaN: any point of it will do.
  if ((x >= low && x <= high ? x : 0.5 * (low + high)) < probe.at.x) probe.depth -= turns;
}

/// Finds out whether the triangle is too near to the probe.
void keep_clear(const Corners& t, Probe& probe) {
  if (!probe.is_clear) return;
  const double h = lattice_ratio * probe.cell_edge;
  const double from_nodes2 = node_clearance * node_clearance * h * h;
  for (const Vec3* v : {&t.a, &t.b, &t.c}) {
    if (norm2(*v - probe.at) < from_nodes2) probe.is_clear = false;
  }
  if (closest_in_triangle(probe.at, t.a, t.b, t.c).distance2 <
      face_clearance * face_clearance * h * h) {
    probe.is_clear = false;
  }
}

void judge(const Subdomain& subdomain, std::vector<Probe>& probes) {
  std::vector<Box3> neighbourhoods;
  neighbourhoods.reserve(probes.size());
  for (const Probe& probe : probes) {
    const double reach = node_clearance * lattice_ratio * probe.cell_edge;
    const Vec3 around{reach, reach, reach};
    neighbourhoods.push_back({probe.at - around, probe.at + around});
  }
  const ShadowGrid grid(neighbourhoods);
  for (const Triangle& triangle : subdomain.triangles) {
    const Corners corners{subdomain.vertices[idx(triangle[0])],
                          subdomain.vertices[idx(triangle[1])],
                          subdomain.vertices[idx(triangle[2])]};
    Box3 box;
    for (const Vec3* v : {&corners.a, &corners.b, &corners.c}) box.add(*v);
    grid.query(box, [&](std::int32_t i) {
      if (probes[idx(i)].at.x > box.low.x) cross_ray(corners, probes[idx(i)]);
      if (neighbourhoods[idx(i)].overlaps(box)) keep_clear(corners, probes[idx(i)]);
    });
  }
}

/// The cube root of a number from 1 to 2^60, within a factor of 1.26, by * and comparison only.
double about_cube_root(double x) {
  double root = 1;
  while (root * root * root * 2 < x) root *= 1.25992104989487;
  return root;
}

void add_triangles(const Subdomain& subdomain, const SpacingField& spacing, std::size_t most,
                   WorkSamples& work) {
  const std::size_t count = subdomain.triangles.size();
  const std::size_t stride = std::max<std::size_t>(1, (count + most - 1) / most);
  const double each = elements_per_triangle * static_cast<double>(stride);
  for (std::size_t t = stride / 2; t < count; t += stride) {
    const auto& [a, b, c] = subdomain.triangles[t];
    const Vec3 centre =
        (subdomain.vertices[idx(a)] + subdomain.vertices[idx(b)] + subdomain.vertices[idx(c)]) / 3;
    const double h = spacing.at(centre);
    work.samples.push_back({centre, each, h, h});
    work.total += each;
  }
}

}  // namespace

WorkSamples sample_work(const Subdomain& subdomain, const SpacingField& spacing, std::size_t most) {
  const LatticeSample lattice = spacing.sample_lattice(bounding_box(subdomain.vertices), most);
  std::vector<Probe> probes;
  for (const LatticeNode& node : lattice.nodes) probes.push_back({node.place(), node.cell_edge});
  judge(subdomain, probes);
  WorkSamples work;
  const double each = elements_per_node * lattice.nodes_for_each;
  // A cell holds two nodes.
  const double cells = about_cube_root(std::max(1.0, lattice.nodes_for_each / 2));
  for (const Probe& probe : probes) {
    if (probe.depth <= 0 || !probe.is_clear) continue;
    work.samples.push_back({probe.at, each, spacing.at(probe.at), cells * probe.cell_edge});
    work.total += each;
  }
  add_triangles(subdomain, spacing, most / 4, work);
  return work;
}

double estimated_elements(const Subdomain& subdomain, const SpacingField& spacing) {
  if (subdomain.region > 0) return sample_work(subdomain, spacing, samples_for_counting).total;
  double sum = 0;
  for (const std::int32_t region : regions_of(subdomain)) {
    sum += sample_work(part_of_regions(subdomain, {region}, subdomain.path), spacing,
                       samples_for_counting)
               .total;
  }
  return sum;
}

}  // namespace tetfarm
