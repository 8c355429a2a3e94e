#include "mesh/assemble/forced_dihedral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "mesh/core/subdomain_regions.h"
#include "mesh/core/tet_quality.h"

namespace tetfarm {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

/// An edge of a triangle as it runs there, and the triangle's third node.
struct HalfEdge {
  std::int32_t low;
  std::int32_t high;
  bool is_rising;
  std::int32_t third;

  friend bool operator<(const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.is_rising, a.third) <
           std::tie(b.low, b.high, b.is_rising, b.third);
  }
  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(std::span<const Triangle> triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [u, v, third] : {std::array{a, b, c}, {b, c, a}, {c, a, b}}) {
      edges.push_back({std::min(u, v), std::max(u, v), u < v, third});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The angle of the material at edge uv, 0 to 360.
double material_angle_deg(const Vec3& u, const Vec3& v, const Vec3& left, const Vec3& right) {
  const Vec3 along = normalized(v - u);
  const Vec3 inwards = -normalized(cross(v - u, left - u));
  const Vec3 to_left = normalized((left - u) - dot(left - u, along) * along);
  const Vec3 to_right = right - u;
  const double angle = std::atan2(dot(to_right, inwards), dot(to_right, to_left));
  return (angle < 0 ? angle + 2 * std::numbers::pi : angle) * degrees_per_radian;
}

}  // namespace

double forced_dihedral_at_edge(const Vec3& u, const Vec3& v, const Vec3& left, const Vec3& right) {
  const double angle = material_angle_deg(u, v, left, right);
  const double of_two = angle / 2;
  // Most edges of a surface are nearly flat: what one tet would have does not matter there.
  if (of_two >= ForcedDihedral{}.at_most_deg) return ForcedDihedral{}.at_most_deg;
  // Inverted or flat, when there is no such tet: 0.
  const double of_one = dihedral_range(u, left, v, right).min_deg;
  return std::min(ForcedDihedral{}.at_most_deg, std::max(of_one, of_two));
}

void for_each_edge_of_two(std::span<const Triangle> triangles,
                          const std::function<void(const EdgeOfTwo&)>& visit) {
  const std::vector<HalfEdge> edges = sorted_half_edges(triangles);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t end = first + 1;
    while (end < edges.size() && edges[end].same_edge(edges[first])) ++end;
    const HalfEdge& falling = edges[first];
    const HalfEdge& rising = edges[end - 1];
    const bool has_two = end - first == 2 && rising.is_rising && !falling.is_rising;
    first = end;
    if (has_two) visit({rising.low, rising.high, rising.third, falling.third});
  }
}

ForcedDihedral forced_dihedral(std::span<const Vec3> nodes, std::span<const Triangle> boundary) {
  const auto at = [&nodes](std::int32_t v) { return nodes[static_cast<std::size_t>(v)]; };
  ForcedDihedral forced;
  for_each_edge_of_two(boundary, [&](const EdgeOfTwo& edge) {
    const Vec3 u = at(edge.u);
    const Vec3 v = at(edge.v);
    const double bound = forced_dihedral_at_edge(u, v, at(edge.left), at(edge.right));
    if (bound < forced.at_most_deg) forced = {bound, 0.5 * (u + v)};
  });
  return forced;
}

ForcedDihedral forced_dihedral(const SurfaceMesh& surface) {
  const Subdomain root = root_subdomain(surface);
  ForcedDihedral smallest;
  for (const std::int32_t region : regions_of(root)) {
    const ForcedDihedral forced = forced_dihedral(root.vertices, triangles_out_of(root, region));
    if (forced.at_most_deg < smallest.at_most_deg) smallest = forced;
  }
  return smallest;
}

}  // namespace tetfarm
