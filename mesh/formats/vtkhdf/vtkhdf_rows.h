/// Writes what a partition has of the arrays in one piece of a VTKHDF file to its places there.
#pragma once

#include <vector>

#include "mesh/assemble/file_range.h"
#include "mesh/assemble/output_file.h"
#include "mesh/assemble/portion.h"
#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

namespace tetfarm {

/// The nodes and the marks of cells. Returns what was written, in the order of the file; without a
/// file, what would be. @throws IoError. Cost: O(n), 16 bytes a tet and 4 for each mark; constant
/// memory.
std::vector<FileRange> write_vtkhdf_cells(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                                          const NumberedPart& part, OutputFile* file);

/// The arrays of points.
void write_vtkhdf_points(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                         const NumberedPart& part, OutputFile& file);

}  // namespace tetfarm
