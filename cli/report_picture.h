/// A picture of a mesh for a page about it.
#pragma once

#include <string>

#include "mesh/formats/mesh_source.h"
#include "mesh/render/render_mesh.h"
#include "report/report_page.h"

namespace tetfarm {

/// @throws as render_mesh does. Memory and cost: those of render_mesh.
ReportPicture picture_of(const MeshSource& mesh, const RenderOptions& options,
                         const std::string& caption);

}  // namespace tetfarm
