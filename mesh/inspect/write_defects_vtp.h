/// The triangles of all defects as a file to look at.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// Writes the triangles of all defects, with the defect's number (`defect`, its index in `defects`)
/// and the input's triangle number (`triangle`) on each, as a .vtp (XML PolyData, ASCII) file that
/// ParaView opens. A triangle with two defects is written twice. Triangles without finite corners
/// are left out.
/// @throws IoError.
void write_defects_vtp(const SurfaceMesh& surface, const std::vector<SurfaceDefect>& defects,
                       const std::string& path);

}  // namespace tetfarm
