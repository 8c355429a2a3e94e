/// How defects and remarks are worded: how many, and where the first few are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// As many places as a message names.
inline constexpr std::size_t places_named = 3;

/// "triangle 7 (0, 0, 0) (1, 0, 0) (0, 1, 0)". @pre its indices are in range.
std::string triangle_text(const SurfaceMesh& surface, std::int32_t triangle);

/// "what: place; place; place; and 5 more" when `count` places exist.
std::string with_places(const std::string& what, const std::vector<std::string>& places,
                        std::size_t count);

/// A defect of whole triangles: names the first few of them. @pre `triangles` is sorted.
SurfaceDefect defect_of_triangles(const SurfaceMesh& surface, const std::string& kind,
                                  const std::string& what,
                                  const std::vector<std::int32_t>& triangles);

/// "the surface cannot be meshed", and a line for each defect.
std::string defects_text(const std::vector<SurfaceDefect>& defects);

}  // namespace tetfarm
