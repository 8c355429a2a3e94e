/// Reads the triangles that vtp_text writes, with the numbers on them.
///
/// Source: VTK's documentation, "VTK XML formats"; of these what vtp_text makes: one piece of
/// triangles, all arrays as text.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

struct NumberedTriangles {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::map<std::string, std::vector<double>> arrays;  ///< a number of each triangle
};

/// @param name of the file, for messages.
/// @throws InvalidInput for anything but such a text; corners are points that there are.
/// Cost: O(bytes).
NumberedTriangles triangles_from_vtp(std::string_view text, const std::string& name);

}  // namespace tetfarm
