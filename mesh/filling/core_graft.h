/// Puts the lattice core's tets into a complex that was made without the core nodes.
///
/// A Delaunay tet whose nodes are all kept stays Delaunay when other points are left out. So a
/// complex of all points but the core nodes holds the faces of the core's hull, and within them
/// tets that merely fill the hollow. These go, and the core takes their place. Where constraints or
/// recovery left the complex other than Delaunay a face may be missing: that is found out first.
/// Cost: O(tets of the complex + tets of the core).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/tet_complex.h"
#include "mesh/filling/lattice_core.h"

namespace tetfarm {

enum class FaceOfSeat : std::uint8_t { missing, free, constrained };

/// Where the core goes.
struct CoreSeat {
  /// For each face of the core's hull the face of the complex that it will touch; no_face on the
  /// boundary of a complex without outside.
  std::vector<FaceHandle> outer;
  /// For each face of the hull: whether the complex holds it, and with which constraint.
  std::vector<FaceOfSeat> faces;
  /// The tets within the hull.
  std::vector<std::int32_t> filling;
  /// Every hull face is there, and the filling has nodes of the hull only and no constrained faces
  /// but those of the hull, where the core ends at a cut.
  bool fits = false;
};

/// `node_numbers` are those in the complex of the lattice nodes, by which the core names its nodes;
/// those of core nodes do not matter.
CoreSeat find_core_seat(const TetComplex& complex, const std::vector<std::uint8_t>& constrained,
                        const LatticeCore& core, std::span<const std::int32_t> node_numbers);

/// Replaces the filling by the core. @pre seat.fits, for this complex; the points of all nodes of
/// the core are in the complex. Afterwards the complex is valid again.
void graft_core(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                const LatticeCore& core, std::span<const std::int32_t> node_numbers,
                const CoreSeat& seat);

}  // namespace tetfarm
