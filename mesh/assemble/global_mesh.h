/// Brings the meshes of the sub-domains together to one mesh, one sub-domain at a time.
///
/// Source: thesis 4.3.4.2.2. In memory at any time: one sub-domain with its mesh, the input
/// surface, a bit for each node. What the sub-domains share is compared as they pass: each triangle
/// of the surface belongs to one, or, between two regions, to one of each; every other face to two
/// tets, of whatever sub-domains, with the same three nodes at the same places (face_balance.h).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/hash.h"
#include "mesh/assemble/global_numbering.h"
#include "mesh/assemble/mesh_shapes.h"
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
};

/// Of each vertex of a sub-domain as it was cut, whether it is on a triangle of a cut.
std::vector<bool> nodes_on_cuts(const Subdomain& subdomain);

/// Reads the leaf of that path; called once for each leaf, in tree order.
using ReadPart = std::function<MeshPart(const LeafNumbers& leaf)>;

/// A part with its global numbers: what is written and hashed. Faces are the triangles of the input
/// surface that the part has, normals out of the part's region.
struct NumberedPart {
  std::int32_t number = 0;  ///< of the sub-domain, from 0 in tree order
  std::int32_t region = 1;
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;        ///< local node numbers
  std::vector<Triangle> faces;  ///< local node numbers
  std::vector<std::int32_t> patch_of_face;
  std::vector<std::int64_t> local2global;
};

/// Receives the parts in tree order: a file format. `finish` makes the file durable and complete;
/// a writer that is destroyed without it leaves a file that readers refuse, or none.
class GlobalMeshWriter {
 public:
  virtual ~GlobalMeshWriter() = default;
  virtual void add(const NumberedPart& part) = 0;
  virtual void finish() = 0;
};

/// What is known of the mesh when all parts have passed. Triangles between two regions count twice.
struct GlobalMeshSummary {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::int32_t subdomains = 0;
  double volume = 0;           ///< of the tets
  double enclosed_volume = 0;  ///< of the surface
  MeshShapes shapes;
  Hash128 digest;  ///< see mesh_digest.h
};

/// Reads all parts, checks how they fit, hands each to the writers, and finishes them.
/// @pre `surface` and `numbering` belong together.
/// @throws Error when parts do not fit together or not the numbering, or the volumes differ by more
/// than 1e-9; what `read_part` and the writers throw.
/// Cost: O(n); memory of one part.
GlobalMeshSummary assemble_global_mesh(const SurfaceMesh& surface, const Numbering& numbering,
                                       const ReadPart& read_part,
                                       std::span<GlobalMeshWriter* const> writers);

}  // namespace tetfarm
