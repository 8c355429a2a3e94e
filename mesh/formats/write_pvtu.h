/// Writes a mesh as VTK XML: a piece for each sub-domain (.vtu, raw appended data, 64-bit sizes and
/// numbers) and the file that names them (.pvtu).
///
/// Source: VTK's file formats, "XML formats". Pieces and arrays are those of the partitions of
/// VTKHDF (docs/file_formats.md).
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// NAME.pvtu, and NAME/NAME_0.vtu … in a folder beside it, which is made. @throws IoError, what the
/// source throws. One pass; memory of one part.
void write_pvtu(const MeshSource& source, const MeshOutline& outline,
                const std::filesystem::path& file);

}  // namespace tetfarm
