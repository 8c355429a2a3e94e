#include "mesh/volume/kernel_point.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

struct Plane {
  Vec3 normal;  // unit, towards the visible side
  Vec3 point;
};

/// The smallest signed distance, and the plane that has it.
struct Depth {
  double value;
  std::size_t plane;
};

Depth depth_at(const std::vector<Plane>& planes, const Vec3& x) {
  Depth depth{HUGE_VAL, 0};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double distance = dot(planes[i].normal, x - planes[i].point);
    if (distance < depth.value) depth = {distance, i};
  }
  return depth;
}

double next_random(std::uint64_t& state) {
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<double>(state >> 11) / 4503599627370496.0 - 1.0;
}

}  // namespace

std::optional<Vec3> kernel_point(std::span<const VisibleFace> faces, const Vec3& start,
                                 double size) {
  std::vector<Plane> planes;
  for (const auto& [a, b, c] : faces) {
    const Vec3 normal = normalized(cross(b - a, c - a));
    if (norm2(normal) > 0) planes.push_back({normal, a});
  }
  if (planes.empty()) return std::nullopt;
  Vec3 best = start;
  Depth depth = depth_at(planes, best);
  double step = size;
  std::uint64_t state = 1;
  constexpr int tries = 400;
  for (int i = 0; i < tries && step > 1e-14 * size; ++i) {
    // Away from the nearest plane, mixed with a direction by chance.
    Vec3 direction = {next_random(state), next_random(state), next_random(state)};
    direction = normalized(planes[depth.plane].normal + (i % 4 == 0 ? 0.0 : 1.0) * direction);
    bool is_better = false;
    for (double length = 4 * step; length > step / 64; length /= 2) {
      const Vec3 moved = best + length * direction;
      const Depth there = depth_at(planes, moved);
      if (there.value <= depth.value) continue;
      best = moved;
      depth = there;
      step = length;
      is_better = true;
      break;
    }
    if (!is_better && i % 4 == 3) step /= 2;
  }
  const bool is_visible = std::all_of(faces.begin(), faces.end(), [&best](const VisibleFace& f) {
    return orient3d(f[0], f[1], f[2], best) > 0;
  });
  if (!is_visible) return std::nullopt;
  return best;
}

}  // namespace tetfarm
