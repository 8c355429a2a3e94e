/// Writes a mesh as VTK XML: a piece for each sub-domain (.vtu, raw appended data, 64-bit sizes and
/// numbers) and the file that names them (.pvtu).
///
/// Source: VTK's file formats, "XML formats". Pieces and arrays are those of the partitions of
/// VTKHDF (docs/file_formats.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Where the arrays of a piece lie in its appended data: points, their numbers, their feet and
/// depths if there are any, connectivity, offsets, types, sub-domain, region, patch, marks of
/// cells.
struct VtuLayout {
  struct Place {
    std::int64_t offset = 0;  ///< of the array's length, which comes before it
    std::int64_t bytes = 0;   ///< of the array
  };
  static constexpr std::int64_t length_bytes = 8;
  std::vector<Place> arrays;
  std::int64_t bytes = 0;  ///< of all
};
/// `cell_nodes`: how many the cells have, each for itself.
VtuLayout vtu_layout(std::int64_t points, std::int64_t cells, std::int64_t cell_nodes,
                     std::size_t marks = 0, bool has_feet = false);

/// NAME.pvtu, and NAME/NAME_0.vtu … in a folder beside it, which is made. @throws IoError, what the
/// source throws. One pass; memory of one part.
void write_pvtu(const MeshSource& source, const MeshOutline& outline,
                const std::filesystem::path& file);

}  // namespace tetfarm
