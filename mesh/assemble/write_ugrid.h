/// Writes the global mesh as AFLR3/NASA UGRID, little endian, doubles (.lb8.ugrid), and the names
/// of its patches (.mapbc).
///
/// Source: UG_IO documentation, "UGRID file type". Nodes and patches are numbered from 1; the
/// normals of boundary triangles point into the domain. Counts are 32-bit: that is the format's
/// limit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mesh/assemble/global_mesh.h"

namespace tetfarm {

/// Truncates `path`. The numbers of boundary triangles follow the parts. @throws Error when a count
/// is above 2^31 - 1; IoError, also later from the writer.
std::unique_ptr<GlobalMeshWriter> write_ugrid(const std::filesystem::path& path,
                                              const Numbering& numbering,
                                              std::int64_t boundary_triangles);

/// The text of the .mapbc file: the number of patches, then "NUMBER CODE NAME" each. All get the
/// code 3000 (tangency): what a boundary is, the user has to say.
std::string mapbc_text(const std::vector<std::string>& patch_names);

}  // namespace tetfarm
