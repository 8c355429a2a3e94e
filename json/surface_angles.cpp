#include "json/surface_angles.h"

#include <array>
#include <nlohmann/json.hpp>

#include "base/angle_text.h"
#include "json/reply_values.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

/// A dihedral angle that the surface forces is worth a remark below this.
constexpr double worth_saying_deg = 20;

Vec3 point_of(const wire::JobStatus& status, const std::string& what) {
  const std::array<double, 3> place = place_of(status, what);
  return {place[0], place[1], place[2]};
}

std::string patch_text(const std::string& patch) {
  return patch.empty() ? "" : ", patch \"" + patch + "\"";
}

}  // namespace

SurfaceAngles surface_angles_of(const SurfaceMesh& domain) {
  return {small_angles(domain), forced_dihedral(domain)};
}

SurfaceAngles surface_angles_of(const wire::JobStatus& status) {
  SurfaceAngles angles;
  if (!status.numbers().contains("surface_triangles")) return angles;
  const auto count = [&status](const char* name) {
    return static_cast<std::int64_t>(number_of(status, name));
  };
  angles.forced = {number_of(status, "forced_dihedral_deg"), point_of(status, "forced")};
  SmallAngles& triangles = angles.triangles;
  triangles.triangles = count("surface_triangles");
  triangles.smallest_deg = number_of(status, "surface_smallest_angle_deg");
  triangles.below_1_deg = count("surface_triangles_below_1_deg");
  triangles.below_5_deg = count("surface_triangles_below_5_deg");
  for (std::size_t i = 1; i <= worst_kept; ++i) {
    const std::string which = "surface_worst_" + std::to_string(i);
    if (!status.numbers().contains(which + "_triangle")) break;
    const auto patch = status.texts().find(which + "_patch");
    triangles.worst.push_back({static_cast<std::int64_t>(number_of(status, which + "_triangle")),
                               number_of(status, which + "_angle_deg"), point_of(status, which),
                               patch == status.texts().end() ? "" : patch->second});
  }
  return angles;
}

std::vector<std::string> angle_remarks(const SurfaceAngles& angles) {
  std::vector<std::string> remarks;
  const SmallAngles& triangles = angles.triangles;
  if (triangles.below_5_deg > 0) remarks.push_back(small_angles_text(triangles));
  if (!triangles.worst.empty()) {
    const SmallAngle& worst = triangles.worst.front();
    remarks.push_back("faces of the mesh have angles down to " + angle_text(worst.angle_deg) +
                      " deg, as they are the surface's own triangles; for better elements, remesh "
                      "the surface near " +
                      text_of(worst.at) + patch_text(worst.patch));
  }
  if (angles.forced.at_most_deg < worth_saying_deg) {
    remarks.push_back("the edge between two triangles forces a dihedral angle of " +
                      angle_text(angles.forced.at_most_deg) + " deg or less near " +
                      text_of(angles.forced.at));
  }
  return remarks;
}

nlohmann::ordered_json surface_angles_json(const SurfaceAngles& angles) {
  nlohmann::ordered_json json = {
      {"smallest_angle_deg", angles.triangles.smallest_deg},
      {"triangles_below_1_deg", angles.triangles.below_1_deg},
      {"triangles_below_5_deg", angles.triangles.below_5_deg},
      {"forced_dihedral_deg", angles.forced.at_most_deg},
      {"forced_at", {angles.forced.at.x, angles.forced.at.y, angles.forced.at.z}},
      {"worst", nlohmann::ordered_json::array()}};
  for (const SmallAngle& worst : angles.triangles.worst) {
    json["worst"].push_back({{"triangle", worst.triangle},
                             {"angle_deg", worst.angle_deg},
                             {"at", {worst.at.x, worst.at.y, worst.at.z}},
                             {"patch", worst.patch}});
  }
  return json;
}

}  // namespace tetfarm
