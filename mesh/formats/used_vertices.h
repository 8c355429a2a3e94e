/// The surface in a file of a volume mesh: its nodes are few among many.
#pragma once

#include <string_view>

#include "mesh/core/surface_mesh.h"
#include "mesh/formats/input_scanner.h"

namespace tetfarm {

/// Drops the vertices that no triangle uses; the others keep their order.
void keep_used_vertices(SurfaceMesh& surface);

/// The vertex with that number, counted from `from`. Fails in the scanner when there is none.
std::int32_t vertex_of(const InputScanner& scanner, const SurfaceMesh& surface, std::int64_t number,
                       std::int64_t from);

}  // namespace tetfarm
