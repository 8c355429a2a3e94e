#include "mesh/decompose/path_relaxation.h"

#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/decompose/maximum_flow.h"

namespace tetfarm {
namespace {

constexpr double band_in_sizes = 0.75;

/// Along a sharp corner of the material no cut can meet both sides at good angles.
double sharpness(const SurfaceTopology& topology, HalfEdge h) {
  const std::int32_t t = triangle_of(h);
  const std::int32_t neighbour = triangle_of(topology.twin[at(h)]);
  const Vec3& normal = topology.normal[at(t)];
  const Vec3& other_normal = topology.normal[at(neighbour)];
  const bool is_convex =
      dot(normal, topology.centroid[at(neighbour)] - topology.centroid[at(t)]) < 0;
  const double cosine = dot(normal, other_normal) / std::sqrt(norm2(normal) * norm2(other_normal));
  constexpr double of_85_degrees = -0.087;
  constexpr double of_110_degrees = 0.342;
  if (!is_convex || cosine > of_110_degrees) return 1;
  return cosine > of_85_degrees ? 2 : 10;
}

/// Length of an edge, longer the farther it lies from the plane and the steeper it leaves it, all
/// in units of the local size, so that fine and coarse parts of a path count alike.
double path_cost(const Vec3& a, const Vec3& b, double size, const CutPlane& plane) {
  const double length = distance(a, b);
  const double height = plane.height(0.5 * (a + b)) / size;
  const double steepness = length > 0 ? dot(b - a, plane.normal) / length : 0;
  return length / size * (1 + height * height + steepness * steepness);
}

std::int64_t to_capacity(double cost) {
  constexpr double resolution = 1 << 20;
  constexpr double largest = 1e6;
  return static_cast<std::int64_t>(std::fmin(cost, largest) * resolution) + 1;
}

}  // namespace

void relax_path(FaceColours& colours, const Subdomain& subdomain, const SurfaceTopology& topology,
                const CutPlane& plane) {
  std::vector<std::int32_t> band;
  std::vector<std::int32_t> triangle2node(colours.size(), -1);
  for (std::size_t t = 0; t < colours.size(); ++t) {
    if (std::fabs(plane.height(topology.centroid[t])) > band_in_sizes * topology.size[t]) continue;
    triangle2node[t] = static_cast<std::int32_t>(band.size());
    band.push_back(static_cast<std::int32_t>(t));
  }
  const auto source = static_cast<std::int32_t>(band.size());  // left
  const std::int32_t sink = source + 1;                        // right
  FlowNetwork network(sink + 1);
  for (const std::int32_t t : band) {
    for (int e = 0; e < 3; ++e) {
      const HalfEdge h = half_edge(t, e);
      const std::int32_t neighbour = triangle_of(topology.twin[at(h)]);
      const std::int32_t other_node = triangle2node[at(neighbour)];
      if (other_node >= 0 && neighbour < t) continue;
      const double size = 0.5 * (topology.size[at(t)] + topology.size[at(neighbour)]);
      const std::int64_t capacity = to_capacity(
          sharpness(topology, h) *
          path_cost(subdomain.vertices[at(start_of(subdomain.triangles, h))],
                    subdomain.vertices[at(end_of(subdomain.triangles, h))], size, plane));
      const std::int32_t node = triangle2node[at(t)];
      if (other_node >= 0) {
        network.add_edge(node, other_node, capacity, capacity);
      } else if (colours[at(neighbour)] == Side::left) {
        network.add_edge(source, node, capacity, 0);
      } else {
        network.add_edge(node, sink, capacity, 0);
      }
    }
  }
  const std::vector<bool> is_left = network.source_side_of_minimum_cut(source, sink);
  TF_CHECK(is_left[at(source)] && !is_left[at(sink)]);
  for (const std::int32_t t : band) {
    colours[at(t)] = is_left[at(triangle2node[at(t)])] ? Side::left : Side::right;
  }
}

}  // namespace tetfarm
