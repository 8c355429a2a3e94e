#include "mesh/decompose/work_estimate.h"

#include <algorithm>
#include <tuple>

#include "base/array_index.h"
#include "base/check.h"
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
/// As the volume mesher has it (mesh/filling/point_insertion.h), in mean edges of the lattice's
/// tets.
constexpr double face_clearance = 0.5;
constexpr double node_clearance = 0.6;

/// A lattice node. A ray from it along -x enters the surface once more than it leaves it when the
/// node is inside: `entered` counts what lies between it and the probe before it on the line.
struct Probe {
  Vec3 at;
  double cell_edge = 0;
  std::size_t number = 0;
  int entered = 0;
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

/// Where the line along x at (y, z), which crosses the triangle, meets it.
double crossing_of(const Corners& t, double y, double z) {
  const double low = std::min({t.a.x, t.b.x, t.c.x});
  const double high = std::max({t.a.x, t.b.x, t.c.x});
  const Vec3 normal = cross(t.b - t.a, t.c - t.a);
  const double x = t.a.x - (normal.y * (y - t.a.y) + normal.z * (z - t.a.z)) / normal.x;
  // A nearly vertical triangle may give anything, even a NaN: any point of it will do.
  return x >= low && x <= high ? x : 0.5 * (low + high);
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

double reach_of(const Probe& probe) { return node_clearance * lattice_ratio * probe.cell_edge; }

/// Which way the line along x at (y, z) crosses the triangle: 1, -1, or 0 when it does not.
int turns_through(const Corners& t, const Box3& box, double y, double z) {
  if (y < box.low.y || y > box.high.y || z < box.low.z || z > box.high.z) return 0;
  return upward_crossing(t.a, t.b, y, z) + upward_crossing(t.b, t.c, y, z) +
         upward_crossing(t.c, t.a, y, z);
}

/// Probes on one line along x: nodes of a lattice lie in rows, which a triangle crosses or not.
struct Row {
  double y = 0;
  double z = 0;
  std::size_t first = 0;
  std::size_t last = 0;  // past the end
  double reach = 0;      // the largest of its probes
  double low_x = 0;      // its first probe
  double high_x = 0;     // and its last
};

/// @pre the probes are sorted by row.
std::vector<Row> rows_of(const std::vector<Probe>& probes) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Vec3& at = probes[i].at;
    if (rows.empty() || rows.back().y != at.y || rows.back().z != at.z) {
      rows.push_back({at.y, at.z, i, i, 0, at.x, at.x});
    }
    rows.back().last = i + 1;
    rows.back().high_x = at.x;
    rows.back().reach = std::max(rows.back().reach, reach_of(probes[i]));
  }
  return rows;
}

/// Of a sorted row, the first probe beyond x.
std::size_t first_beyond(const std::vector<Probe>& probes, const Row& row, double x) {
  const auto begin = probes.begin();
  const auto found = std::upper_bound(
      begin + static_cast<std::ptrdiff_t>(row.first), begin + static_cast<std::ptrdiff_t>(row.last),
      x, [](double limit, const Probe& probe) { return limit < probe.at.x; });
  return static_cast<std::size_t>(found - begin);
}

void keep_row_clear(const Corners& t, const Box3& box, const Row& row, std::vector<Probe>& probes) {
  // Twice the reach, so that no rounding leaves out what the box then decides.
  const double far = 2 * row.reach;
  if (row.high_x < box.low.x - far || row.low_x > box.high.x + far) return;
  for (std::size_t i = first_beyond(probes, row, box.low.x - far); i < row.last; ++i) {
    Probe& probe = probes[i];
    if (probe.at.x > box.high.x + far) break;
    const double reach = reach_of(probe);
    const Vec3 around{reach, reach, reach};
    if (Box3{probe.at - around, probe.at + around}.overlaps(box)) keep_clear(t, probe);
  }
}

/// By y, z, x: row by row.
void sort_by_row(std::vector<Probe>& probes) {
  std::sort(probes.begin(), probes.end(), [](const Probe& a, const Probe& b) {
    return std::tie(a.at.y, a.at.z, a.at.x) < std::tie(b.at.y, b.at.z, b.at.x);
  });
}

/// @pre the probes are sorted by row.
void judge(const Subdomain& subdomain, const std::vector<Row>& rows, std::vector<Probe>& probes) {
  std::vector<Box3> shadows;
  shadows.reserve(rows.size());
  for (const Row& row : rows) {
    shadows.push_back(
        {{0, row.y - row.reach, row.z - row.reach}, {0, row.y + row.reach, row.z + row.reach}});
  }
  const ShadowGrid grid(shadows);
  for (const Triangle& triangle : subdomain.triangles) {
    const Corners corners{subdomain.vertices[at(triangle[0])], subdomain.vertices[at(triangle[1])],
                          subdomain.vertices[at(triangle[2])]};
    Box3 box;
    for (const Vec3* v : {&corners.a, &corners.b, &corners.c}) box.add(*v);
    grid.query(box, [&](std::int32_t r) {
      const Row& row = rows[at(r)];
      const int turns = turns_through(corners, box, row.y, row.z);
      if (turns != 0) {
        const std::size_t i = first_beyond(probes, row, crossing_of(corners, row.y, row.z));
        if (i < row.last) probes[i].entered -= turns;
      }
      keep_row_clear(corners, box, row, probes);
    });
  }
}

/// Of each probe, by number, whether the mesher would put a node there: inside, and clear of the
/// surface.
std::vector<bool> are_nodes(const Subdomain& subdomain, std::vector<Probe> probes) {
  sort_by_row(probes);
  const std::vector<Row> rows = rows_of(probes);
  judge(subdomain, rows, probes);
  std::vector<bool> is_node(probes.size(), false);
  for (const Row& row : rows) {
    int depth = 0;
    for (std::size_t i = row.first; i < row.last; ++i) {
      depth += probes[i].entered;
      is_node[probes[i].number] = depth > 0 && probes[i].is_clear;
    }
  }
  return is_node;
}

/// The cube root of a number from 1 to 2^60, within a factor of 1.26, by * and comparison only.
double about_cube_root(double x) {
  double root = 1;
  while (root * root * root * 2 < x) root *= 1.25992104989487;
  return root;
}

void add_triangles(const Subdomain& subdomain, const SpacingField& spacing, std::size_t most,
                   WorkSamples& work) {
  TF_CHECK(most > 0);
  const std::size_t count = subdomain.triangles.size();
  const std::size_t stride = std::max<std::size_t>(1, (count + most - 1) / most);
  const double each = elements_per_triangle * static_cast<double>(stride);
  for (std::size_t t = stride / 2; t < count; t += stride) {
    const auto& [a, b, c] = subdomain.triangles[t];
    const Vec3 centre =
        (subdomain.vertices[at(a)] + subdomain.vertices[at(b)] + subdomain.vertices[at(c)]) / 3;
    const double h = spacing.at(centre);
    work.samples.push_back({centre, each, h, h});
    work.total += each;
  }
}

}  // namespace

WorkSamples sample_work(const Subdomain& subdomain, const SpacingField& spacing, std::size_t most) {
  const LatticeSample lattice = spacing.sample_lattice(bounding_box(subdomain.vertices), most);
  std::vector<Probe> probes;
  for (const LatticeNode& node : lattice.nodes) {
    probes.push_back({node.place(), node.cell_edge, probes.size()});
  }
  const std::vector<bool> is_node = are_nodes(subdomain, probes);
  WorkSamples work;
  const double each = elements_per_node * lattice.nodes_for_each;
  // A cell holds two nodes.
  const double cells = about_cube_root(std::max(1.0, lattice.nodes_for_each / 2));
  for (const Probe& probe : probes) {
    if (!is_node[probe.number]) continue;
    work.samples.push_back({probe.at, each, spacing.at(probe.at), cells * probe.cell_edge});
    work.total += each;
  }
  add_triangles(subdomain, spacing, most / 4, work);
  return work;
}

double estimated_elements(const Subdomain& subdomain, const SpacingField& spacing,
                          std::size_t samples) {
  if (subdomain.region > 0) return sample_work(subdomain, spacing, samples).total;
  double sum = 0;
  for (const std::int32_t region : regions_of(subdomain)) {
    sum +=
        sample_work(part_of_regions(subdomain, {region}, subdomain.path), spacing, samples).total;
  }
  return sum;
}

}  // namespace tetfarm
