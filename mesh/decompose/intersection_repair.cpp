#include "mesh/decompose/intersection_repair.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

/// Heights that nodes are asked to take; the strongest wish of each side's surface counts.
class Pushes {
 public:
  Pushes(const InterdomainMesh& mesh, const PushOptions& options,
         std::vector<std::optional<double>>& targets)
      : mesh_(mesh), options_(options), targets_(targets) {
    targets_.resize(mesh.planar.points.size());
  }

  bool push(std::int32_t node, double wanted, bool upward) {
    const double height = mesh_.heights[at(node)];
    if (upward ? height >= wanted : height <= wanted) return false;
    if (std::fabs(wanted - height) > options_.farthest * mesh_.spacing[at(node)]) return false;
    std::optional<double>& target = targets_[at(node)];
    if (target) wanted = upward ? std::max(*target, wanted) : std::min(*target, wanted);
    if (target == wanted) return false;
    target = wanted;
    return true;
  }

 private:
  const InterdomainMesh& mesh_;
  const PushOptions& options_;
  std::vector<std::optional<double>>& targets_;
};

/// Takes the new nodes of the cut triangle to `options.to` from the surface triangle.
bool push_nodes_off_surface(const InterdomainMesh& mesh, const Subdomain& subdomain,
                            const SurfaceContact& contact, bool upward, const PushOptions& options,
                            Pushes& pushes) {
  const auto& [a, b, c] = subdomain.triangles[at(contact.surface_triangle)];
  bool has_moved = false;
  for (const std::int32_t node : mesh.planar.triangles[at(contact.cut_triangle)]) {
    if (mesh.is_rim_node(node)) continue;
    const Closest closest =
        closest_in_triangle(node_position(mesh, subdomain, node), subdomain.vertices[at(a)],
                            subdomain.vertices[at(b)], subdomain.vertices[at(c)]);
    const double far = options.to * mesh.spacing[at(node)];
    const double surface_height = mesh.plane.height(closest.point);
    const double above = mesh.heights[at(node)] - surface_height;
    const double aside2 = std::max(0.0, closest.distance2 - above * above);
    if (aside2 >= far * far) continue;
    const double clear = std::sqrt(far * far - aside2);
    has_moved |=
        pushes.push(node, upward ? surface_height + clear : surface_height - clear, upward);
  }
  return has_moved;
}

/// Coordinates of p as a weighted mean of the corners; nothing when p lies outside.
std::optional<std::array<double, 3>> weights_in_triangle(const Vec2& p, const Vec2& a,
                                                         const Vec2& b, const Vec2& c) {
  const auto twice_area = [](const Vec2& q, const Vec2& r, const Vec2& s) {
    return (r.x - q.x) * (s.y - q.y) - (r.y - q.y) * (s.x - q.x);
  };
  const double whole = twice_area(a, b, c);
  const std::array<double, 3> weights = {twice_area(b, c, p) / whole, twice_area(c, a, p) / whole,
                                         twice_area(a, b, p) / whole};
  if (!(weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0)) return std::nullopt;
  return weights;
}

/// Takes the cut triangle clear of those corners of the surface triangle that lie above or below
/// it.
bool push_triangle_off_corners(const InterdomainMesh& mesh, const Subdomain& subdomain,
                               const SurfaceContact& contact, bool upward, double clear,
                               Pushes& pushes) {
  constexpr double least_hold = 0.1;  // of the new nodes on the height at that corner
  const auto& nodes = mesh.planar.triangles[at(contact.cut_triangle)];
  bool has_moved = false;
  for (const std::int32_t v : subdomain.triangles[at(contact.surface_triangle)]) {
    const Vec3& corner = subdomain.vertices[at(v)];
    const auto weights =
        weights_in_triangle(mesh.plane.project(corner), mesh.planar.points[at(nodes[0])],
                            mesh.planar.points[at(nodes[1])], mesh.planar.points[at(nodes[2])]);
    if (!weights) continue;
    double height = 0;
    double hold = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      height += (*weights)[k] * mesh.heights[at(nodes[k])];
      if (!mesh.is_rim_node(nodes[k])) hold += (*weights)[k] * (*weights)[k];
    }
    const double surface_height = mesh.plane.height(corner);
    const double missing = (upward ? surface_height + clear : surface_height - clear) - height;
    if (hold < least_hold || (upward ? missing <= 0 : missing >= 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.is_rim_node(nodes[k])) continue;
      const double shift = missing * (*weights)[k] / hold;
      has_moved |= pushes.push(nodes[k], mesh.heights[at(nodes[k])] + shift, upward);
    }
  }
  return has_moved;
}

}  // namespace

int push_nodes(const InterdomainMesh& mesh, const Subdomain& subdomain, const FaceColours& colours,
               const std::vector<SurfaceContact>& contacts,
               std::vector<std::optional<double>>& pushed, const PushOptions& options) {
  TF_CHECK(colours.size() == subdomain.triangles.size());
  Pushes pushes(mesh, options, pushed);
  int moved = 0;
  for (const SurfaceContact& contact : contacts) {
    if (!contact.meets && (contact.is_at_rim || contact.distance >= options.too_near)) continue;
    const bool upward = colours[at(contact.surface_triangle)] == Side::left;
    const double clear = options.corners_to * contact.unit;
    bool has_moved = push_nodes_off_surface(mesh, subdomain, contact, upward, options, pushes);
    has_moved |= push_triangle_off_corners(mesh, subdomain, contact, upward, clear, pushes);
    if (has_moved) ++moved;
  }
  return moved;
}

}  // namespace tetfarm
