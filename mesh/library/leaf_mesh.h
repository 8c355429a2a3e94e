/// The volume mesh of a leaf of the decomposition tree, with a second way for a leaf whose boundary
/// cannot be recovered: cut it once more by a plane, mesh the halves, and join them.
///
/// The nodes of that last cut become interior nodes, so that nothing outside the leaf knows of it.
#pragma once

#include <functional>

#include "mesh/decompose/planar_cut.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {

/// How a sub-domain is meshed and cut: the mesh rooms, or a test's own.
struct LeafMeshers {
  std::function<VolumeOutcome(const Subdomain&)> mesh;
  std::function<CutOutcome(const Subdomain&)> cut;
};

/// The mesh rooms as meshers: a cut counts when the boundaries of both halves are recovered.
/// @pre `spacing` outlives the result.
LeafMeshers leaf_meshers(const SpacingField& spacing, const VolumeMeshOptions& meshing,
                         CutOptions cutting);

/// A mesh that satisfies the invariants of TetMesh for `leaf`, or why the whole leaf has none when
/// neither way works. The second way is for a boundary that was not recovered only.
VolumeOutcome leaf_mesh(const Subdomain& leaf, const LeafMeshers& meshers);

/// The meshes of the two halves as one of `whole`: its nodes first, then the cut's, then the
/// halves' inner ones.
/// @pre left and right are the halves of `whole`, meshed.
TetMesh join_halves(const Subdomain& whole, const Subdomain& left, const TetMesh& left_mesh,
                    const Subdomain& right, const TetMesh& right_mesh);

}  // namespace tetfarm
