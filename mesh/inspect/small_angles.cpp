#include "mesh/inspect/small_angles.h"

#include <algorithm>

#include "base/angle_text.h"
#include "mesh/core/complaints.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

constexpr double small_deg = 5;
constexpr double very_small_deg = 1;
constexpr std::size_t longest_name = 60;

Vec3 middle_of_shortest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = distance(a, b);
  const double bc = distance(b, c);
  const double ca = distance(c, a);
  if (ab <= bc && ab <= ca) return 0.5 * (a + b);
  return bc <= ca ? 0.5 * (b + c) : 0.5 * (c + a);
}

/// As messages may show it: the surface comes from a stranger.
std::string shown_patch(const SurfaceMesh& surface, std::size_t triangle) {
  if (triangle >= surface.patch_of_triangle.size()) return {};
  const auto patch = static_cast<std::size_t>(surface.patch_of_triangle[triangle]);
  if (patch >= surface.patch_names.size()) return {};
  std::string name = surface.patch_names[patch].substr(0, longest_name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return name;
}

/// Keeps it when it is among the worst.
void take(SmallAngle found, std::vector<SmallAngle>& worst) {
  const auto place = std::upper_bound(
      worst.begin(), worst.end(), found,
      [](const SmallAngle& a, const SmallAngle& b) { return a.angle_deg < b.angle_deg; });
  worst.insert(place, std::move(found));
  if (worst.size() > worst_kept) worst.pop_back();
}

std::string text_of_one(const SmallAngle& angle) {
  std::string text = "triangle " + std::to_string(angle.triangle) + " with " +
                     angle_text(angle.angle_deg) + " deg near " + text_of(angle.at);
  if (!angle.patch.empty()) text += " in patch \"" + angle.patch + "\"";
  return text;
}

}  // namespace

SmallAngles small_angles(const SurfaceMesh& surface, const std::vector<bool>& left_out) {
  const auto at = [&surface](std::int32_t v) -> const Vec3& {
    return surface.vertices[static_cast<std::size_t>(v)];
  };
  SmallAngles result;
  result.triangles = std::ssize(surface.triangles);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!left_out.empty() && left_out[t]) continue;
    const auto& [u, v, w] = surface.triangles[t];
    const double angle = smallest_angle_deg(at(u), at(v), at(w));
    result.smallest_deg = std::min(result.smallest_deg, angle);
    if (angle >= small_deg) continue;
    ++result.below_5_deg;
    if (angle < very_small_deg) ++result.below_1_deg;
    if (result.worst.size() == worst_kept && angle >= result.worst.back().angle_deg) continue;
    take({static_cast<std::int64_t>(t), angle, middle_of_shortest_edge(at(u), at(v), at(w)),
          shown_patch(surface, t)},
         result.worst);
  }
  return result;
}

std::string small_angles_text(const SmallAngles& angles) {
  if (angles.below_5_deg == 0) return {};
  std::string text = std::to_string(angles.below_5_deg) + " of " +
                     std::to_string(angles.triangles) + " triangles have an angle below 5 deg";
  if (angles.below_1_deg > 0) {
    text += ", " + std::to_string(angles.below_1_deg) + " of them below 1 deg";
  }
  std::vector<std::string> places;
  for (const SmallAngle& angle : angles.worst) places.push_back(text_of_one(angle));
  return with_places(text + "; the smallest", places, places.size());
}

}  // namespace tetfarm
