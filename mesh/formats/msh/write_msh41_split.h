/// Writes a mesh as Gmsh MSH 4.1, binary, a file for each sub-domain, as Gmsh's own partitioned
/// meshes are.
///
/// Source: Gmsh reference manual, "MSH file format"; where the ghosts are: what Gmsh 4.8 writes.
#pragma once

#include <filesystem>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// NAME_1.msh, NAME_2.msh, … for NAME.msh: each sub-domain as a partition ($PartitionedEntities),
/// with the numbers that nodes and elements have in the whole mesh.
/// @throws Error when there are more entities than numbers; IoError, what the source throws. Reads
/// each part once; memory of one part.
void write_msh41_split(const MeshSource& source, const MeshOutline& outline,
                       const std::filesystem::path& file);

/// The same, and as ghosts the cells of other partitions that have a node of this one, as an entity
/// of their own ($GhostElements). Gmsh 4.8 merges files without ghosts into one mesh, but ends when
/// it merges files with them, its own too.
/// @throws as above. Reads each part four times; memory of one part and its ghosts.
void write_msh41_ghosts(const MeshSource& source, const MeshOutline& outline,
                        const std::filesystem::path& file);

}  // namespace tetfarm
