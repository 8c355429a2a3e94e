#include "mesh/decompose/intersection_repair.h"

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

struct Push {
  std::int32_t node = -1;
  double height = 0;
};

/// The height that takes the node to `options.to` from the surface triangle, on its own side;
/// nothing when it is there already.
std::optional<Push> push_of_node(const InterdomainMesh& mesh, const Subdomain& subdomain,
                                 std::int32_t node, std::int32_t surface_triangle,
                                 bool surface_is_left, bool is_forced, const PushOptions& options) {
  const auto& [a, b, c] = subdomain.triangles[idx(surface_triangle)];
  const Vec3 p = node_position(mesh, subdomain, node);
  const Closest closest = closest_in_triangle(
      p, subdomain.vertices[idx(a)], subdomain.vertices[idx(b)], subdomain.vertices[idx(c)]);
  const double far = options.to * mesh.spacing[idx(node)];
  const double height = mesh.heights[idx(node)];
  const double surface_height = mesh.plane.height(closest.point);
  const double aside2 =
      std::max(0.0, closest.distance2 - (height - surface_height) * (height - surface_height));
  if (aside2 >= far * far && !is_forced) return std::nullopt;
  const double clear = is_forced ? far : std::sqrt(far * far - aside2);
  const double wanted = surface_is_left ? surface_height + clear : surface_height - clear;
  const bool is_there = surface_is_left ? height >= wanted : height <= wanted;
  if (is_there ||
      std::fabs(wanted) > options.farthest * mesh.spacing[idx(node)] + std::fabs(height)) {
    return std::nullopt;
  }
  return Push{node, wanted};
}

}  // namespace

int push_nodes(const InterdomainMesh& mesh, const Subdomain& subdomain, const FaceColours& colours,
               const std::vector<SurfaceContact>& contacts,
               std::vector<std::optional<double>>& pushed, const PushOptions& options) {
  pushed.resize(mesh.planar.points.size());
  int moved = 0;
  for (const SurfaceContact& contact : contacts) {
    const bool is_pushed =
        contact.meets || (!contact.is_at_rim && contact.distance < options.too_near);
    if (!is_pushed) continue;
    const bool surface_is_left = colours[idx(contact.surface_triangle)] == Side::left;
    bool has_moved = false;
    for (const bool is_forced : {false, true}) {
      if (has_moved || (is_forced && !contact.meets)) continue;
      for (const std::int32_t node : mesh.planar.triangles[idx(contact.cut_triangle)]) {
        if (mesh.is_rim_node(node)) continue;
        const auto push = push_of_node(mesh, subdomain, node, contact.surface_triangle,
                                       surface_is_left, is_forced, options);
        if (!push) continue;
        std::optional<double>& target = pushed[idx(node)];
        if (target) {
          target =
              surface_is_left ? std::max(*target, push->height) : std::min(*target, push->height);
        } else {
          target = push->height;
        }
        has_moved = true;
      }
    }
    if (has_moved) ++moved;
  }
  return moved;
}

}  // namespace tetfarm
