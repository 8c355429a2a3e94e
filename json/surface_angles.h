/// The small angles that a surface forces on every mesh of it, as `check` and `run` tell of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mesh/assemble/forced_dihedral.h"
#include "mesh/inspect/small_angles.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct SurfaceAngles {
  SmallAngles triangles;
  ForcedDihedral forced;
};

SurfaceAngles surface_angles_of(const SurfaceMesh& domain);

/// As the assemble task of a finished job told; nothing measured when it told nothing.
SurfaceAngles surface_angles_of(const wire::JobStatus& status);

/// What a person should know: how many triangles have small angles, where the worst are, what they
/// force, and where to mend the surface. Empty for a good surface.
std::vector<std::string> angle_remarks(const SurfaceAngles& angles);

/// {"smallest_angle_deg":…, "triangles_below_1_deg":…, "triangles_below_5_deg":…,
/// "forced_dihedral_deg":…, "forced_at":[…], "worst":[{"triangle","angle_deg","at","patch"}]}.
nlohmann::ordered_json surface_angles_json(const SurfaceAngles& angles);

}  // namespace tetfarm
