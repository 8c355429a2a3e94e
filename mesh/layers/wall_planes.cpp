#include "mesh/layers/wall_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// So far from its plane a point of a flat piece may be, as a share of the largest coordinate of
/// its patch: many files of text have six digits.
constexpr double flatness = 1e-5;

/// So much further from the plane of a single triangle, which is known less well.
constexpr double flatness_of_seed = 100;

/// Of the angle that counts as a ridge, between two planes or within a patch: 20 degrees.
constexpr double cos_of_ridge = 0.9396926207859084;

constexpr std::int32_t not_asked = -1;  // of triangles that no plane has been found for yet

/// Twice the area, along the normal.
Vec3 area_vector(const SurfaceMesh& surface, std::int32_t triangle) {
  const Triangle& t = surface.triangles[at(triangle)];
  const Vec3 a = surface.vertices[at(t[0])];
  return cross(surface.vertices[at(t[1])] - a, surface.vertices[at(t[2])] - a);
}

/// Across each edge of a triangle, the triangle there. @pre the surface is closed and of one
/// region.
std::vector<std::array<std::int32_t, 3>> neighbours_of(const SurfaceMesh& surface) {
  struct Edge {
    std::int32_t low, high, triangle, corner;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;
  edges.reserve(surface.triangles.size() * 3);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::int32_t k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(surface.triangles[t][at(k)], surface.triangles[t][at((k + 1) % 3)]);
      edges.push_back({low, high, static_cast<std::int32_t>(t), k});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::int32_t, 3>> neighbours(surface.triangles.size(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge& a = edges[i];
    const Edge& b = edges[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    neighbours[at(a.triangle)][at(a.corner)] = b.triangle;
    neighbours[at(b.triangle)][at(b.corner)] = a.triangle;
  }
  return neighbours;
}

/// Finds the flat pieces of the patches that border the wall.
class PlaneSearch {
 public:
  PlaneSearch(const SurfaceMesh& surface, const WallGraph& graph)
      : surface_(surface),
        neighbours_(neighbours_of(surface)),
        is_wall_(surface.triangles.size(), false),
        piece_of_(surface.triangles.size(), not_asked) {
    for (const std::int32_t t : graph.wall) is_wall_[at(t)] = true;
    find_patches();
  }

  void find(WallPlanes& found) {
    for (const std::int32_t seed : seeds()) {
      if (piece_of_[at(seed)] != not_asked) continue;
      WallPlane plane = flood(seed);
      if (!is_flat(plane) || !ends_at_ridges(plane) || !borders_wall(plane)) continue;
      take_axis(plane);
      find_border(plane);
      for (const std::int32_t t : plane.triangles) {
        found.plane_of_triangle[at(t)] = static_cast<std::int32_t>(found.planes.size());
      }
      found.planes.push_back(std::move(plane));
    }
  }

 private:
  void find_patches() {
    const std::size_t patches = std::max<std::size_t>(1, surface_.patch_names.size());
    tolerance_.assign(patches, 0);
    borders_.assign(patches, false);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      if (is_wall_[t]) continue;
      for (const std::int32_t v : surface_.triangles[t]) {
        double& tolerance = tolerance_[at(patch_of(surface_, t))];
        for (int axis = 0; axis < 3; ++axis) {
          tolerance = std::max(tolerance, flatness * std::abs(surface_.vertices[at(v)][axis]));
        }
      }
      for (const std::int32_t n : neighbours_[t]) {
        if (n >= 0 && is_wall_[at(n)]) borders_[at(patch_of(surface_, t))] = true;
      }
    }
  }

  /// Triangles of the patches that border the wall, the largest first: they know best how their
  /// plane lies.
  std::vector<std::int32_t> seeds() const {
    std::vector<std::pair<double, std::int32_t>> by_area;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      const auto triangle = static_cast<std::int32_t>(t);
      if (is_wall_[t] || !borders_[at(patch_of(surface_, t))]) continue;
      by_area.emplace_back(-norm2(area_vector(surface_, triangle)), triangle);
    }
    std::sort(by_area.begin(), by_area.end());
    std::vector<std::int32_t> seeds;
    for (const auto& [area, triangle] : by_area) seeds.push_back(triangle);
    return seeds;
  }

  bool lies_in(const WallPlane& plane, std::int32_t triangle, double tolerance) const {
    const Triangle& nodes = surface_.triangles[at(triangle)];
    return dot(area_vector(surface_, triangle), plane.normal) > 0 &&
           std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t v) {
             return std::abs(dot(plane.normal, surface_.vertices[at(v)] - plane.at)) <= tolerance;
           });
  }

  WallPlane flood(std::int32_t seed) {
    WallPlane plane;
    plane.patch = patch_of(surface_, at(seed));
    plane.normal = normalized(area_vector(surface_, seed));
    plane.at = surface_.vertices[at(surface_.triangles[at(seed)][0])];
    const double loose = flatness_of_seed * tolerance_[at(plane.patch)];
    const std::int32_t piece = next_piece_++;
    piece_of_[at(seed)] = piece;
    plane.triangles = {seed};
    for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
      for (const std::int32_t n : neighbours_[at(plane.triangles[i])]) {
        if (n < 0 || is_wall_[at(n)] || piece_of_[at(n)] != not_asked) continue;
        if (patch_of(surface_, at(n)) != plane.patch || !lies_in(plane, n, loose)) continue;
        piece_of_[at(n)] = piece;
        plane.triangles.push_back(n);
      }
    }
    std::sort(plane.triangles.begin(), plane.triangles.end());
    fit(plane);
    return plane;
  }

  /// To all of its triangles, each by its area.
  void fit(WallPlane& plane) const {
    Vec3 normal;
    Vec3 moment;
    double area = 0;
    for (const std::int32_t t : plane.triangles) {
      const Vec3 vector = area_vector(surface_, t);
      const double twice = norm(vector);
      normal += vector;
      area += twice;
      for (const std::int32_t v : surface_.triangles[at(t)]) {
        moment += twice / 3 * surface_.vertices[at(v)];
      }
    }
    plane.normal = normalized(normal);
    plane.at = moment / area;
  }

  bool is_flat(const WallPlane& plane) const {
    return std::all_of(plane.triangles.begin(), plane.triangles.end(), [&](std::int32_t t) {
      return lies_in(plane, t, tolerance_[at(plane.patch)]);
    });
  }

  bool ends_at_ridges(const WallPlane& plane) const {
    const std::int32_t piece = piece_of_[at(plane.triangles.front())];
    return std::all_of(plane.triangles.begin(), plane.triangles.end(), [&](std::int32_t t) {
      return std::all_of(neighbours_[at(t)].begin(), neighbours_[at(t)].end(), [&](std::int32_t n) {
        if (n < 0 || is_wall_[at(n)] || piece_of_[at(n)] == piece) return true;
        if (patch_of(surface_, at(n)) != plane.patch) return true;
        return dot(normalized(area_vector(surface_, n)), plane.normal) <= cos_of_ridge;
      });
    });
  }

  bool borders_wall(const WallPlane& plane) const {
    return std::any_of(plane.triangles.begin(), plane.triangles.end(), [&](std::int32_t t) {
      return std::any_of(neighbours_[at(t)].begin(), neighbours_[at(t)].end(),
                         [&](std::int32_t n) { return n >= 0 && is_wall_[at(n)]; });
    });
  }

  void find_border(WallPlane& plane) const {
    const std::int32_t piece = piece_of_[at(plane.triangles.front())];
    for (const std::int32_t t : plane.triangles) {
      const Triangle& nodes = surface_.triangles[at(t)];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t across = neighbours_[at(t)][k];
        if (across >= 0 && piece_of_[at(across)] == piece) continue;
        plane.border.push_back({{nodes[k], nodes[(k + 1) % 3]}, across});
      }
    }
  }

  void take_axis(WallPlane& plane) const {
    const Vec3 first =
        surface_.vertices[at(surface_.triangles[at(plane.triangles.front())].front())];
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_common =
          std::all_of(plane.triangles.begin(), plane.triangles.end(), [&](std::int32_t t) {
            const Triangle& nodes = surface_.triangles[at(t)];
            return std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t v) {
              return surface_.vertices[at(v)][axis] == first[axis];
            });
          });
      if (!is_common) continue;
      plane.axis = axis;
      plane.at = first;
      const double sign = plane.normal[axis] > 0 ? 1 : -1;
      plane.normal = {};
      plane.normal[axis] = sign;
    }
  }

  const SurfaceMesh& surface_;
  std::vector<std::array<std::int32_t, 3>> neighbours_;
  std::vector<bool> is_wall_;
  std::vector<std::int32_t> piece_of_;  // of each triangle
  std::int32_t next_piece_ = 0;
  std::vector<bool> borders_;      // of each patch, whether the wall is next to it
  std::vector<double> tolerance_;  // of each patch
};

/// Two axes of a plane, which turn with its normal.
std::array<Vec3, 2> axes_of(const WallPlane& plane) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(plane.normal[k]) < std::abs(plane.normal[least])) least = k;
  }
  Vec3 unit;
  unit[least] = 1;
  const Vec3 first = normalized(cross(unit, plane.normal));
  return {first, cross(plane.normal, first)};
}

/// The coordinates that a plane with an axis is drawn in.
std::array<int, 2> coordinates_of(const WallPlane& plane) {
  const int next = (plane.axis + 1) % 3;
  const int last = (plane.axis + 2) % 3;
  return plane.normal[plane.axis] > 0 ? std::array{next, last} : std::array{last, next};
}

Vec3 image(const Vec3& vector, const WallPlane& plane) {
  return vector - 2 * dot(vector, plane.normal) * plane.normal;
}

/// What a line at the border may run in, by the planes of the triangles round its foot.
void add_plane(std::int32_t plane, PlanesOfLine& planes, bool& is_free) {
  if (plane < 0) is_free = false;
  if (plane < 0 || planes[0] == plane || planes[1] == plane) return;
  if (planes[0] < 0) {
    planes[0] = plane;
  } else if (planes[1] < 0) {
    planes[1] = plane;
  } else {
    is_free = false;
  }
}

}  // namespace

Vec3 WallPlane::along(const Vec3& direction) const {
  Vec3 part = direction - dot(direction, normal) * normal;
  if (axis >= 0) part[axis] = 0;
  return part;
}

Vec2 WallPlane::project(const Vec3& point) const {
  if (axis >= 0) {
    const auto [u, v] = coordinates_of(*this);
    return {point[u], point[v]};
  }
  const auto [u, v] = axes_of(*this);
  return {dot(u, point - at), dot(v, point - at)};
}

Vec3 WallPlane::lift(const Vec2& point) const {
  if (axis >= 0) {
    const auto [u, v] = coordinates_of(*this);
    Vec3 lifted = at;
    lifted[u] = point.x;
    lifted[v] = point.y;
    return lifted;
  }
  const auto [u, v] = axes_of(*this);
  return at + point.x * u + point.y * v;
}

Vec3 WallPlanes::held(std::size_t line, const Vec3& direction) const {
  const auto [first, second] = of_line[line];
  if (first < 0) return direction;
  if (second < 0) return normalized(planes[at(first)].along(direction));
  const Vec3 way = normalized(cross(planes[at(first)].normal, planes[at(second)].normal));
  const double share = dot(direction, way);
  if (share == 0) return {};
  return share > 0 ? way : -way;
}

WallPlanes wall_planes(const SurfaceMesh& surface, const WallGraph& graph) {
  WallPlanes found;
  found.plane_of_triangle.assign(surface.triangles.size(), -1);
  found.of_line.assign(graph.feet.size(), no_planes);
  if (std::none_of(graph.at_border.begin(), graph.at_border.end(), [](bool b) { return b; })) {
    return found;
  }
  PlaneSearch(surface, graph).find(found);
  std::vector<bool> is_free = graph.at_border;
  std::vector<bool> is_wall(surface.triangles.size(), false);
  for (const std::int32_t t : graph.wall) is_wall[at(t)] = true;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_wall[t]) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      const std::int32_t line = graph.vertex2line[at(v)];
      if (line < 0) continue;
      bool still_free = is_free[at(line)];
      add_plane(found.plane_of_triangle[t], found.of_line[at(line)], still_free);
      is_free[at(line)] = still_free;
    }
  }
  for (std::size_t i = 0; i < found.of_line.size(); ++i) {
    const auto [first, second] = found.of_line[i];
    if (is_free[i] && second >= 0) {
      const double cosine = dot(found.planes[at(first)].normal, found.planes[at(second)].normal);
      is_free[i] = std::abs(cosine) <= cos_of_ridge;
    }
    if (!is_free[i]) found.of_line[i] = no_planes;
    // Triangles lead to the first line of a foot alone.
    if (i > 0 && graph.feet[i] == graph.feet[i - 1]) found.of_line[i] = found.of_line[i - 1];
  }
  TF_CHECK(found.plane_of_triangle.size() == surface.triangles.size());
  return found;
}

std::vector<Vec3> with_images(std::vector<Vec3> normals, const WallPlanes& planes,
                              std::size_t line) {
  for (const std::int32_t plane : planes.of_line[line]) {
    if (plane < 0) continue;
    const std::size_t own = normals.size();
    for (std::size_t i = 0; i < own; ++i)
      normals.push_back(image(normals[i], planes.planes[at(plane)]));
  }
  return normals;
}

}  // namespace tetfarm
