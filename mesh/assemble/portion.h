/// What one sub-domain is of the global mesh: its elements with their global numbers, and the
/// figures and sums of them that the whole needs. Portions are made one by one, in any order, by
/// whoever has time; what is left for assembling is to put them in a row.
///
/// Source: thesis 4.3.4.2.2; that the leaves do it side by side is not the thesis's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/file_range.h"
#include "mesh/assemble/leaf_numbering.h"
#include "mesh/assemble/mesh_digest.h"
#include "mesh/assemble/mesh_shapes.h"
#include "mesh/core/cell_marks.h"
#include "mesh/core/element_block.h"
#include "mesh/core/node_feet.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {

/// A leaf of the tree as the tasks published it. After cosmetics across cuts its cuts are not those
/// of the decomposition any more, and its nodes may come from anywhere: then all nodes are vertices
/// of `subdomain`, with their origins, and its triangles are those of the surface alone.
struct MeshPart {
  Subdomain subdomain;
  TetMesh mesh;
  std::vector<bool> is_on_cut;  ///< of the first nodes, or of none: for the figures near cuts
  ElementBlocks blocks;         ///< of layers, by the numbers of the mesh's nodes
  CellMarks marks;              ///< of those and of the tets
  NodeFeet feet;                ///< by the numbers of the mesh's nodes
  /// Its tets are as flat as layers are: they have no part in the figures of shape.
  bool is_of_layers = false;
};

/// Of each vertex of a sub-domain as it was cut, whether it is on a triangle of a cut.
std::vector<bool> nodes_on_cuts(const Subdomain& subdomain);

/// A part with its global numbers: what is written and hashed. Faces are the triangles of the input
/// surface that the part has, normals out of the part's region. Layers, and what was read, may have
/// other elements besides, and boundary quads.
struct NumberedPart {
  std::int32_t number = 0;  ///< of the sub-domain, from 0 in tree order
  std::int32_t region = 1;  ///< of all of it, but where the next two are not empty
  /// Of a part that was put together from sub-domains of several regions: of each tet, ascending,
  /// and of each face. Parts as they were meshed lie in one region.
  std::vector<std::int32_t> region_of_tet;
  std::vector<std::int32_t> region_of_face;
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;        ///< local node numbers
  std::vector<Triangle> faces;  ///< local node numbers
  std::vector<std::int32_t> patch_of_face;
  ElementBlocks blocks;  ///< the other elements; cells of a type by region, as tets are
  CellMarks marks;       ///< known where layers are grown, and where a file has them
  std::vector<std::int64_t> local2global;
  NodeFeet feet;  ///< by numbers in the whole mesh; known as marks are

  std::int32_t region_of(std::size_t tet) const {
    return region_of_tet.empty() ? region : region_of_tet[tet];
  }
  std::int32_t region_of_boundary(std::size_t face) const {
    return region_of_face.empty() ? region : region_of_face[face];
  }
};

/// A part whose elements are counted: `tets` and `faces` of the part itself may be empty, and so
/// may the nodes of its blocks.
struct CountedPart {
  NumberedPart part;
  std::int64_t tets = 0;
  std::int64_t faces = 0;
};

/// Of each cell: tets, then each type of block.
std::vector<std::int32_t> regions_of_cells(const NumberedPart& part);
/// Of each boundary face: triangles, then quads.
std::vector<std::int32_t> regions_of_boundary(const NumberedPart& part);
/// How many they are.
std::int64_t cells_of(const NumberedPart& part);
std::int64_t boundary_faces_of(const NumberedPart& part);

/// Its cells may be apart, in a file of their own: then `part` has none.
struct Portion {
  NumberedPart part;
  std::int64_t tets = 0;
  ElementCounts others{};                        ///< of the types in blocks
  std::vector<std::uint32_t> surface_triangles;  ///< of the input, that the faces are
  MeshShapes shapes;
  std::uint64_t face_sum = 0;  ///< see face_balance.h
  MeshDigest::Sum tet_digest;
  MeshDigest::Sum other_digest;  ///< of cells and faces of the types in blocks
  /// Where the cells lie already in a VTKHDF file of the whole mesh (shared_vtkhdf.h), if they do.
  std::vector<FileRange> placed;
};

/// Vertices and triangles of the surface that the part has, in the order of its own.
WantedPieces surface_pieces(const Subdomain& subdomain);

/// Numbers the leaf, and takes its figures. Its nodes of the surface lie where the surface has
/// them, and its triangles of the surface have the nodes that they have there.
/// @pre `surface` is what the surface has as the part's surface_pieces, and `numbering` the answer
/// for its node_origin.
/// @throws Error when the part does not fit to them. Cost: O(n) for n elements and nodes of the
/// part; memory of the part twice.
Portion make_portion(MeshPart part, const SurfacePieces& surface, const LeafNumbering& numbering);

/// Counts the elements of a portion that is whole but for its figures and sums, and takes those.
/// `first` is the number of its first cell of each type; `is_on_cut` tells it of each node, for the
/// figures near cuts.
/// @pre all elements are here, and of the part's own region. Cost: O(n).
void take_figures(const std::vector<bool>& is_on_cut, const ElementCounts& first, Portion& portion);

/// What a portion has, as its first bytes tell.
struct PortionCounts {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t faces = 0;
  ElementCounts others{};
  bool has_feet = false;  ///< as those of chunks of layers
};

/// Of a file of a portion; nothing but its head is read, and no checksum.
/// @throws IoError, CorruptFile naming `name`.
PortionCounts portion_counts(const std::filesystem::path& path, const std::string& name);

/// All but the cells. The grammar is in store/formats.md.
std::string portion_to_bytes(const Portion& portion);
/// @throws CorruptFile naming `name`, also when a local number is that of no node.
Portion portion_from_bytes(std::string_view bytes, const std::string& name);

std::string portion_cells_to_bytes(const Portion& portion);
/// Adds the cells to their portion. @throws CorruptFile naming `name`, also when they are of
/// another.
void add_portion_cells(std::string_view bytes, const std::string& name, Portion& portion);

}  // namespace tetfarm
