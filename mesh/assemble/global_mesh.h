/// Brings the portions of the sub-domains together to one mesh, one sub-domain at a time.
///
/// Source: thesis 4.3.4.2.2. In memory at any time: one portion, the input surface, a bit for each
/// node. What the sub-domains share is compared as they pass: each triangle of the surface belongs
/// to one, or, between two regions, to one of each; every other face to two cells, of whatever
/// sub-domains, with the same nodes at the same places (face_balance.h).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "base/hash.h"
#include "mesh/assemble/portion.h"

namespace tetfarm {

/// Reads the portion of that leaf; called once for each leaf, in tree order.
using ReadPortion = std::function<Portion(const LeafNumbers& leaf)>;

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
  ElementCounts others{};  ///< of the other types
  std::int64_t boundary_triangles = 0;
  std::int32_t subdomains = 0;
  double volume = 0;           ///< of the cells
  double enclosed_volume = 0;  ///< of the surface, and of the quads beside layers
  MeshShapes shapes;
  Hash128 digest;  ///< see mesh_digest.h
};

/// Reads all portions, checks how they fit, hands each to the writers, and finishes them. All that
/// can be found out about a portion by itself was when it was made: this runs alone.
/// @pre `surface` and `numbering` belong together.
/// @throws Error when portions do not fit together or not the numbering, or the volumes differ by
/// more than 1e-9; what `read_portion` and the writers throw.
/// Cost: O(n); memory of one portion.
GlobalMeshSummary assemble_global_mesh(const SurfaceMesh& surface, const Numbering& numbering,
                                       const ReadPortion& read_portion,
                                       std::span<GlobalMeshWriter* const> writers);

}  // namespace tetfarm
