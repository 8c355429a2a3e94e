#include "mesh/cosmetics/climbing.h"

#include "base/check.h"

namespace tetfarm::cosmetics {

Vec3 shortest_in_hull(std::span<const Vec3> vectors) {
  TF_CHECK(!vectors.empty());
  Vec3 now = vectors[0];
  for (int i = 0; i < 24; ++i) {
    const Vec3* nearest = nullptr;
    double least = HUGE_VAL;
    for (const Vec3& vector : vectors) {
      const double along = dot(vector, now);
      if (nearest != nullptr && !(along < least)) continue;
      nearest = &vector;
      least = along;
    }
    const Vec3 towards = *nearest - now;
    const double gain = -dot(now, towards);
    if (gain <= 1e-3 * norm2(now)) break;
    now += std::min(1.0, gain / norm2(towards)) * towards;
  }
  return now;
}

double shortest_distance2(const Star& star, const Vec3& p) {
  double shortest = HUGE_VAL;
  for (const StarFace& face : star) {
    for (const Vec3& corner : face) shortest = std::min(shortest, norm2(corner - p));
  }
  return shortest;
}

}  // namespace tetfarm::cosmetics
