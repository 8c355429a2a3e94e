#include "mesh/recovery/kernel_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/recovery/chebyshev_centre.h"

namespace tetfarm {
namespace {

struct Plane {
  FineVec3 normal;  // unit
  const VisibleFace* face;
  DoubleDouble length;  // of the normal before it was made a unit
};

/// From fine differences: corners may be nearer to each other, or to one line, than doubles tell.
std::vector<Plane> planes_of(std::span<const VisibleFace> faces) {
  std::vector<Plane> planes;
  for (const VisibleFace& face : faces) {
    const auto& [a, b, c] = face;
    const FineVec3 normal = cross(difference(a, b), difference(a, c));
    const DoubleDouble length{norm(normal.rounded()), 0};
    if (length.high > 0) planes.push_back({DoubleDouble{1, 0} / length * normal, &face, length});
  }
  return planes;
}

/// Distances have the size of the exact predicate, which is right to the last digits also where
/// `origin` nearly lies on the planes.
std::vector<HalfSpace> half_spaces(const std::vector<Plane>& planes, const FinePoint& origin) {
  std::vector<HalfSpace> result;
  for (const auto& [normal, face, length] : planes) {
    const auto& [a, b, c] = *face;
    const double size = orient3d(a, b, c, origin);
    DoubleDouble offset = fine_orient3d(a, b, c, origin);
    if (std::abs(offset.high - size) > 1e-12 * std::abs(size)) offset = {size, 0};
    result.push_back({normal, offset / length});
  }
  return result;
}

}  // namespace

bool sees_all(std::span<const VisibleFace> faces, const FinePoint& x) {
  return std::all_of(faces.begin(), faces.end(), [&x](const VisibleFace& face) {
    return orient3d(face[0], face[1], face[2], x) > 0;
  });
}

double room_at(std::span<const VisibleFace> faces, const FinePoint& x) {
  double room = HUGE_VAL;
  for (const auto& [normal, offset] : half_spaces(planes_of(faces), x)) {
    room = std::min(room, offset.high);
  }
  return room;
}

std::optional<FinePoint> kernel_point(std::span<const VisibleFace> faces, const FinePoint& start) {
  double reach = 0;
  for (const VisibleFace& face : faces) {
    for (const FinePoint& p : face) reach = std::max(reach, norm(difference(p, start).rounded()));
  }
  const auto planes = planes_of(faces);
  FinePoint place = start;
  // Each time nearer, so that rounding has less and less to say; then in finer numbers.
  constexpr int plain_tries = 4;
  constexpr int tries = 8;
  const double farthest = reach;
  for (int i = 0; i < tries && reach > 0; ++i) {
    const bool is_plain = i < plain_tries;
    if (i == plain_tries) {
      place = start;
      reach = farthest;
    }
    const auto planes_here = half_spaces(planes, place);
    const FineVec3 step = is_plain ? fine_vector(chebyshev_centre(planes_here, reach))
                                   : fine_chebyshev_centre(planes_here, reach);
    place = moved(place, step);
    if (sees_all(faces, place)) return place;
    reach = std::min(0.1 * reach, 4 * norm(step.rounded()));
  }
  return std::nullopt;
}

}  // namespace tetfarm
