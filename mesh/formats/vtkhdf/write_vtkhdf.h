/// Writes the global mesh as VTKHDF (an HDF5 file): an UnstructuredGrid with a partition for each
/// sub-domain, which ParaView and VTK from 9.1 on read.
///
/// Source: VTKHDF file format of VTK's documentation. Version 1.0 is written, which all readers
/// know. The same mesh gives the same bytes. Layout for readers of our own: docs/file_formats.md.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "mesh/assemble/global_mesh.h"
#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

namespace tetfarm {

/// Truncates `path`; a file beside it comes and goes. The parts must come in the order of their
/// numbers. Without names there is one region, "domain". 16 bytes a tet, 12 a triangle, 32 a node.
/// @throws IoError, also later from the writer; Error when a part has other counts.
std::unique_ptr<GlobalMeshWriter> write_vtkhdf(const std::filesystem::path& path,
                                               std::span<const VtkhdfCounts> parts,
                                               const VtkhdfNames& names);

}  // namespace tetfarm
