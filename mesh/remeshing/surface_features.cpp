#include "mesh/remeshing/surface_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/disjoint_sets.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/surface_edges.h"
#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {
namespace {

/// A triangle lower than this share of its longest edge says nothing of the surface's direction.
constexpr double needle_share = 1e-4;
/// Edges of prisms with an angle equal to the wanted one to rounding are smooth, all of them.
constexpr double cosine_slack = 1e-6;
constexpr int most_needle_rounds = 20;

struct Direction {
  Vec3 normal;  ///< of unit length; zero: not known
  bool is_sure = false;
};

Direction direction_of(const SurfaceMesh& surface, const Triangle& t) {
  const Vec3 normal = sure_normal(triangle_points(surface.vertices, t), needle_share);
  return {normal, norm2(normal) > 0};
}

using Uses = std::span<const EdgeUse>;

double length2_of(const SurfaceMesh& surface, const EdgeUse& use) {
  return norm2(surface.vertices[static_cast<std::size_t>(use.high)] -
               surface.vertices[static_cast<std::size_t>(use.low)]);
}

/// Needles take the normal of the neighbour over their longest edge that has one, round by round.
std::vector<Direction> directions_of(const SurfaceMesh& surface, const std::vector<EdgeUse>& uses) {
  std::vector<Direction> directions;
  directions.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) directions.push_back(direction_of(surface, t));
  for (int round = 0; round < most_needle_rounds; ++round) {
    std::vector<std::pair<double, Vec3>> found(directions.size());
    bool has_found = false;
    for_each_edge(uses, [&](Uses edge) {
      if (edge.size() != 2) return;
      for (std::size_t i = 0; i < 2; ++i) {
        const auto needle = static_cast<std::size_t>(edge[i].triangle);
        const Direction& other = directions[static_cast<std::size_t>(edge[1 - i].triangle)];
        const double length2 = length2_of(surface, edge[i]);
        if (norm2(directions[needle].normal) > 0 || norm2(other.normal) == 0) continue;
        if (length2 <= found[needle].first) continue;
        found[needle] = {length2, other.normal};
        has_found = true;
      }
    });
    if (!has_found) break;
    for (std::size_t t = 0; t < directions.size(); ++t) {
      if (found[t].first > 0) directions[t].normal = found[t].second;
    }
  }
  return directions;
}

bool is_feature(const SurfaceMesh& surface, const std::vector<Direction>& directions, Uses edge,
                double least_cosine) {
  if (edge.size() != 2) return true;
  const auto a = static_cast<std::size_t>(edge[0].triangle);
  const auto b = static_cast<std::size_t>(edge[1].triangle);
  if (patch_of(surface, a) != patch_of(surface, b)) return true;
  if (sides_of(surface, a) != sides_of(surface, b)) return true;
  return dot(directions[a].normal, directions[b].normal) < least_cosine - cosine_slack;
}

/// Vertices without features round which two normals of triangles with sure ones differ by more.
std::vector<char> tips(const SurfaceMesh& surface, const std::vector<Direction>& directions,
                       double least_cosine) {
  std::vector<Vec3> sum(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!directions[t].is_sure) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      sum[static_cast<std::size_t>(v)] += directions[t].normal;
    }
  }
  std::vector<char> is_tip(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!directions[t].is_sure) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      const auto vertex = static_cast<std::size_t>(v);
      if (dot(normalized(sum[vertex]), directions[t].normal) < least_cosine) is_tip[vertex] = 1;
    }
  }
  return is_tip;
}

VertexKind kind_of(const SurfaceMesh& surface, std::size_t v, const std::vector<std::int32_t>& ends,
                   bool is_tip, double least_cosine) {
  if (ends.empty()) return is_tip ? VertexKind::corner : VertexKind::smooth;
  if (ends.size() != 2) return VertexKind::corner;
  const Vec3& at = surface.vertices[v];
  const Vec3 in = normalized(at - surface.vertices[static_cast<std::size_t>(ends[0])]);
  const Vec3 out = normalized(surface.vertices[static_cast<std::size_t>(ends[1])] - at);
  return dot(in, out) < least_cosine - cosine_slack ? VertexKind::corner : VertexKind::on_curve;
}

/// A curve's vertex at which the faces along the curve change is a corner.
void note_changes_of_faces(const SurfaceMesh& surface, const std::vector<EdgeUse>& uses,
                           SurfaceFeatures& features) {
  std::vector<std::vector<std::int32_t>> faces_of_vertex(surface.vertices.size());
  for_each_edge(uses, [&](Uses edge) {
    const std::array<std::int32_t, 2> ends{edge[0].low, edge[0].high};
    if (!std::ranges::binary_search(features.edges, ends)) return;
    std::vector<std::int32_t> faces;
    for (const EdgeUse& use : edge) {
      faces.push_back(features.face[static_cast<std::size_t>(use.triangle)]);
    }
    std::ranges::sort(faces);
    for (const std::int32_t v : ends) {
      const auto vertex = static_cast<std::size_t>(v);
      if (features.kind[vertex] != VertexKind::on_curve) continue;
      if (faces_of_vertex[vertex].empty()) {
        faces_of_vertex[vertex] = faces;
      } else if (faces_of_vertex[vertex] != faces) {
        features.kind[vertex] = VertexKind::corner;
      }
    }
  });
}

}  // namespace

SurfaceFeatures surface_features(const SurfaceMesh& surface, double angle_deg) {
  const double least_cosine = std::cos(angle_deg * std::numbers::pi / 180);
  const std::vector<EdgeUse> uses = edge_uses(surface.triangles);
  const std::vector<Direction> directions = directions_of(surface, uses);
  SurfaceFeatures features;
  DisjointSets sets(surface.triangles.size());
  std::vector<std::vector<std::int32_t>> ends(surface.vertices.size());
  for_each_edge(uses, [&](Uses edge) {
    if (!is_feature(surface, directions, edge, least_cosine)) {
      sets.join(static_cast<std::size_t>(edge[0].triangle),
                static_cast<std::size_t>(edge[1].triangle));
      return;
    }
    features.edges.push_back({edge[0].low, edge[0].high});
    ends[static_cast<std::size_t>(edge[0].low)].push_back(edge[0].high);
    ends[static_cast<std::size_t>(edge[0].high)].push_back(edge[0].low);
  });
  features.face_count = sets.number(features.face);
  const std::vector<char> is_tip = tips(surface, directions, least_cosine);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    features.kind.push_back(kind_of(surface, v, ends[v], is_tip[v] != 0, least_cosine));
  }
  note_changes_of_faces(surface, uses, features);
  return features;
}

}  // namespace tetfarm
