#include "mesh/layers/marching_direction.h"

#include <algorithm>
#include <vector>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr double rounding = 1e-10;

/// A cone by its axis; all normals with at least the cosine are in it.
struct Cone {
  Vec3 axis;
  double cosine = 1;

  bool holds(const Vec3& normal) const { return dot(axis, normal) >= cosine - rounding; }
};

Cone cone_of_two(const Vec3& a, const Vec3& b) {
  const Vec3 axis = normalized(a + b);
  return {axis, dot(axis, a)};
}

/// The cone on whose side all three are; of two the one that has them in front.
Cone cone_of_three(const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 axis = normalized(cross(b - a, c - a));
  if (dot(axis, a) < 0) axis = -axis;
  return {axis, dot(axis, a)};
}

/// The smallest cone of the first `count` normals that has both of these on its side.
Cone cone_on_two(std::span<const Vec3> normals, const Vec3& a, const Vec3& b) {
  Cone cone = cone_of_two(a, b);
  for (const Vec3& normal : normals) {
    if (!cone.holds(normal)) cone = cone_of_three(a, b, normal);
  }
  return cone;
}

Cone cone_on_one(std::span<const Vec3> normals, const Vec3& a) {
  Cone cone{a, 1};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!cone.holds(normals[i])) cone = cone_on_two(normals.first(i), a, normals[i]);
  }
  return cone;
}

Cone cone_of(std::span<const Vec3> normals) {
  Cone cone{normals.front(), 1};
  for (std::size_t i = 1; i < normals.size(); ++i) {
    if (!cone.holds(normals[i])) cone = cone_on_one(normals.first(i), normals[i]);
  }
  return cone;
}

/// Normals of one flat face in several triangles differ by rounding; three of them have no cone.
std::vector<Vec3> different_normals(std::span<const Vec3> normals) {
  constexpr double same = 1e-5;
  std::vector<Vec3> different;
  for (const Vec3& normal : normals) {
    const bool is_known = std::any_of(different.begin(), different.end(), [&](const Vec3& other) {
      return distance(other, normal) < same;
    });
    if (!is_known) different.push_back(normal);
  }
  return different;
}

}  // namespace

double visibility(const Vec3& direction, std::span<const Vec3> normals) {
  double least = 1;
  for (const Vec3& normal : normals) least = std::min(least, dot(direction, normal));
  return least;
}

MarchingDirection marching_direction(std::span<const Vec3> normals) {
  TF_CHECK(!normals.empty());
  const Cone cone = cone_of(different_normals(normals));
  const MarchingDirection best{cone.axis, visibility(cone.axis, normals)};
  if (!(best.visibility > rounding)) return {};
  return best;
}

}  // namespace tetfarm
