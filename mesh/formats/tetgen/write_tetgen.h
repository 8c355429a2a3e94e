/// Writes a mesh as TetGen does: NAME.node, NAME.face and NAME.ele, text, numbered from 0.
///
/// Source: TetGen's manual, "File formats". A face's mark is its patch from 1, a tetrahedron's
/// attribute its region; the formats have no names.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// `file` is NAME.node, NAME.ele or NAME.face; all three are written. @throws IoError, what the
/// source throws. One pass; memory of one part.
void write_tetgen(const MeshSource& source, const MeshOutline& outline,
                  const std::filesystem::path& file);

}  // namespace tetfarm
