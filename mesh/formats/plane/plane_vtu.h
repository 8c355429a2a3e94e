/// Meshes of the plane with fields at their nodes as VTK XML (.vtu), text, for ParaView.
///
/// Source: VTK file formats, "XML file formats", UnstructuredGrid. Cells are the triangles and,
/// behind them, the edges as lines. Their arrays are `region` (-1 for lines) and `patch` (-1 for
/// triangles).
#pragma once

#include <filesystem>

#include "mesh/formats/plane/plane_medit.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Fields become the point arrays number_1, number_2, …, vector_1, … (with z = 0) and metric_1, …
/// (xx, yy, zz, xy, yz, xz with 1 for zz). @pre each field has a value for each point.
/// @throws IoError.
void write_plane_vtu(const PlaneMesh& mesh, const NodeFields& fields,
                     const std::filesystem::path& path);

}  // namespace tetfarm
