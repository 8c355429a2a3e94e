#include "mesh/layers/pml_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/array_index.h"
#include "base/check.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/marching_direction.h"
#include "mesh/layers/wall_graph.h"
#include "mesh/layers/wall_shells.h"

namespace tetfarm {
namespace {

constexpr const char* place = "absorbing layers";

/// Where planes or a cone would move a vertex by more than this, the layers would be needles.
constexpr double longest_way = 10;
/// Three planes are taken for planes where their corner moves by no more than this; it does by the
/// square root of 3 where they are at right angles.
constexpr double longest_corner = 4;
/// A sphere's faces look away from its centre.
constexpr double least_facing = 0.9;

void require_outside(const SurfaceMesh& surface, const ClosedShell& shell) {
  if (enclosed_volume(surface.vertices, shell.triangles) > 0) return;
  throw UsageError("the shell with the vertex at " +
                       text_of(surface.vertices[at(shell.vertices.front())]) +
                       " bounds a hole in the domain; they grow on the outside of the domain only",
                   place);
}

using Equations = std::array<std::array<double, 5>, 4>;  // the last column is the right side

/// By elimination with pivots; nothing where they have no single answer.
std::optional<std::array<double, 4>> solution_of(Equations m) {
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 4; ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    if (std::abs(m[pivot][k]) < 1e-12) return std::nullopt;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = k + 1; i < 4; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 5; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  std::array<double, 4> x{};
  for (std::size_t k = 4; k-- > 0;) {
    double sum = m[k][4];
    for (std::size_t j = k + 1; j < 4; ++j) sum -= m[k][j] * x[j];
    x[k] = sum / m[k][k];
  }
  return x;
}

/// The centre of the sphere that the points lie on in the sense of least squares of |p|² = 2 c·p +
/// d, in coordinates in which they are about 1 away from 0.
std::optional<Vec3> fitted_centre(const std::vector<Vec3>& points) {
  Vec3 mean;
  for (const Vec3& p : points) mean += p;
  mean = mean / static_cast<double>(points.size());
  double scale = 0;
  for (const Vec3& p : points) scale = std::max(scale, distance(p, mean));
  if (scale == 0) return std::nullopt;
  Equations sums{};
  for (const Vec3& p : points) {
    const Vec3 q = (p - mean) / scale;
    const std::array<double, 5> row = {q.x, q.y, q.z, 1, norm2(q)};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 5; ++j) {
        sums[i][j] += row[i] * row[j] / static_cast<double>(points.size());
      }
    }
  }
  const auto x = solution_of(sums);
  if (!x) return std::nullopt;
  return mean + 0.5 * scale * Vec3{(*x)[0], (*x)[1], (*x)[2]};
}

/// Of a shell that is a sphere in triangles; nothing of any other, such as a box, whose corners lie
/// on a sphere as well.
std::optional<Vec3> centre_of_sphere(const SurfaceMesh& surface, const ClosedShell& shell) {
  std::vector<Vec3> points;
  for (const std::int32_t v : shell.vertices) points.push_back(surface.vertices[at(v)]);
  const std::optional<Vec3> centre = fitted_centre(points);
  if (!centre) return std::nullopt;
  const double radius = distance(points.front(), *centre);
  for (const Vec3& p : points) {
    if (std::abs(distance(p, *centre) - radius) > sphere_tolerance * radius) return std::nullopt;
  }
  for (const Triangle& t : shell.triangles) {
    const Vec3 normal = outward_normal(surface, t);
    for (const std::int32_t v : t) {
      if (dot(normal, normalized(surface.vertices[at(v)] - *centre)) < least_facing) {
        return std::nullopt;
      }
    }
  }
  return centre;
}

std::vector<Vec3> planes_among(const std::vector<Vec3>& normals) {
  std::vector<Vec3> planes;
  for (const Vec3& normal : normals) {
    const bool is_known = std::any_of(planes.begin(), planes.end(), [&](const Vec3& plane) {
      return dot(plane, normal) > 0 && norm(cross(plane, normal)) < same_plane_sine;
    });
    if (!is_known) planes.push_back(normal);
  }
  return planes;
}

/// The shortest way that moves one to three planes by 1; nothing where it is too long for them to
/// be the planes of a corner.
std::optional<Vec3> way_of_planes(const std::vector<Vec3>& planes) {
  TF_CHECK(!planes.empty());
  if (planes.size() == 1) return planes[0];
  Vec3 sum = planes[0] + planes[1];
  double scale = 1 + dot(planes[0], planes[1]);
  if (planes.size() == 3) {
    sum = cross(planes[1], planes[2]) + cross(planes[2], planes[0]) + cross(planes[0], planes[1]);
    scale = dot(planes[0], cross(planes[1], planes[2]));
  }
  if (planes.size() > 3 || norm(sum) > longest_corner * std::abs(scale)) return std::nullopt;
  return sum / scale;
}

Vec3 way_outwards(const std::vector<Vec3>& normals, const Vec3& vertex) {
  const std::vector<Vec3> planes = planes_among(normals);
  if (const std::optional<Vec3> way = way_of_planes(planes)) return *way;
  const MarchingDirection cone = marching_direction(planes);
  if (cone.visibility * longest_way < 1) {
    throw UsageError("no single direction sees all faces at the vertex at " + text_of(vertex) +
                         "; the outer boundary has to be smoother there, or a box or a sphere",
                     place);
  }
  return cone.direction / cone.visibility;
}

void add_directions(const SurfaceMesh& surface, const WallGraph& graph, const ClosedShell& shell,
                    std::vector<Vec3>& directions) {
  if (const std::optional<Vec3> centre = centre_of_sphere(surface, shell)) {
    for (const std::int32_t v : shell.vertices) {
      directions[at(v)] = normalized(surface.vertices[at(v)] - *centre);
    }
    return;
  }
  for (const std::int32_t v : shell.vertices) {
    std::vector<Vec3> normals;
    for (const std::int32_t f : graph.faces.of(graph.vertex2line[at(v)])) {
      normals.push_back(outward_normal(surface, surface.triangles[at(graph.wall[at(f)])]));
    }
    directions[at(v)] = way_outwards(normals, surface.vertices[at(v)]);
  }
}

}  // namespace

std::vector<Vec3> pml_directions(const SurfaceMesh& surface,
                                 std::span<const std::int32_t> patches) {
  TF_CHECK(std::is_sorted(patches.begin(), patches.end()));
  const WallGraph graph = graph_of_whole_shells(surface, patches);
  std::vector<Vec3> directions(surface.vertices.size());
  for (const ClosedShell& shell : shells_of(surface, graph)) {
    require_outside(surface, shell);
    add_directions(surface, graph, shell, directions);
  }
  return directions;
}

SurfaceMesh moved_outwards(const SurfaceMesh& surface, std::span<const Vec3> directions,
                           double thickness) {
  TF_CHECK(directions.size() == surface.vertices.size() && thickness > 0);
  SurfaceMesh moved = surface;
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (directions[v] == Vec3{}) continue;
    moved.vertices[v] += thickness * directions[v];
  }
  const CheckedSurface checked = check_surface({moved.vertices, moved.triangles, {}, {}, {}, {}});
  const auto fail = [&](std::size_t triangle, const std::string& what) {
    throw UsageError("the outer boundary cannot be moved outwards by " + text_of(thickness) +
                         ", the thickness of all layers: triangle " + std::to_string(triangle) +
                         " at " + text_of(surface.vertices[at(surface.triangles[triangle][0])]) +
                         " would " + what +
                         "; give fewer or lower layers, or a convex outer boundary",
                     place);
  };
  for (const SurfaceDefect& defect : checked.report.defects) {
    TF_CHECK(!defect.triangles.empty());
    fail(static_cast<std::size_t>(defect.triangles.front()),
         "be part of a " + defect.kind + " of " + counted(defect.triangles.size(), "triangle"));
  }
  for (std::size_t t = 0; t < moved.triangles.size(); ++t) {
    if (checked.surface.triangles[t] != moved.triangles[t]) fail(t, "be turned over");
  }
  return moved;
}

}  // namespace tetfarm
