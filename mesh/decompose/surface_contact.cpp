#include "mesh/decompose/surface_contact.h"

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/triangle_intersection.h"

namespace tetfarm {
namespace {

Closest closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = norm2(ab);
  const double t = length2 > 0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  const Vec3 q = a + t * ab;
  return {q, norm2(p - q)};
}

/// All points in one array, as the exact test wants them: the sub-domain's, then the new nodes.
struct CombinedPoints {
  std::vector<Vec3> points;
  std::vector<std::int32_t> node2point;
};

CombinedPoints combine_points(const InterdomainMesh& mesh, const Subdomain& subdomain) {
  CombinedPoints combined{subdomain.vertices, {}};
  const auto nodes = static_cast<std::int32_t>(mesh.planar.points.size());
  for (std::int32_t i = 0; i < nodes; ++i) {
    if (mesh.is_rim_node(i)) {
      combined.node2point.push_back(mesh.rim_vertices[at(i)]);
    } else {
      combined.node2point.push_back(static_cast<std::int32_t>(combined.points.size()));
      combined.points.push_back(node_position(mesh, subdomain, i));
    }
  }
  return combined;
}

bool share_a_node(const Triangle& a, const Triangle& b) {
  return std::any_of(a.begin(), a.end(),
                     [&b](std::int32_t v) { return v == b[0] || v == b[1] || v == b[2]; });
}

Box3 grown(const Box3& box, double margin) {
  return {box.low - Vec3{margin, margin, margin}, box.high + Vec3{margin, margin, margin}};
}

/// The squared distance of points from a triangle, or infinity where its plane or its box is
/// farther away than `within`: most are.
class NearTriangle {
 public:
  NearTriangle(const Vec3& a, const Vec3& b, const Vec3& c, double within)
      : a_(a), b_(b), c_(c), normal_(cross(b - a, c - a)) {
    constexpr double rounding = 1.01;
    most_height2_ = rounding * within * within * norm2(normal_);
    for (const Vec3& corner : {a, b, c}) box_.add(corner);
    box_ = grown(box_, rounding * within);
  }
  double distance2(const Vec3& p) const {
    if (!box_.overlaps({p, p})) return HUGE_VAL;
    const double height = dot(p - a_, normal_);
    if (height * height > most_height2_) return HUGE_VAL;
    return closest_in_triangle(p, a_, b_, c_).distance2;
  }

 private:
  Vec3 a_, b_, c_;
  Vec3 normal_;
  double most_height2_;
  Box3 box_;
};

/// Exact where it is less than `within`.
double squared_distance(const std::vector<Vec3>& points, const Triangle& cut,
                        const Triangle& surface, std::int32_t first_new, bool is_at_rim,
                        double within) {
  const auto place_of = [&points](std::int32_t v) { return points[at(v)]; };
  double distance2 = HUGE_VAL;
  const NearTriangle near_surface(place_of(surface[0]), place_of(surface[1]), place_of(surface[2]),
                                  within);
  for (const std::int32_t v : cut) {
    if (v >= first_new) distance2 = std::min(distance2, near_surface.distance2(place_of(v)));
  }
  if (is_at_rim) return distance2;
  const NearTriangle near_cut(place_of(cut[0]), place_of(cut[1]), place_of(cut[2]), within);
  for (const std::int32_t v : surface) {
    distance2 = std::min(distance2, near_cut.distance2(place_of(v)));
  }
  return distance2;
}

double largest_spacing(const InterdomainMesh& mesh, const std::array<std::int32_t, 3>& triangle) {
  return std::max({mesh.spacing[at(triangle[0])], mesh.spacing[at(triangle[1])],
                   mesh.spacing[at(triangle[2])]});
}

Box3 box_of(const InterdomainMesh& mesh, const Subdomain& subdomain,
            const std::array<std::int32_t, 3>& triangle) {
  Box3 box;
  for (const std::int32_t v : triangle) box.add(node_position(mesh, subdomain, v));
  return box;
}

}  // namespace

Closest closest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const bool is_above = dot(cross(b - a, p - a), normal) > 0 &&
                        dot(cross(c - b, p - b), normal) > 0 &&
                        dot(cross(a - c, p - c), normal) > 0;
  if (is_above) {
    const double height = dot(p - a, normal) / norm2(normal);
    return {p - height * normal, height * height * norm2(normal)};
  }
  Closest best = closest_on_segment(p, a, b);
  for (const Closest& other : {closest_on_segment(p, b, c), closest_on_segment(p, c, a)}) {
    if (other.distance2 < best.distance2) best = other;
  }
  return best;
}

NearbySurface find_nearby_surface(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                  const SurfaceTopology& topology, double margin) {
  std::vector<Box3> cut_boxes;
  cut_boxes.reserve(mesh.planar.triangles.size());
  for (const auto& triangle : mesh.planar.triangles) {
    cut_boxes.push_back(box_of(mesh, subdomain, triangle));
  }
  const BoxTree cut_tree(cut_boxes);
  NearbySurface nearby;
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    Box3 box;
    for (const std::int32_t v : subdomain.triangles[t]) box.add(subdomain.vertices[at(v)]);
    const Box3 neighbourhood = grown(box, margin * topology.size[t]);
    if (!cut_tree.any(neighbourhood, [](std::int32_t) { return true; })) continue;
    nearby.triangles.push_back(static_cast<std::int32_t>(t));
    nearby.boxes.push_back(box);
  }
  nearby.tree = BoxTree(nearby.boxes);
  return nearby;
}

std::vector<SurfaceContact> find_contacts(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                          const SurfaceTopology& topology,
                                          const NearbySurface& nearby, double reach,
                                          std::size_t most) {
  TF_CHECK(nearby.boxes.size() == nearby.triangles.size());
  const CombinedPoints combined = combine_points(mesh, subdomain);
  const auto& node2point = combined.node2point;
  TF_CHECK(node2point.size() == mesh.planar.points.size());
  std::vector<bool> is_rim_vertex(subdomain.vertices.size(), false);
  for (const std::int32_t v : mesh.rim_vertices) is_rim_vertex[at(v)] = true;
  const auto first_new = static_cast<std::int32_t>(subdomain.vertices.size());
  std::vector<SurfaceContact> contacts;
  for (std::size_t i = 0; i < mesh.planar.triangles.size() && contacts.size() <= most; ++i) {
    const auto& [a, b, c] = mesh.planar.triangles[i];
    const Triangle cut = {node2point[at(a)], node2point[at(b)], node2point[at(c)]};
    const double h = largest_spacing(mesh, mesh.planar.triangles[i]);
    const Box3 box = box_of(mesh, subdomain, mesh.planar.triangles[i]);
    nearby.tree.query(grown(box, reach * h), [&](std::int32_t near) {
      const std::int32_t s = nearby.triangles[at(near)];
      const Triangle& surface = subdomain.triangles[at(s)];
      const double unit = std::min(h, topology.size[at(s)]);
      if (!grown(box, reach * unit).overlaps(nearby.boxes[at(near)])) return;
      SurfaceContact contact{static_cast<std::int32_t>(i), s, false, false, HUGE_VAL, unit};
      contact.is_at_rim = std::any_of(surface.begin(), surface.end(),
                                      [&](std::int32_t v) { return is_rim_vertex[at(v)]; });
      contact.meets = triangles_meet_beyond_shared(combined.points, cut, surface);
      if (contact.meets) {
        contact.distance = 0;
      } else if (!share_a_node(cut, surface)) {
        const double distance2 = squared_distance(combined.points, cut, surface, first_new,
                                                  contact.is_at_rim, reach * unit);
        contact.distance = std::sqrt(distance2) / unit;
      }
      if (contact.distance < reach) contacts.push_back(contact);
    });
  }
  return contacts;
}

}  // namespace tetfarm
